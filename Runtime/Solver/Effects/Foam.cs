using System;
using System.Runtime.InteropServices;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Kind of a foam particle.</summary>
    [GenerateHlsl("Foam")]
    enum FoamKind { NoFoam, Spray, Foam, Bubble }

    /// <summary>Entries of the counter buffer of foam; those of each kind at its number.</summary>
    [GenerateHlsl("Foam", Prefix = "Foam")]
    enum FoamCounter
    {
        Alive,
        Spray = FoamKind.Spray,
        Foam = FoamKind.Foam,
        Bubbles = FoamKind.Bubble,
        Spawned,
        Refused,
    }

    /// <summary>See Foam.hlsl for what the words are.</summary>
    [GenerateHlsl("Foam")]
    [StructLayout(LayoutKind.Sequential)]
    struct FoamParticle
    {
        public uint4 a, b;
    }

    /// <summary>Foam, spray and bubbles (Ihmsen et al. 2012), once a step. Made when first needed.</summary>
    /// <remarks>
    /// Particles lie without gaps in the order in which they came: every step moves them, leaves out what is over and puts the new
    /// ones behind, at places that one prefix sum over groups of threads gives to both. So a run repeats bit for bit.
    /// </remarks>
    sealed class Foam : Stage
    {
        public const int CounterCount = 8;

        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Foam");

        readonly ComputeShader shader = StageShader.LoadCompute("Foam"), sources = StageShader.LoadCompute("FoamSources");
        readonly KernelVariants move;     // with colliders
        readonly Kernel averageCells, compact, spawn, commit, findPotentials, countSpawned;
        readonly StepKeywords keywords;
        readonly int foamGroups, fluidGroups;
        readonly int cellTotal;
        readonly float3 cellSize;
        readonly int[] cellCounts, cellsPerFoamCell;
        readonly PrefixSum prefixSum;
        readonly Readback readback;
        readonly GraphicsBuffer arguments, cells, potentials, spawnCounts, groupCounts, sums;
        GraphicsBuffer particles, moved;

        /// <param name="budget">Maximum number of particles.</param>
        /// <param name="errors">Learns of results that the device did not give; may be null.</param>
        /// <exception cref="ArgumentOutOfRangeException">More than the device can bind.</exception>
        public Foam(SolverLayout layout, int budget, ReadbackErrors errors = null)
        {
            Budget = budget;
            averageCells = new Kernel(shader, "AverageCells");
            move = new KernelVariants(shader, "Move", "MoveWithColliders");
            compact = new Kernel(shader, "Compact");
            spawn = new Kernel(shader, "Spawn");
            commit = new Kernel(shader, "Commit");
            findPotentials = new Kernel(sources, "FindPotentials");
            countSpawned = new Kernel(sources, "CountSpawned");
            keywords = new StepKeywords(sources, readsLists: true, skipsAsleep: false);

            foamGroups = ParticleBuffers.Groups(budget);
            fluidGroups = ParticleBuffers.Groups(layout.Capacity);
            int3 counts = (layout.CellCounts + layout.CellsPerRadius - 1) / layout.CellsPerRadius;
            cellTotal = counts.x * counts.y * counts.z;
            cellCounts = new[] { counts.x, counts.y, counts.z, cellTotal };
            cellsPerFoamCell = new[] { layout.CellsPerRadius.x, layout.CellsPerRadius.y, layout.CellsPerRadius.z, 0 };
            cellSize = layout.CellSize * layout.CellsPerRadius;

            try
            {
                particles = Buffers.Structured<FoamParticle>("Rill.Foam.Particles", budget, "_FoamParticles");
                moved = Buffers.Structured<FoamParticle>("Rill.Foam.Moved", budget);
                arguments = Buffers.Arguments("Rill.Foam.Arguments", property: "_FoamArguments");
                readback = new Readback(GpuBuffer.Structured<uint>("Rill.Foam.Counters", CounterCount));
                Buffers.AddShared("Rill.Foam.Counters", readback.Buffer, "_FoamCounters");
                cells = Buffers.Structured<float4>("Rill.Foam.Cells", cellTotal, "_FoamCells");
                potentials = Buffers.Structured<uint2>("Rill.Foam.Potentials", layout.Capacity);
                spawnCounts = Buffers.Structured<uint>("Rill.Foam.SpawnCounts", layout.Capacity);
                groupCounts = Buffers.Structured<uint>("Rill.Foam.GroupCounts", foamGroups + fluidGroups + 1);
                sums = Buffers.Structured<uint>("Rill.Foam.Sums", foamGroups + fluidGroups + 1);
                prefixSum = new PrefixSum(StageShader.LoadCompute("PrefixSum"), foamGroups + fluidGroups + 1);
                readback.Report(errors, ReadbackKinds.Foam);
                readback.Lost = readback.Invalidate;
                BufferClear.Now(groupCounts);
                Clear();
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        /// <summary>Most particles.</summary>
        public int Budget { get; }

        /// <summary>FoamParticle [<see cref="Budget"/>], see Foam.hlsl: those that are there come first.</summary>
        public GraphicsBuffer Particles => particles;

        /// <summary>Arguments of a draw of the particles and a dispatch over them, see <see cref="GpuBuffer.Arguments"/>.</summary>
        public GraphicsBuffer Arguments => arguments;

        /// <summary>uint [<see cref="CounterCount"/>], by <see cref="FoamCounter"/>.</summary>
        public GraphicsBuffer Counters => readback.Buffer;

        /// <summary>uint2 [capacity], see FoamSources.compute.</summary>
        public GraphicsBuffer Potentials => potentials;

        /// <summary>float4 [cells], see Foam.compute.</summary>
        public GraphicsBuffer Cells => cells;

        /// <summary>uint [capacity], see FoamSources.compute.</summary>
        public GraphicsBuffer SpawnCounts => spawnCounts;

        /// <summary>Limits of the last step.</summary>
        public FoamScales Scales { get; private set; }

        public static bool IsNeeded(in StepInput input) => input.foam.budget > 0;

        public override bool Survives(ParticleChange change)
        {
            Clear();
            return true;
        }

        public override bool Fits(PbfSolver solver, in StepInput step) => Budget == step.foam.budget;

        /// <summary>No foam, at once; counts begin again.</summary>
        public void Clear()
        {
            BufferClear.Now(readback.Buffer);
            arguments.SetData(NoParticles);
            readback.Invalidate();
        }

        /// <summary>Records the step of all foam, after the fluid's own. <see cref="Particles"/> is another buffer then.</summary>
        /// <param name="depth">Depth of the water, d.</param>
        public void Record(in StepContext step, float depth)
        {
            CommandBuffer cmd = step.Commands;
            Scales = new FoamScales(step.Input.foam, math.length(step.Input.gravity), depth, step.Layout.Spacing, step.Input.timeStep, step.Substeps);
            cmd.BeginSample(Marker);
            RecordSources(step);
            RecordAverages(step);

            RecordMove(step);
            prefixSum.Record(cmd, groupCounts, sums, foamGroups + fluidGroups + 1);

            Buffers.Swap(ref particles, ref moved);
            Buffers.Bind(cmd, shader, compact);
            cmd.DispatchCompute(shader, compact, arguments, GpuBuffer.DispatchArgumentsAt);

            RecordSpawn(cmd, step.Particles);
            cmd.EndSample(Marker);
        }

        /// <summary>Asks for the counts as the commands executed so far leave them. Nothing while some are pending.</summary>
        public void Request() => readback.Request();

        /// <summary>The newest counts that have come back since the last <see cref="Clear"/>.</summary>
        public bool TryGetStatistics(out FoamStatistics statistics)
        {
            statistics = readback.HasResult ? FoamStatistics.From(readback.Latest) : default;
            return readback.HasResult;
        }

        public override void Dispose()
        {
            readback?.Dispose();
            prefixSum?.Dispose();
            base.Dispose();
        }

        /// <param name="stage">The stage, or null where none was made.</param>
        public static StageDescription Describe(Foam stage, in StepContext step)
        {
            StepInput input = step.Input;
            bool needed = IsNeeded(input);
            var description = new StageDescription("Foam", needed, needed
                ? Invariant($"at most {input.foam.budget:N0} particles of spray, foam and bubbles") : "no FluidFoam component");
            if (!needed || stage == null)
                return description;
            description.Kernel(stage.findPotentials, 1, stage.keywords.Variant(step));
            description.Kernel(stage.countSpawned, 1, stage.keywords.Variant(step));
            description.Kernel(stage.averageCells, 1);
            description.Kernel(stage.move.For(step.Colliders != null), 1);
            stage.prefixSum.Describe(description, 1);
            description.Kernel(stage.compact, 1);
            description.Kernel(stage.spawn, 1);
            description.Kernel(stage.commit, 1);
            stage.Buffers.Describe(description);
            return description;
        }

        static readonly uint[] NoParticles = { 0, 1, 0, 0, 1, 1, 1, 0, 0, 2, 0, 0 };      // as StoreArguments writes it

        void RecordSources(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            ParticleBuffers fluid = step.Particles;
            keywords.Record(step);
            step.BindConstants(sources);
            cmd.SetComputeVectorParam(sources, Ids.FoamLimits, Scales.Limits);
            cmd.SetComputeVectorParam(sources, Ids.FoamRates, Scales.Rates);
            cmd.SetComputeIntParam(sources, Ids.FoamSeed, step.Input.foamSeed);
            cmd.SetComputeIntParam(sources, Ids.FirstGroup, foamGroups);
            cmd.SetComputeIntParam(sources, Ids.FluidGroups, fluidGroups);

            BindLists(step, findPotentials);
            cmd.SetComputeBufferParam(sources, findPotentials, ParticleIds.Velocities, fluid.Velocities);
            cmd.DispatchCompute(sources, findPotentials, fluid.SortedArguments, GpuBuffer.DispatchArgumentsAt);

            BindLists(step, countSpawned);
            cmd.SetComputeBufferParam(sources, countSpawned, ParticleIds.Ids, fluid.Ids);
            Buffers.Bind(cmd, sources, countSpawned);
            cmd.DispatchCompute(sources, countSpawned, fluid.SortedArguments, GpuBuffer.DispatchArgumentsAt);
        }

        void BindLists(in StepContext step, int kernel)
        {
            CommandBuffer cmd = step.Commands;
            step.Lists.Bind(cmd, sources, kernel);
            step.Particles.Bind(cmd, sources, kernel);
            Buffers.Bind(cmd, sources, kernel);
        }

        void RecordAverages(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            step.BindConstants(shader);
            cmd.SetComputeVectorParam(shader, Ids.FoamCellSize, new float4(cellSize, step.Input.timeStep));
            cmd.SetComputeVectorParam(shader, Ids.FoamGravity,
                new float4(step.Input.gravity / step.Layout.Spacing, (float)(FoamScales.Rise * Scales.Speed)));
            cmd.SetComputeIntParams(shader, Ids.FoamCellCounts, cellCounts);
            cmd.SetComputeIntParams(shader, Ids.CellsPerFoamCell, cellsPerFoamCell);
            cmd.SetComputeFloatParam(shader, Ids.FoamLifetime, step.Input.foam.lifetime);
            cmd.SetComputeIntParam(shader, Ids.FoamKinds, (int)step.Input.foam.kinds);
            cmd.SetComputeIntParam(shader, Ids.FoamBudget, Budget);
            cmd.SetComputeIntParam(shader, Ids.FoamGroups, foamGroups);
            cmd.SetComputeIntParam(shader, Ids.FluidGroups, fluidGroups);
            cmd.SetComputeIntParam(shader, Ids.FoamSeed, step.Input.foamSeed);

            cmd.SetComputeBufferParam(shader, averageCells, ParticleIds.CellStarts, step.Search.CellStarts);
            cmd.SetComputeBufferParam(shader, averageCells, ParticleIds.Velocities, step.Particles.Velocities);
            Buffers.Bind(cmd, shader, averageCells);
            CoarseGrid.Dispatch(cmd, shader, averageCells, cellTotal);
        }

        void RecordMove(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            int kernel = move.For(step.Colliders != null);
            step.Colliders?.BindShapes(cmd, shader, kernel);
            Buffers.Bind(cmd, shader, kernel);
            cmd.DispatchCompute(shader, kernel, arguments, GpuBuffer.DispatchArgumentsAt);
        }

        void RecordSpawn(CommandBuffer cmd, ParticleBuffers fluid)
        {
            fluid.Bind(cmd, shader, spawn);
            Buffers.Bind(cmd, shader, spawn);
            cmd.DispatchCompute(shader, spawn, fluid.SortedArguments, GpuBuffer.DispatchArgumentsAt);

            Buffers.Bind(cmd, shader, commit);
            cmd.DispatchCompute(shader, commit, 1, 1, 1);
        }

        static class Ids
        {
            public static readonly int FoamCounters = Shader.PropertyToID("_FoamCounters");
            public static readonly int FoamLimits = Shader.PropertyToID("_FoamLimits");
            public static readonly int FoamRates = Shader.PropertyToID("_FoamRates");
            public static readonly int FoamSeed = Shader.PropertyToID("_FoamSeed");
            public static readonly int FirstGroup = Shader.PropertyToID("_FirstGroup");
            public static readonly int FluidGroups = Shader.PropertyToID("_FluidGroups");
            public static readonly int FoamGroups = Shader.PropertyToID("_FoamGroups");
            public static readonly int FoamCellSize = Shader.PropertyToID("_FoamCellSize");
            public static readonly int FoamGravity = Shader.PropertyToID("_FoamGravity");
            public static readonly int FoamCellCounts = Shader.PropertyToID("_FoamCellCounts");
            public static readonly int CellsPerFoamCell = Shader.PropertyToID("_CellsPerFoamCell");
            public static readonly int FoamLifetime = Shader.PropertyToID("_FoamLifetime");
            public static readonly int FoamKinds = Shader.PropertyToID("_FoamKinds");
            public static readonly int FoamBudget = Shader.PropertyToID("_FoamBudget");
        }
    }
}
