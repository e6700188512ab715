using System;
using System.Collections.Generic;
using UnityEditor;
using static System.FormattableString;

namespace Rill.Editor
{
    /// <summary>GPU memory of a simulation's buffers, the largest first.</summary>
    static class MemoryRows
    {
        public readonly struct Row
        {
            public readonly string Label;
            public readonly long Bytes;
            /// <summary>Fraction of the largest.</summary>
            public readonly float Fraction;

            public Row(string label, long bytes, float fraction)
            {
                Label = label;
                Bytes = bytes;
                Fraction = fraction;
            }
        }

        /// <param name="rows">Taken again.</param>
        public static void List(List<StageDescription> stages, List<Row> rows)
        {
            rows.Clear();
            long largest = 1;
            foreach (StageDescription stage in stages)
                foreach ((string name, long bytes) in stage.Buffers)
                    largest = Math.Max(largest, bytes);
            foreach (StageDescription stage in stages)
                foreach ((string name, long bytes) in stage.Buffers)
                    rows.Add(new Row(name.StartsWith("Rill.", StringComparison.Ordinal) ? name.Substring(5) : name, bytes, bytes / (float)largest));
            rows.Sort((a, b) => a.Bytes != b.Bytes ? b.Bytes.CompareTo(a.Bytes) : string.CompareOrdinal(a.Label, b.Label));
        }

        /// <param name="capacity">Most particles.</param>
        public static string Text(long bytes, int capacity)
            => Invariant($"{EditorUtility.FormatBytes(bytes)}, {bytes / (double)capacity:0} bytes a particle of capacity");

        public static long Total(List<Row> rows)
        {
            long total = 0;
            foreach (Row row in rows)
                total += row.Bytes;
            return total;
        }
    }
}
