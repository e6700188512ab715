using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>
    /// The long-range part of the pressure, on a coarse grid: what makes deep water possible, where a Jacobi pass reaches
    /// one support radius. See Documentation~/solver.md, "Deep water".
    /// </summary>
    /// <remarks>
    /// Twice a substep: the projection, on the flow before the prediction, and the density correction, on the errors that
    /// the first multipliers find. Both potentials start from the last substep's.
    /// </remarks>
    sealed partial class CoarseCorrection : Stage
    {
        /// <summary>words of a cell in _Bins</summary>
        [GenerateHlsl("CoarseBins")] const int BinStride = 8;

        static readonly ProfilerMarker ProjectionMarker = GpuMarker.Create("Rill.Projection");
        static readonly ProfilerMarker DensityMarker = GpuMarker.Create("Rill.DensityCorrection");

        readonly ComputeShader shader = StageShader.LoadCompute("CoarseGrid");
        readonly KernelVariants binFlow, findSurface, findDivergence, displaceFlow;     // with colliders, with materials
        readonly KernelVariants findErrors, displaceErrors;         // with colliders
        readonly KernelVariants reactToFlow, reactToErrors;         // with materials
        readonly Kernel extendDisplacements;
        CoarseColliders coarseColliders;
        readonly GraphicsBuffer cellDensities;      // null for one material
        readonly GraphicsBuffer flow, fill, surface, weightedCounts, source, lastErrors, diagonal, flowPotential, errorPotential;

        /// <param name="cellSize">Wanted side of a coarse cell, d.</param>
        public CoarseCorrection(SolverLayout layout, float cellSize) : this(layout, cellSize, DeviceLimits.Current) { }

        /// <param name="cellSize">Wanted side of a coarse cell, d.</param>
        /// <param name="hasMaterials">Whether phases are of several materials.</param>
        public CoarseCorrection(SolverLayout layout, float cellSize, in DeviceLimits limits, bool hasMaterials = false)
        {
            binFlow = new KernelVariants(shader, "BinFlow", "BinFlowWithColliders", "BinFlowWithMaterials",
                "BinFlowWithCollidersAndMaterials");
            findSurface = new KernelVariants(shader, "FindSurface", "FindSurfaceWithColliders", "FindSurfaceWithMaterials",
                "FindSurfaceWithCollidersAndMaterials");
            findDivergence = new KernelVariants(shader, "FindDivergence", "FindDivergenceWithColliders", "FindDivergenceWithMaterials",
                "FindDivergenceWithCollidersAndMaterials");
            displaceFlow = new KernelVariants(shader, "DisplaceFlow", "DisplaceFlowWithColliders", "DisplaceFlowWithMaterials",
                "DisplaceFlowWithCollidersAndMaterials");
            findErrors = new KernelVariants(shader, "FindErrors", "FindErrorsWithColliders");
            displaceErrors = new KernelVariants(shader, "DisplaceErrors", "DisplaceErrorsWithColliders");
            extendDisplacements = new Kernel(shader, "ExtendDisplacements");
            reactToFlow = new KernelVariants(shader, "ReactToFlow", "ReactToFlowWithMaterials");
            reactToErrors = new KernelVariants(shader, "ReactToErrors", "ReactToErrorsWithMaterials");
            takePotential = new Kernel(shader, "TakePotential");

            CoarseSolverPath path = CoarseSolverPath.For(limits);
            Grid = new CoarseGrid(layout.DomainSize, cellSize, path.TailCells);
            Solver = new CoarseSolver(Grid, path);
            Bins = Buffers.Structured<uint>("Rill.Coarse.Bins", (long)Grid.Total * BinStride);
            flow = Buffers.Structured<float4>("Rill.Coarse.Flow", Grid.Total);
            DeepFlow = hasMaterials ? null : Buffers.Structured<float4>("Rill.Coarse.DeepFlow", Grid.Total);
            fill = Buffers.Structured<float>("Rill.Coarse.Fill", Grid.Total);
            surface = Buffers.Structured<uint>("Rill.Coarse.Surface", Grid.Total);
            weightedCounts = Buffers.Structured<uint>("Rill.Coarse.WeightedCounts", (hasMaterials ? 3L : 1L) * Grid.Total);
            cellDensities = hasMaterials ? Buffers.Structured<float>("Rill.Coarse.CellDensities", Grid.Total) : null;
            source = Buffers.Structured<float>("Rill.Coarse.Source", Grid.Total);
            lastErrors = Buffers.Structured<float>("Rill.Coarse.LastErrors", Grid.Total);
            diagonal = Buffers.Structured<float>("Rill.Coarse.Diagonal", Grid.Total);
            flowPotential = Buffers.Structured<float>("Rill.Coarse.FlowPotential", Grid.Total);
            errorPotential = Buffers.Structured<float>("Rill.Coarse.ErrorPotential", Grid.Total);
            Displacements = Buffers.Structured<float4>("Rill.Coarse.Displacements", Grid.Total, "_CellDisplacements");
            Constants = Buffers.Constants<CoarseConstants>("Rill.Coarse.Constants", "RillCoarse");
            Constants.SetData(new[] { CoarseConstants.For(Grid) });
            BufferClear.Now(Bins, lastErrors, surface, weightedCounts, flowPotential, errorPotential);       // the first substep has no past
        }

        public CoarseGrid Grid { get; }

        public CoarseSolver Solver { get; }

        /// <summary>Whether the next substep's potentials have no past.</summary>
        public bool IsFirst { get; set; } = true;

        /// <summary><see cref="CoarseConstants"/>, which do not change.</summary>
        public GraphicsBuffer Constants { get; }

        /// <summary>float4 [cells], xyz displacement at a cell's center, d.</summary>
        public GraphicsBuffer Displacements { get; }

        /// <summary>float4 [cells], see DeepFlow.hlsl: deep particles are blended to it. Null for several materials: their mean flow is that of
        /// none.</summary>
        public GraphicsBuffer DeepFlow { get; }

        /// <summary>uint [cells, 8], see CoarseBins.hlsl; the density constraint sums its errors there.</summary>
        public GraphicsBuffer Bins { get; }

        /// <summary>uint [cells], bits: where the water's surface is; see CoarseGrid.compute.</summary>
        public GraphicsBuffer Surface => surface;

        /// <summary>Buffers that the passes hand on, for tests; see CoarseGrid.compute.</summary>
        public (GraphicsBuffer flow, GraphicsBuffer fill, GraphicsBuffer surface, GraphicsBuffer source, GraphicsBuffer lastErrors,
            GraphicsBuffer diagonal, GraphicsBuffer flowPotential, GraphicsBuffer errorPotential) Cells
            => (flow, fill, surface, source, lastErrors, diagonal, flowPotential, errorPotential);

        public override void ListState(List<StateBuffer> state)
        {
            state.Add(new StateBuffer(SnapshotSection.CoarseSurface, surface, StateExtent.All));
            state.Add(new StateBuffer(SnapshotSection.CoarseErrors, lastErrors, StateExtent.All));
            state.Add(new StateBuffer(SnapshotSection.FlowPotential, flowPotential, StateExtent.All));
            state.Add(new StateBuffer(SnapshotSection.ErrorPotential, errorPotential, StateExtent.All));
        }

        public override bool Survives(ParticleChange change) => false;

        public override bool Fits(PbfSolver solver, in StepInput step)
            => Grid.WantedSize == solver.CoarseCellSize(step) && WithMaterials == MaterialTable.IsNeeded(step);

        /// <summary>Whether a scene's water is too deep for the constraint alone.</summary>
        /// <param name="layers">Depth of the water, d.</param>
        /// <param name="present">Whether a correction runs already: it stays a while, since a new one starts without a past.</param>
        public static bool IsNeeded(DeepWater mode, float layers, bool present) =>
            mode == DeepWater.On || mode == DeepWater.Automatic && math.round(layers) > (present ? StaysAboveLayers : MaxShallowLayers);

        /// <summary>Whether a step needs the correction: for the depth of its water, or for the pressure between grains.</summary>
        public static bool IsNeeded(in StepInput input, float layers, bool present)
            => !Contacts.IsNeeded(input) && (IsNeeded(input.settings.deepWater, layers, present) || GrainFriction.IsNeeded(input));

        /// <summary>Says why a step runs the correction, or why not.</summary>
        public static string Reason(in StepInput input, float layers, bool present)
            => Contacts.IsNeeded(input) ? "loose balls have contacts instead of a pressure"
            : IsNeeded(input.settings.deepWater, layers, present) || !GrainFriction.IsNeeded(input)
            ? Reason(input.settings.deepWater, layers, present) : "grains need its pressure";

        /// <summary>Layers of particles up to which plain iterations hold the water; see Research~/solver-study.md.</summary>
        public const float MaxShallowLayers = 4f;

        /// <summary>Layers above which a correction that runs stays: gravity that turns back and forth shall not switch it.</summary>
        public const float StaysAboveLayers = 3f;

        /// <summary>Fractions of the grid that solid colliders leave open; null without colliders.</summary>
        public CoarseColliders Colliders => coarseColliders;

        /// <summary>Layers of particles above which water collapses under plain iterations, so that bodies in it sink to about twice their
        /// draft: it stands in 14 layers and not in 24, see Research~/report.md, "Floating bodies".</summary>
        public const float MaxLayersWithout = 14f;

        /// <summary>Says why a correction runs, or why not; the arguments are those of <see cref="IsNeeded(DeepWater, float, bool)"/>.</summary>
        public static string Reason(DeepWater mode, float layers, bool present)
        {
            string depth = Invariant($"water {layers:0} layers deep");
            return mode != DeepWater.Automatic ? Invariant($"deep water is set to {mode}")
                : IsNeeded(mode, layers, present) ? Invariant($"{depth}, more than {MaxShallowLayers:0} (and stays above {StaysAboveLayers:0})")
                : Invariant($"{depth}, at most {MaxShallowLayers:0}");
        }

        /// <summary>Records what solid colliders leave open of the grid in this substep; before the rest of it.</summary>
        public void RecordColliders(in StepContext step)
        {
            if (step.Colliders == null)
            {
                coarseColliders?.Dispose();
                coarseColliders = null;
                return;
            }
            coarseColliders ??= new CoarseColliders(Grid);
            coarseColliders.Record(step, Constants);
        }

        /// <summary>Records the projection: <see cref="Displacements"/> are what the prediction shall add to the flow.</summary>
        public void RecordProjection(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            cmd.BeginSample(ProjectionMarker);
            step.BindConstants(shader);
            int bin = binFlow.For(WithColliders, WithMaterials);
            coarseColliders?.Bind(cmd, shader, bin);
            step.Materials?.Bind(step, shader, bin);
            step.Particles.Bind(cmd, shader, bin);
            Buffers.Bind(cmd, shader, bin);
            step.Particles.DispatchAlive(cmd, shader, bin);

            RecordCells(step, findSurface.For(WithColliders, WithMaterials), flowPotential);
            RecordNeighbors(step, ofFlow: true);
            FlowTime = step.SubstepTime;
            RecordCells(step, findDivergence.For(WithColliders, WithMaterials), flowPotential);
            Solver.Record(cmd, Constants, source, diagonal, flowPotential, coarseColliders, cellDensities,
                math.max(FirstCycles, step.Materials != null ? MaterialTable.CyclesFor(step.Input) : 1));
            RecordDisplacements(cmd, displaceFlow.For(WithColliders, WithMaterials), flowPotential);
            RecordReaction(cmd, reactToFlow.For(WithMaterials), flowPotential);
            cmd.EndSample(ProjectionMarker);
        }

        /// <summary>Rate at which deep particles lose what they depart from the coarse flow by, 1/s: a tenth in 1/60 s. See
        /// Research~/solver-study.md, "Blend to the coarse flow".</summary>
        public const float FlowBlendRate = 6.3f;

        /// <summary>Records what a kernel reads that takes up the projection, see DeepFlow.hlsl.</summary>
        public void BindChange(in StepContext step, ComputeShader reads, int kernel)
        {
            step.BindCoarseConstants(reads);
            float blend = 1f - math.exp(-FlowBlendRate * step.SubstepTime);
            Ids.Change.Bind(step.Commands, reads, kernel, Displacements, DeepFlow, blend);
        }

        /// <summary>Records the density correction: <see cref="Displacements"/> from the errors in <see cref="Bins"/>.</summary>
        public void RecordDensity(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            cmd.BeginSample(DensityMarker);
            step.BindConstants(shader);
            cmd.SetComputeFloatParam(shader, Ids.PressedError, (float)SurfaceTension.PressedError(step));
            RecordNeighbors(step, ofFlow: false);
            RecordCells(step, findErrors.For(WithColliders), errorPotential);
            Solver.Record(cmd, Constants, source, diagonal, errorPotential, coarseColliders, minCycles: FirstCycles);
            IsFirst = false;
            RecordDisplacements(cmd, displaceErrors.For(WithColliders), errorPotential);
            RecordReaction(cmd, reactToErrors.For(WithMaterials), errorPotential);
            cmd.EndSample(DensityMarker);
        }

        public override void Dispose()
        {
            Solver.Dispose();
            coarseColliders?.Dispose();
            coarseColliders = null;
            base.Dispose();
        }

        /// <param name="stage">The stage, or null where none was made.</param>
        public static StageDescription Describe(CoarseCorrection stage, in StepInput input, float layers)
        {
            bool needed = IsNeeded(input, layers, stage != null);
            var description = new StageDescription("Coarse correction", needed, Reason(input, layers, stage != null));
            if (!needed || stage == null)
                return description;
            int substeps = input.settings.substeps;
            foreach (KernelVariants kernel in new[] { stage.binFlow, stage.findSurface, stage.findDivergence, stage.displaceFlow })
                description.Kernel(kernel.For(stage.WithColliders, stage.WithMaterials), substeps);
            description.Kernel(stage.findErrors.For(stage.WithColliders), substeps);
            description.Kernel(stage.displaceErrors.For(stage.WithColliders), substeps);
            stage.coarseColliders?.Describe(description, substeps);
            if (stage.coarseColliders?.Reacting != null)
            {
                description.Kernel(stage.reactToFlow.For(stage.WithMaterials), substeps);
                description.Kernel(stage.reactToErrors.For(stage.WithMaterials), substeps);
            }
            description.Kernel(stage.extendDisplacements, 2 * substeps);
            int neighbors = CountTied(input.connections);
            if (neighbors > 0)
                description.Kernel(stage.takePotential, 2 * substeps * neighbors);
            int cycles = stage.Solver.Cycles, withMaterials = stage.WithMaterials ? math.max(cycles, MaterialTable.CyclesFor(input)) : 0;
            stage.Solver.Describe(description, (withMaterials > 0 ? 1 : 2) * cycles * substeps, withMaterials * substeps, stage.WithColliders);
            stage.Buffers.Describe(description);
            return description;
        }

        int FirstCycles => IsFirst ? CoarseSolver.FirstCycles : 1;

        bool WithColliders => coarseColliders != null;

        bool WithMaterials => cellDensities != null;

        void BindCells(CommandBuffer cmd, int kernel, GraphicsBuffer potential)
        {
            coarseColliders?.Bind(cmd, shader, kernel);
            Buffers.Bind(cmd, shader, kernel);
            cmd.SetComputeBufferParam(shader, kernel, Ids.Potential, potential);
        }

        // For kernels that read the counters of the particles and the volume that the colliders leave.
        void RecordCells(in StepContext step, int kernel, GraphicsBuffer potential)
        {
            CommandBuffer cmd = step.Commands;
            BindCells(cmd, kernel, potential);
            coarseColliders?.BindVolume(cmd, shader, kernel);
            cmd.SetComputeBufferParam(shader, kernel, ParticleIds.Counters, step.Particles.Counters);
            Dispatch(cmd, kernel);
        }

        void RecordDisplacements(CommandBuffer cmd, int kernel, GraphicsBuffer potential)
        {
            BindCells(cmd, kernel, potential);
            Dispatch(cmd, kernel);
            Buffers.Bind(cmd, shader, extendDisplacements);
            Dispatch(cmd, extendDisplacements);
        }

        void RecordReaction(CommandBuffer cmd, int kernel, GraphicsBuffer potential)
        {
            if (coarseColliders?.Reacting == null)
                return;
            BindCells(cmd, kernel, potential);
            coarseColliders.Reacting.BindShapes(cmd, shader, kernel);
            coarseColliders.Reacting.Reactions.Bind(cmd, shader, kernel);
            Dispatch(cmd, kernel);
        }

        void Dispatch(CommandBuffer cmd, int kernel) => CoarseGrid.Dispatch(cmd, shader, kernel, Grid.Total);

        static class Ids
        {
            public static readonly ShaderParameters Change = new ShaderParameters("_Displacements", "_DeepFlow", "_FlowBlend");
            public static readonly int Potential = Shader.PropertyToID("_Potential");
            public static readonly int PressedError = Shader.PropertyToID("_PressedError");
        }
    }

    /// <summary>Properties of CoarseGrid.hlsl, CoarseDisplacement.hlsl and CoarseBins.hlsl.</summary>
    static class CoarseIds
    {
        public static readonly int Displacements = Shader.PropertyToID("_Displacements");
        public static readonly int Constants = Shader.PropertyToID("RillCoarse");
        public static readonly int DeepFlow = Shader.PropertyToID("_DeepFlow");
    }
}
