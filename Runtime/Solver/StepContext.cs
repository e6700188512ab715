using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Common data of the stages of a step: their command buffer, the particles and their lists, and the stages that others read. One
    /// is made for each step.</summary>
    readonly struct StepContext
    {
        /// <summary>Null where stages are described and nothing is recorded.</summary>
        public readonly CommandBuffer Commands;
        /// <summary><see cref="SolverConstants"/> of the step.</summary>
        public readonly GraphicsBuffer Constants;
        public readonly ParticleBuffers Particles;
        public readonly NeighborSearch Search;
        /// <summary>Until the substep has built its own, those of the substep before.</summary>
        public readonly NeighborLists Lists;
        public readonly SolverLayout Layout;
        public readonly StepInput Input;
        /// <summary>Length of a substep, s.</summary>
        public readonly float SubstepTime;
        /// <summary>Null without deep water.</summary>
        public readonly CoarseCorrection Coarse;
        /// <summary>Null where nothing sleeps.</summary>
        public readonly RestingRegions Resting;
        /// <summary>Null without colliders.</summary>
        public readonly Colliders Colliders;
        /// <summary>Null where velocities are those of a first-order step.</summary>
        public readonly VelocityExtrapolation Extrapolation;
        /// <summary>Null where all phases have one material.</summary>
        public readonly MaterialTable Materials;
        /// <summary>uint [capacity], see ParticleTags.hlsl; null without tags. A sort moves them.</summary>
        public GraphicsBuffer Tags => tags?.Current;
        /// <summary>Buffer in which the stages after the constraint leave the velocities: the particles' own, or another from which a later
        /// stage fills it.</summary>
        public readonly GraphicsBuffer NewVelocities;

        readonly ParticleTags tags;

        /// <param name="newVelocities">Null for the particles' own buffer.</param>
        public StepContext(CommandBuffer commands, GraphicsBuffer constants, ParticleBuffers particles, NeighborSearch search,
            NeighborLists lists, SolverLayout layout, in StepInput input,
            CoarseCorrection coarse = null, RestingRegions resting = null, Colliders colliders = null, VelocityExtrapolation extrapolation = null,
            GraphicsBuffer newVelocities = null, MaterialTable materials = null, ParticleTags tags = null)
        {
            Commands = commands;
            Constants = constants;
            Particles = particles;
            Search = search;
            Lists = lists;
            Layout = layout;
            Input = input;
            SubstepTime = input.SubstepTime;
            Coarse = coarse;
            Resting = resting;
            Colliders = colliders;
            Extrapolation = extrapolation;
            NewVelocities = newVelocities ?? particles.Velocities;
            Materials = materials;
            this.tags = tags;
        }

        /// <summary>Whether a stage after the velocity update visits the neighbors, and smooths the velocities there.</summary>
        public bool SmoothsLater => NewVelocities != Particles.Velocities;

        public int Substeps => Input.settings.substeps;

        /// <summary>Records the step's constants as what a shader reads.</summary>
        public void BindConstants(ComputeShader shader)
            => Commands.SetComputeConstantBufferParam(shader, SolverIds.Constants, Constants, 0, Constants.stride);

        /// <summary>Records those of the coarse grid, which has to be there.</summary>
        public void BindCoarseConstants(ComputeShader shader)
            => Commands.SetComputeConstantBufferParam(shader, CoarseIds.Constants, Coarse.Constants, 0, Coarse.Constants.stride);

        /// <summary>Records the neighbor lists, and which regions sleep, as what a kernel reads or builds.</summary>
        public void BindLists(ComputeShader shader, int kernel)
        {
            Lists.Bind(Commands, shader, kernel);
            BindAsleep(shader, kernel);
        }

        /// <summary>Records the particles listed by cell as they are, after <see cref="NeighborSearch.RecordOrderAtRest"/>.</summary>
        public void BindOrderAtRest(ComputeShader shader, int kernel)
            => ParticleIds.Cells.Bind(Commands, shader, kernel, Search.CellStartsAtRest, Search.CellOrder);

        /// <summary>Records which regions sleep, where any can.</summary>
        public void BindAsleep(ComputeShader shader, int kernel) => Resting?.Bind(Commands, shader, kernel);

        /// <summary>Records where a kernel wakes regions that particles come to or leave, where any can sleep.</summary>
        public void BindWaking(ComputeShader shader, int kernel) => Resting?.BindMotion(Commands, shader, kernel);

        /// <summary>Whether regions can sleep, so that kernels look which do.</summary>
        public bool MaySleep => Resting != null;
    }
}
