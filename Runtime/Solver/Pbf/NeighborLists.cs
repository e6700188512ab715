using System;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>The neighbor lists of NeighborList.hlsl: one buffer, or two where one would pass the device's limit.</summary>
    sealed class NeighborLists : IDisposable
    {
        /// <summary>Keyword of the kernels that read two list buffers.</summary>
        public const string TwoListsKeyword = "RILL_TWO_LISTS";

        /// <summary>Entries of a block; capacities are multiples of it.</summary>
        [GenerateHlsl("NeighborList")] public const int BlockEntries = 4;

        readonly BufferSet buffers = new BufferSet();
        readonly GraphicsBuffer first, second, counts;

        public NeighborLists(SolverLayout layout)
        {
            TwoLists = layout.TwoLists;
            first = buffers.Structured<uint4>("Rill.Neighbors", layout.FirstListEntries / BlockEntries);
            counts = buffers.Structured<uint>("Rill.NeighborCounts", layout.Capacity);
            if (TwoLists)
                second = buffers.Structured<uint4>("Rill.MoreNeighbors", layout.SecondListEntries / BlockEntries);
        }

        public bool TwoLists { get; }

        /// <summary>uint4, blocks of entries of the particles before <see cref="SolverLayout.FirstListParticles"/>; see NeighborList.hlsl.</summary>
        public GraphicsBuffer First => first;
        /// <summary>Those of the others; null without <see cref="TwoLists"/>.</summary>
        public GraphicsBuffer Second => second;
        /// <summary>uint [capacity], entries in a particle's list.</summary>
        public GraphicsBuffer Counts => counts;

        /// <summary>Enabled keywords of a kernel that reads the lists, for descriptions; null for none.</summary>
        public string Variant => TwoLists ? TwoListsKeyword : null;

        /// <summary>Lists of particles as they lie on the GPU, one after the other.</summary>
        /// <param name="words">Number of words of all particles' blocks.</param>
        /// <param name="counts">[particles].</param>
        public static uint[] Pack(SolverLayout layout, ReadOnlySpan<uint> words, ReadOnlySpan<uint> counts)
        {
            long total = 0;
            foreach (uint count in counts)
                total += Math.Min(count, (uint)layout.NeighborCapacity);
            var entries = new uint[total];
            int to = 0;
            for (int i = 0; i < counts.Length; i++)
                for (int k = 0; k < Math.Min(counts[i], (uint)layout.NeighborCapacity); k++)
                    entries[to++] = words[(int)layout.WordOfEntry(i, k)];
            return entries;
        }

        /// <summary>Puts lists onto the GPU at once. What is beyond this layout's neighbor capacity is left out.</summary>
        /// <param name="entries">One particle's after the other's.</param>
        /// <param name="lengths">[particles].</param>
        public void Upload(SolverLayout layout, ReadOnlySpan<uint> entries, ReadOnlySpan<uint> lengths)
        {
            var words = new uint[layout.ListWords(lengths.Length)];
            var held = new uint[lengths.Length];
            int from = 0;
            for (int i = 0; i < lengths.Length; i++)
            {
                held[i] = Math.Min(lengths[i], (uint)layout.NeighborCapacity);
                for (int k = 0; k < (held[i] + BlockEntries - 1) / BlockEntries * BlockEntries; k++)
                    words[(int)layout.WordOfEntry(i, k)] = k < held[i] ? entries[from + k] : (uint)i;       // the rest of its last block is itself
                from += (int)lengths[i];
            }
            if (lengths.Length == 0)
                return;
            counts.SetData(held, 0, 0, held.Length);
            int inFirst = (int)Math.Min(words.Length, layout.FirstListEntries);
            first.SetData(words, 0, 0, inFirst);
            if (words.Length > inFirst)
                second.SetData(words, inFirst, 0, words.Length - inFirst);
        }

        /// <summary>Records the lists as what a kernel reads or builds. The shader's keyword is that of <see cref="StepKeywords"/>.</summary>
        public void Bind(CommandBuffer cmd, ComputeShader shader, int kernel) => buffers.Bind(cmd, shader, kernel);

        public void Dispose() => buffers.Dispose();

        public void Describe(StageDescription stage) => buffers.Describe(stage);
    }
}
