using System;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>
    /// The particles of a <see cref="FluidSimulation"/> on the GPU, for compute passes, draws and effects of a project. Take it again in
    /// every frame, and in every pass before a step: a step sorts the particles, and its buffers change roles.
    /// </summary>
    /// <remarks>
    /// Lengths in the buffers are in particle spacings d, in the frame of the box, whose lowest corner is 0; <see cref="DomainToWorld"/> leads
    /// to world space. How many particles are alive is known on the GPU alone; they are the first of each buffer. Include
    /// <c>Packages/com.rill.fluids/Shaders/RillParticles.hlsl</c> in a shader, and <see cref="Bind(CommandBuffer, ComputeShader, int)"/> sets
    /// all that it reads. Only a pass of <see cref="FluidSimulation.BeforeStep"/> may write, and only velocities and phases.
    /// </remarks>
    public readonly struct FluidParticles
    {
        /// <summary>Threads of a group of a kernel that <see cref="Dispatch"/> takes; <c>kRillThreads</c> in HLSL.</summary>
        public const int ThreadsPerGroup = ParticleAccess.Threads;

        /// <summary>Vertices of a particle in <see cref="DrawArguments"/>.</summary>
        public const int VerticesPerParticle = GpuBuffer.VerticesPerParticle;

        readonly FluidSimulation fluid;
        readonly PbfSolver solver;
        readonly int version;

        internal FluidParticles(FluidSimulation fluid)
        {
            this.fluid = fluid;
            solver = fluid.Solver;
            version = solver.StateVersion;
            DomainToWorld = fluid.DomainToWorld;
        }

        /// <summary>Whether these are the particles of the fluid's current state. False after a step, a restart, and once the fluid is off.</summary>
        public bool IsCurrent => solver != null && solver == fluid.Solver && solver.StateVersion == version;

        /// <summary>Most particles: the length of the buffers.</summary>
        public int Capacity => Current.Layout.Capacity;

        /// <summary>Distance between particles at rest, d, m.</summary>
        public float Spacing => Current.Layout.Spacing;

        /// <summary>From the box's frame, in d, to world space, m.</summary>
        public Matrix4x4 DomainToWorld { get; }

        /// <summary>float4 each: xyz position, d.</summary>
        /// <exception cref="InvalidOperationException">Not <see cref="IsCurrent"/>; as for all members but that one.</exception>
        public GraphicsBuffer Positions => Current.Positions;

        /// <summary>float4 each: xyz velocity against the box, d/s; w density relative to rest, where something sums it.</summary>
        public GraphicsBuffer Velocities => Current.Velocities;

        /// <summary>uint each: a number that stays with the particle and is not given again until the fluid starts again.</summary>
        public GraphicsBuffer Ids => Current.ParticleIds;

        /// <summary>uint each: the phase, 0 to 255, in the highest byte. Null where no emitter gives phases or lifetimes and
        /// <see cref="FluidSimulation.TrackPhases"/> is off.</summary>
        public GraphicsBuffer Phases => Current.Tags;

        /// <summary>uint each: the first is the number of particles alive.</summary>
        public GraphicsBuffer Counts => Current.Counters;

        /// <summary>For Graphics.RenderPrimitivesIndirect, command 0: an instance with <see cref="VerticesPerParticle"/> vertices for each
        /// particle alive.</summary>
        public GraphicsBuffer DrawArguments => Current.DrawArguments;

        /// <summary>
        /// Records all that RillParticles.hlsl declares for a kernel. Neighbors can be looked up only after
        /// <see cref="SortNeighbors"/> was recorded.
        /// </summary>
        /// <exception cref="ArgumentNullException">No command buffer or no shader.</exception>
        /// <exception cref="InvalidOperationException">Not <see cref="IsCurrent"/>, or the stage ParticleAccess is not in this build.</exception>
        public void Bind(CommandBuffer commands, ComputeShader shader, int kernel)
        {
            PbfSolver from = Current;
            NotNull(commands, nameof(commands));
            NotNull(shader, nameof(shader));
            Frame frame = FrameOf(from);
            NameIds.Buffers.Bind(commands, shader, kernel, from.Positions, from.StartPositions, from.Velocities, from.ParticleIds,
                from.TagsToBind, from.Counters, from.CellStarts, from.ParticleOrder);
            commands.SetComputeMatrixParam(shader, NameIds.DomainToWorld, DomainToWorld);
            NameIds.Frame.Bind(commands, shader, kernel, frame.Domain, frame.Cells, frame.InverseCellSize, frame.Step);
        }

        /// <summary>Sets all that RillParticles.hlsl declares for a draw of this frame.</summary>
        /// <exception cref="ArgumentNullException">No property block.</exception>
        /// <exception cref="InvalidOperationException">Not <see cref="IsCurrent"/>, or the stage ParticleAccess is not in this build.</exception>
        public void Bind(MaterialPropertyBlock properties)
        {
            PbfSolver from = Current;
            NotNull(properties, nameof(properties));
            Frame frame = FrameOf(from);
            NameIds.Buffers.Set(properties, from.Positions, from.StartPositions, from.Velocities, from.ParticleIds, from.TagsToBind,
                from.Counters, from.CellStarts, from.ParticleOrder);
            properties.SetMatrix(NameIds.DomainToWorld, DomainToWorld);
            NameIds.Frame.Set(properties, frame.Domain, frame.Cells, frame.InverseCellSize, frame.Step);
        }

        /// <summary>Binds a kernel, as <see cref="Bind(CommandBuffer, ComputeShader, int)"/> does, and records it for all particles alive.</summary>
        /// <exception cref="ArgumentException">The kernel's groups are not of <see cref="ThreadsPerGroup"/> threads along x.</exception>
        /// <exception cref="InvalidOperationException">Not <see cref="IsCurrent"/>, or the stage ParticleAccess is not in this build.</exception>
        public void Dispatch(CommandBuffer commands, ComputeShader shader, int kernel)
        {
            Bind(commands, shader, kernel);
            shader.GetKernelThreadGroupSizes(kernel, out uint x, out uint y, out uint z);
            if (x != ThreadsPerGroup || y != 1 || z != 1)
                throw new ArgumentException(Invariant($"Kernel {kernel} of '{shader.name}' has groups of {x} x {y} x {z} threads, and ") +
                    Invariant($"particles are dispatched in groups of {ThreadsPerGroup} x 1 x 1: write [numthreads(kRillThreads, 1, ") +
                    "1)].", nameof(kernel));
            Current.DispatchAlive(commands, shader, kernel);
        }

        /// <summary>
        /// Records the listing of all particles by cell, at their current positions, for the look-up of neighbors in RillParticles.hlsl. It
        /// finds every particle within any radius, until the next step or until particles are added.
        /// </summary>
        /// <exception cref="ArgumentNullException">No command buffer.</exception>
        /// <exception cref="InvalidOperationException">Not <see cref="IsCurrent"/>, or the stage ParticleAccess is not in this build.</exception>
        public void SortNeighbors(CommandBuffer commands)
        {
            PbfSolver from = Current;
            NotNull(commands, nameof(commands));
            from.RecordOrder(commands);
        }

        PbfSolver Current => IsCurrent ? solver : throw new InvalidOperationException("These are the particles of an earlier step, or " +
            "of a fluid that is off or has started again: their buffers have other roles now. Call TryGetParticles again in every frame.");

        Frame FrameOf(PbfSolver from)
        {
            SolverLayout layout = from.Layout;
            StepInput input = fluid.Input;
            Vector4 lag = fluid.Clock.FrameLag;
            // A force in one of several substeps is not taken to last.
            float atOnce = input.settings.substeps == 1 ? VelocityExtrapolation.FractionAtOnce(input) : 1f;
            return new Frame
            {
                Domain = new Vector4(layout.DomainSize.x, layout.DomainSize.y, layout.DomainSize.z, layout.Spacing),
                Cells = new Vector4(layout.CellCounts.x, layout.CellCounts.y, layout.CellCounts.z, from.Tags != null ? 1f : 0f),
                InverseCellSize = new Vector4(1f / layout.CellSize.x, 1f / layout.CellSize.y, 1f / layout.CellSize.z, 0f),
                Step = new Vector4(fluid.FixedStep, fluid.FixedStep * atOnce, lag.x, lag.y),
            };
        }

        static void NotNull(object argument, string name)
        {
            if (argument == null)
                throw new ArgumentNullException(name);
        }

        struct Frame
        {
            public Vector4 Domain, Cells, InverseCellSize, Step;
        }

        static class NameIds
        {
            public static readonly ShaderParameters Buffers = new ShaderParameters(
                "_RillPositions", "_RillStartPositions", "_RillVelocities", "_RillIds", "_RillTags", "_RillCounters", "_RillCellStarts",
                "_RillOrder");
            public static readonly ShaderParameters Frame = new ShaderParameters("_RillDomain", "_RillCells", "_RillInverseCellSize", "_RillStep");
            public static readonly int DomainToWorld = Shader.PropertyToID("_RillDomainToWorld");
        }
    }
}
