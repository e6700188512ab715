using System;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Air with smoke in a fluid's box, once a step: see Smoke.compute. Made when first needed.</summary>
    /// <remarks>A grid of its own with the cells, the colliders and the V-cycles of deep water, but full: heat lifts its air (Boussinesq), whose
    /// density is that of the fresh air. The fluid feels nothing of it.</remarks>
    sealed class Smoke : Stage
    {
        /// <summary>Most cells of a grid: a larger one gets larger cells.</summary>
        public const int MaxCells = 1 << 20;

        /// <summary>V-cycles of a solve. With one a plume leaves a tenth of its divergence.</summary>
        const int Cycles = 2;

        /// <summary>Shift of the potential, for each d of the box's longest side, d: a flow that moves so far in a step stays above 0.</summary>
        const float ShiftPerLength = 8f;

        /// <summary>Time after which the heat of a source is another, s. A flame of some decimeters flickers so.</summary>
        const float FlickerTime = 0.2f;

        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Smoke");

        readonly ComputeShader shader = StageShader.LoadCompute("Smoke");
        readonly Kernel findWater, move, correct, findCurls, shade;
        readonly KernelVariants addForces;                      // with vorticity confinement
        readonly KernelVariants findDivergence, project;        // with colliders
        readonly CoarseGrid grid;
        readonly CoarseSolver solver;
        readonly GraphicsBuffer coarseConstants, constants, sources, waterCells, source, diagonal, potential;
        readonly SmokeConstants[] values = new SmokeConstants[1];
        readonly float wantedSize;
        readonly int nodes, waterTotal;
        GraphicsBuffer flow, nextFlow, air, nextAir;
        CoarseColliders colliders;
        RenderTexture volume;

        /// <param name="cellSize">Wanted side of a cell, d.</param>
        /// <exception cref="ArgumentOutOfRangeException">More than the device can bind.</exception>
        public Smoke(SolverLayout layout, float cellSize, in DeviceLimits limits)
        {
            wantedSize = cellSize;
            findWater = new Kernel(shader, "FindWater");
            move = new Kernel(shader, "Move");
            correct = new Kernel(shader, "Correct");
            findCurls = new Kernel(shader, "FindCurls");
            addForces = new KernelVariants(shader, "AddForces", "AddForcesAndConfine");
            findDivergence = new KernelVariants(shader, "FindDivergence", "FindDivergenceWithColliders");
            project = new KernelVariants(shader, "Project", "ProjectWithColliders");
            shade = new Kernel(shader, "Shade");
            CoarseSolverPath path = CoarseSolverPath.For(limits);
            grid = new CoarseGrid(layout.DomainSize, CellSizeFor(layout.DomainSize, cellSize), path.TailCells);
            int3 counts = grid.Counts + 1, blocks = (layout.CellCounts + layout.CellsPerRadius - 1) / layout.CellsPerRadius;
            nodes = counts.x * counts.y * counts.z;
            waterTotal = blocks.x * blocks.y * blocks.z;
            values[0].waterCounts = (uint3)blocks;
            values[0].cellsPerWaterCell = (uint3)layout.CellsPerRadius;
            values[0].potentialShift = ShiftPerLength * math.cmax(layout.DomainSize);
            try
            {
                solver = new CoarseSolver(grid, path) { Cycles = Cycles };
                coarseConstants = Buffers.Constants<CoarseConstants>("Rill.Smoke.CoarseConstants", "RillCoarse");
                constants = Buffers.Constants<SmokeConstants>("Rill.Smoke.Constants", "RillSmoke");
                sources = Buffers.Structured<SmokeRegion>("Rill.Smoke.Sources", StepSources.MaxSmokeSources);
                waterCells = Buffers.Structured<float4>("Rill.Smoke.WaterCells", waterTotal);
                flow = Buffers.Structured<float>("Rill.Smoke.Flow", 3L * nodes);
                nextFlow = Buffers.Structured<float>("Rill.Smoke.NextFlow", 3L * nodes);
                Buffers.Structured<float>("Rill.Smoke.MovedFlow", 3L * nodes);
                air = Buffers.Structured<float>("Rill.Smoke.Air", 2L * grid.Total);
                nextAir = Buffers.Structured<float>("Rill.Smoke.NextAir", 2L * grid.Total);
                Buffers.Structured<float>("Rill.Smoke.MovedAir", 2L * grid.Total);
                Buffers.Structured<float4>("Rill.Smoke.Curls", grid.Total);
                source = Buffers.Structured<float>("Rill.Smoke.Source", grid.Total);
                diagonal = Buffers.Structured<float>("Rill.Smoke.Diagonal", grid.Total);
                potential = Buffers.Structured<float>("Rill.Smoke.Potential", grid.Total);
                sources.SetData(new SmokeRegion[StepSources.MaxSmokeSources]);
                coarseConstants.SetData(new[] { CoarseConstants.For(grid) });
                volume = GpuTexture.Create("Rill.Smoke.Volume", new RenderTextureDescriptor(grid.Counts.x, grid.Counts.y,
                    GraphicsFormat.R16G16B16A16_SFloat, GraphicsFormat.None)
                { dimension = TextureDimension.Tex3D, volumeDepth = grid.Counts.z, enableRandomWrite = true }, FilterMode.Bilinear);
                Clear();
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        /// <summary>Cells of the grid along each axis.</summary>
        public int3 Counts => grid.Counts;

        /// <summary>Side of a cell along each axis, d.</summary>
        public float3 CellSize => grid.CellSize;

        /// <summary>float [3, nodes], velocities at the cells' low faces, d/s; see SmokeGrid.hlsl.</summary>
        public GraphicsBuffer Flow => flow;

        /// <summary>float [2, cells], temperature above that of the fresh air, K, then extinction of light, 1/m.</summary>
        public GraphicsBuffer Air => air;

        /// <summary>Half floats as <see cref="RecordShade"/> left them: x extinction, 1/m; y the part of the sun that comes there; z K.</summary>
        public RenderTexture Volume => volume;

        /// <summary>Steps since it was made; what draws it looks whether it is the same.</summary>
        public int Steps { get; private set; }

        public static bool IsNeeded(in StepInput input) => input.hasSmoke;

        public override bool Fits(PbfSolver pbf, in StepInput step) => wantedSize == WantedSize(step, pbf.Layout.Spacing);

        public override bool Survives(ParticleChange change)
        {
            Clear();
            return true;
        }

        /// <summary>Wanted side of a cell, d.</summary>
        public static float WantedSize(in StepInput step, float spacing) => step.smoke.cellSize > 0f ? step.smoke.cellSize / spacing : 1f;

        /// <summary>Side of a cell, d: the wanted one, or a larger where a grid would have too many cells.</summary>
        public static float CellSizeFor(float3 domainSize, float wanted)
        {
            int most = SystemInfo.maxTexture3DSize;
            float size = math.max(wanted, 0.25f);
            for (float3 counts = math.round(domainSize / size); math.cmax(counts) > most || counts.x * counts.y * counts.z > MaxCells;
                counts = math.round(domainSize / size))
                size *= 1.1f;
            return size;
        }

        /// <summary>Leaves still air without smoke, at once.</summary>
        public void Clear() => BufferClear.Now(flow, air, potential);

        /// <summary>Records a step, after the fluid's own.</summary>
        public void Record(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            cmd.BeginSample(Marker);
            Upload(step);
            step.BindConstants(shader);
            RecordWater(step);
            if (step.Colliders == null)
            {
                colliders?.Dispose();
                colliders = null;
            }
            else
            {
                colliders ??= new CoarseColliders(grid);
                colliders.Record(step, coarseConstants);
            }

            Dispatch(cmd, move, nodes);
            Dispatch(cmd, correct, nodes);
            Buffers.Swap(ref flow, ref nextFlow);
            Buffers.Swap(ref air, ref nextAir);
            bool confines = step.Input.smoke.vorticity > 0f;
            if (confines)
                Dispatch(cmd, findCurls, grid.Total);
            Dispatch(cmd, addForces.For(confines), nodes);
            Dispatch(cmd, findDivergence.For(colliders != null), grid.Total);
            solver.Record(cmd, coarseConstants, source, diagonal, potential, colliders);
            Dispatch(cmd, project.For(colliders != null), nodes);
            Steps++;
            cmd.EndSample(Marker);
        }

        /// <summary>Records what a draw reads: <see cref="Volume"/>.</summary>
        /// <param name="light">Unit vector to the sun in the domain's frame.</param>
        /// <param name="spacing">m.</param>
        public void RecordShade(CommandBuffer cmd, float3 light, float spacing)
        {
            cmd.BeginSample(Marker);
            float size = math.cmin(grid.CellSize);
            Ids.Shade.Bind(cmd, shader, shade, new float4(light * size / grid.CellSize, size * spacing), volume);
            Dispatch(cmd, shade, grid.Total);
            cmd.EndSample(Marker);
        }

        public override void Dispose()
        {
            solver?.Dispose();
            colliders?.Dispose();
            colliders = null;
            EngineObject.Release(ref volume);
            base.Dispose();
        }

        /// <param name="stage">The stage, or null where none was made.</param>
        public static StageDescription Describe(Smoke stage, in StepContext step)
        {
            bool needed = IsNeeded(step.Input);
            var description = new StageDescription("Smoke", needed, needed ? "component FluidSmoke" : "no FluidSmoke component");
            if (!needed || stage == null)
                return description;
            bool withColliders = step.Colliders != null, confines = step.Input.smoke.vorticity > 0f;
            description.Kernel(stage.findWater, 1);
            description.Kernel(stage.move, 1);
            description.Kernel(stage.correct, 1);
            if (confines)
                description.Kernel(stage.findCurls, 1);
            description.Kernel(stage.addForces.For(confines), 1);
            description.Kernel(stage.findDivergence.For(withColliders), 1);
            stage.solver.Describe(description, Cycles, 0, withColliders);
            stage.colliders?.Describe(description, 1);
            description.Kernel(stage.project.For(withColliders), 1);
            description.Kernel(stage.shade, 1);
            stage.Buffers.Describe(description);
            description.Texture(stage.volume);
            return description;
        }

        void Upload(in StepContext step)
        {
            SmokeSettings settings = step.Input.smoke;
            float time = step.Input.timeStep;
            ref SmokeConstants to = ref values[0];
            to.smokeGravity = step.Input.gravity / step.Layout.Spacing;
            to.smokeStep = time;
            to.openSides = (uint)settings.openSides;
            to.airTemperature = settings.airTemperature - SmokeSettings.AbsoluteZero;
            to.heatKept = settings.cooling > 0f ? math.exp(-time / settings.cooling) : 1f;
            to.densityKept = settings.lifetime > 0f ? math.exp(-time / settings.lifetime) : 1f;
            to.smokeVorticity = settings.vorticity;
            to.steamDensity = settings.steam;
            to.steamHeat = settings.steamTemperature - settings.airTemperature;
            to.flickerSteps = (uint)math.max(math.round(FlickerTime / time), 1f);
            StepSources from = step.Input.sources;
            to.sourceCount = (uint)(from?.smokeCount ?? 0);
            step.Commands.SetBufferData(constants, values);
            if (to.sourceCount > 0)
                step.Commands.SetBufferData(sources, from.smoke, 0, 0, (int)to.sourceCount);
        }

        void RecordWater(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            Ids.Water.Bind(cmd, shader, findWater, step.Search.CellStarts, step.Particles.Velocities);
            Dispatch(cmd, findWater, waterTotal);
        }

        void Dispatch(CommandBuffer cmd, int kernel, int threads)
        {
            colliders?.Bind(cmd, shader, kernel);
            Buffers.Bind(cmd, shader, kernel);
            CoarseGrid.Dispatch(cmd, shader, kernel, threads);
        }

        static class Ids
        {
            public static readonly ShaderParameters Shade = new ShaderParameters("_LightAlong", "_SmokeVolume");
            public static readonly ShaderParameters Water = new ShaderParameters("_CellStarts", "_Velocities");
        }
    }
}
