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
        [SharedWithHlsl("NeighborList")] public const int BlockEntries = 4;

        GraphicsBuffer first, second, counts;

        public NeighborLists(SolverLayout layout)
        {
            TwoLists = layout.TwoLists;
            first = GpuBuffer.Structured<uint4>("Rill.Neighbors", layout.FirstListEntries / BlockEntries);
            counts = GpuBuffer.Structured<uint>("Rill.NeighborCounts", layout.Capacity);
            if (TwoLists)
                second = GpuBuffer.Structured<uint4>("Rill.MoreNeighbors", layout.SecondListEntries / BlockEntries);
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

        /// <summary>Records the lists as what a kernel reads or builds. The shader's keyword is set by <see cref="RecordKeyword"/>.</summary>
        public void Bind(CommandBuffer cmd, ComputeShader shader, int kernel)
        {
            cmd.SetComputeBufferParam(shader, kernel, Ids.Neighbors, first);
            cmd.SetComputeBufferParam(shader, kernel, Ids.NeighborCounts, counts);
            if (TwoLists)
                cmd.SetComputeBufferParam(shader, kernel, Ids.MoreNeighbors, second);
        }

        /// <summary>Records the keyword: another solver may have left the shared shader on the other variant.</summary>
        public void RecordKeyword(CommandBuffer cmd, ComputeShader shader, in LocalKeyword twoLists)
        {
            cmd.SetKeyword(shader, twoLists, TwoLists);
        }

        public void Dispose()
        {
            GpuBuffer.Release(ref first);
            GpuBuffer.Release(ref second);
            GpuBuffer.Release(ref counts);
        }

        public void Describe(StageDescription stage)
        {
            stage.Buffer("Rill.Neighbors", first);
            stage.Buffer("Rill.MoreNeighbors", second);
            stage.Buffer("Rill.NeighborCounts", counts);
        }

        static class Ids
        {
            public static readonly int Neighbors = Shader.PropertyToID("_Neighbors");
            public static readonly int MoreNeighbors = Shader.PropertyToID("_MoreNeighbors");
            public static readonly int NeighborCounts = Shader.PropertyToID("_NeighborCounts");
        }
    }
}
