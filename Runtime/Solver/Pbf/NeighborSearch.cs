using System;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Sorts the particles by grid cell so that neighbors are near in memory: a counting sort on the GPU.</summary>
    /// <remarks>Cell c holds the sorted particles from <c>CellStarts[c]</c> up to <c>CellStarts[c + 1]</c>.</remarks>
    sealed class NeighborSearch : Stage
    {
        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Sort");

        /// <summary>Kernels that carry data of other stages through the sort; those stages list them among their own.</summary>
        public readonly Kernel GatherTags, GatherPreviousIndices, GatherMeans;

        readonly ComputeShader shader = StageShader.LoadCompute("NeighborSearch");
        readonly KernelVariants countCells, gather;       // deep, with colliders; with colliders
        readonly KernelVariants countCellsWithMaterials;    // with colliders; deep
        readonly Kernel countCellsAtRest, scatterOrder;
        readonly StepKeywords keywords;
        readonly bool isNarrow;         // a kernel has 8 storage buffers
        readonly int cells;
        readonly PrefixSum prefixSum;
        readonly GraphicsBuffer cellHistogram, cellRanks;
        GraphicsBuffer cellStartsAtRest;

        public NeighborSearch(SolverLayout layout) : this(layout, DeviceLimits.Current) { }

        public NeighborSearch(SolverLayout layout, in DeviceLimits limits)
        {
            isNarrow = !limits.Holds("NeighborSearch", "Gather");
            countCells = new KernelVariants(shader, "CountCells", "CountCellsDeep", "CountCellsWithColliders", "CountCellsDeepWithColliders");
            countCellsWithMaterials = new KernelVariants(shader, "CountCellsWithMaterials", "CountCellsWithCollidersAndMaterials");
            gather = new KernelVariants(shader, isNarrow ? "Gather" + KernelNeed.Narrow : "Gather", "GatherWithColliders");
            countCellsAtRest = new Kernel(shader, "CountCellsAtRest");
            scatterOrder = new Kernel(shader, "ScatterOrder");
            GatherTags = new Kernel(shader, "GatherTags");
            GatherPreviousIndices = new Kernel(shader, "GatherPreviousIndices");
            GatherMeans = new Kernel(shader, "GatherMeans");

            keywords = new StepKeywords(shader, readsLists: false, skipsAsleep: true);
            cells = layout.CellTotal;
            cellHistogram = Buffers.Structured<uint>("Rill.CellHistogram", cells + 1);    // first: too many cells leave nothing behind
            prefixSum = new PrefixSum(StageShader.LoadCompute("PrefixSum"), cells + 1);
            CellStarts = Buffers.Structured<uint>("Rill.CellStarts", cells + 1);
            cellRanks = Buffers.Structured<uint2>("Rill.CellRanks", layout.Capacity);
            CellOrder = Buffers.Structured<uint2>("Rill.Order", layout.Capacity);
            BufferClear.Now(cellHistogram);
            BufferClear.Now(CellStarts);        // bound before the first step, too, though nothing is read there
        }

        /// <summary>uint [cells + 1], particles in all cells before, as the newest <see cref="RecordSort"/> put them; the last is their
        /// total.</summary>
        public GraphicsBuffer CellStarts { get; }

        /// <summary>Whether the particles still lie as the newest <see cref="RecordSort"/> put them; those that came since stand after
        /// them.</summary>
        public bool IsSorted { get; set; }

        /// <summary>uint [cells + 1], the same for <see cref="CellOrder"/> after the newest <see cref="RecordOrderAtRest"/>. A buffer of its own:
        /// what asks between steps still finds the particles in the rows where the sort put them.</summary>
        public GraphicsBuffer CellStartsAtRest => cellStartsAtRest
            ??= Buffers.Structured<uint>("Rill.CellStartsAtRest", cells + 1, BufferSet.Unbound);

        /// <summary>uint2 [capacity], by cell: index of the particle and its id.</summary>
        public GraphicsBuffer CellOrder { get; }

        /// <summary>Records the sort of the particles by predicted position, into Start, Predicted and SortedIds.</summary>
        /// <param name="takesProjection">Whether the coarse grid's displacements are added to the velocities first.</param>
        /// <param name="previousIndices">uint [capacity], gets where each particle was before, see NeighborSearch.compute; null for no
        /// stage that asks.</param>
        public void RecordSort(in StepContext step, bool takesProjection, GraphicsBuffer previousIndices = null)
        {
            CommandBuffer cmd = step.Commands;
            ParticleBuffers particles = step.Particles;
            cmd.BeginSample(Marker);
            keywords.Record(step);
            step.BindConstants(shader);
            RecordCount(step, takesProjection);
            if (step.Colliders != null)
            {
                cmd.EndSample(Marker);      // what they take is theirs
                step.Colliders.RecordPaths(step, cellHistogram, cellRanks);
                cmd.BeginSample(Marker);
            }
            RecordOrder(cmd, particles, CellStarts);
            if (previousIndices != null)
            {
                cmd.SetComputeBufferParam(shader, GatherPreviousIndices, Viscoelasticity.Ids.PreviousIndices, previousIndices);
                DispatchOrdered(cmd, particles, GatherPreviousIndices);
            }

            if (step.Extrapolation != null)
            {
                step.Extrapolation.BindSort(cmd, shader, GatherMeans);
                DispatchOrdered(cmd, particles, GatherMeans);
            }

            if (isNarrow && step.Colliders == null)
                RecordGather(cmd, particles, particles.Ids, particles.SortedIds);
            int kernel = gather.For(step.Colliders != null);
            step.BindAsleep(shader, kernel);
            step.Colliders?.Bind(cmd, shader, kernel);
            particles.Bind(cmd, shader, kernel);
            Ids.Sorted.Bind(cmd, shader, kernel, particles.Predicted, particles.SortedIds);
            DispatchOrdered(cmd, particles, kernel);
            IsSorted = true;
            cmd.EndSample(Marker);
        }

        /// <summary>Records that a value of each particle goes where the sort that was just recorded put the particle.</summary>
        /// <param name="from">uint [capacity], as the particles were.</param>
        /// <param name="to">uint [capacity], sorted.</param>
        public void RecordGather(CommandBuffer cmd, ParticleBuffers particles, GraphicsBuffer from, GraphicsBuffer to)
        {
            Ids.Gathered.Bind(cmd, shader, GatherTags, from, to);
            DispatchOrdered(cmd, particles, GatherTags);
        }

        /// <summary>Records <see cref="CellStartsAtRest"/> and <see cref="CellOrder"/> for the current positions and moves no particle.</summary>
        public void RecordOrderAtRest(in StepContext step)
        {
            keywords.Record(step, allAwake: true);
            step.BindConstants(shader);
            DispatchCount(step.Commands, step.Particles, countCellsAtRest);
            RecordOrder(step.Commands, step.Particles, CellStartsAtRest);
        }

        /// <summary>Returns the enabled keywords of its kernels, for descriptions; null for none.</summary>
        public string Variant(in StepContext step) => keywords.Variant(step);

        /// <summary>Gives back what listing particles at rest takes; it is made again when asked for.</summary>
        public void ReleaseAtRest() => Buffers.Release(ref cellStartsAtRest);

        /// <summary>Records a kernel that asks for the order of the particles, by OrderedSlot.hlsl.</summary>
        /// <param name="cellStarts">Those of the order.</param>
        public void DispatchOrdered(CommandBuffer cmd, ComputeShader asks, int kernel, ParticleBuffers particles, GraphicsBuffer cellStarts)
        {
            Buffers.Bind(cmd, asks, kernel);
            Ids.Ordered.Bind(cmd, asks, kernel, cellStarts, particles.Counters);
            particles.DispatchSorted(cmd, asks, kernel);
        }

        public override void Dispose()
        {
            prefixSum.Dispose();
            base.Dispose();
        }

        /// <param name="takesProjection">Whether the coarse grid's displacements are added to the velocities first.</param>
        public StageDescription Describe(in StepContext step, bool takesProjection)
        {
            var stage = new StageDescription("Neighbor search", true, "every step sorts its particles by cell");
            bool withColliders = step.Colliders != null;
            string variant = keywords.Variant(step);
            stage.Kernel(CountKernel(step, takesProjection), step.Substeps, variant);
            prefixSum.Describe(stage, step.Substeps);
            stage.Kernel(scatterOrder, step.Substeps, variant);
            if (isNarrow && !withColliders)
                stage.Kernel(GatherTags, step.Substeps);
            stage.Kernel(gather.For(withColliders), step.Substeps, variant);
            Buffers.Describe(stage);
            return stage;
        }

        /// <summary>The kernels of <see cref="RecordOrderAtRest"/>, which runs outside the step.</summary>
        public void DescribeOrderAtRest(StageDescription stage)
        {
            stage.Kernel(countCellsAtRest, 0);
            prefixSum.DescribeKernels(stage, 0);
            stage.Kernel(scatterOrder, 0);
        }

        void DispatchOrdered(CommandBuffer cmd, ParticleBuffers particles, int kernel)
            => DispatchOrdered(cmd, shader, kernel, particles, CellStarts);

        void RecordCount(in StepContext step, bool takesProjection)
        {
            CommandBuffer cmd = step.Commands;
            int kernel = CountKernel(step, takesProjection);
            if (takesProjection)
                step.Materials?.Bind(step, shader, kernel);
            step.BindAsleep(shader, kernel);
            step.Colliders?.Bind(cmd, shader, kernel);
            if (takesProjection)
                step.Coarse.BindChange(step, shader, kernel);
            DispatchCount(cmd, step.Particles, kernel);
        }

        Kernel CountKernel(in StepContext step, bool takesProjection) => takesProjection && step.Materials != null
            ? countCellsWithMaterials.For(step.Colliders != null) : countCells.For(takesProjection, step.Colliders != null);

        void DispatchCount(CommandBuffer cmd, ParticleBuffers particles, int countKernel)
        {
            particles.Bind(cmd, shader, countKernel);
            Buffers.Bind(cmd, shader, countKernel);
            particles.DispatchAlive(cmd, shader, countKernel);
        }

        // From what was counted.
        void RecordOrder(CommandBuffer cmd, ParticleBuffers particles, GraphicsBuffer cellStarts)
        {
            prefixSum.Record(cmd, cellHistogram, cellStarts, cells + 1);

            Buffers.Bind(cmd, shader, scatterOrder);
            particles.Bind(cmd, shader, scatterOrder);
            Ids.Scatter.Bind(cmd, shader, scatterOrder, cellStarts, particles.SortedArguments);
            particles.DispatchAlive(cmd, shader, scatterOrder);
        }

        static class Ids
        {
            public static readonly ShaderParameters Ordered = new ShaderParameters("_CellStarts", "_Counters");
            public static readonly ShaderParameters Sorted = new ShaderParameters("_Predicted", "_SortedIds");
            public static readonly ShaderParameters Gathered = new ShaderParameters("_Tags", "_SortedTags");
            public static readonly ShaderParameters Scatter = new ShaderParameters("_CellStarts", "_SortedArguments");
        }
    }
}
