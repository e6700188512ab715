using System.Collections.Generic;

namespace Rill
{
    static class SnapshotContentsExtensions
    {
        /// <summary>Sets a section to records; without records the section is left out.</summary>
        public static void SetIfAny<T>(this SnapshotContents contents, SnapshotSection section, List<T> records) where T : struct
        {
            if (records.Count > 0)
                contents.SetValues<T>(section, records.ToArray());
        }
    }
}
