using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Buffers and kernels that passes and readbacks of a project need of the particles. Made when first needed.</summary>
    sealed class ParticleAccess : Stage
    {
        /// <summary>threads of a kernel over the particles</summary>
        [GenerateHlsl("RillParticles", Prefix = "Rill")] public const int Threads = ParticleBuffers.Group;

        /// <summary>along x; more fold into y</summary>
        [GenerateHlsl("RillParticles", Prefix = "Rill")] public const int MaxGroups = ThreadGroups.MaxGroups;

        /// <summary>word of _RillCounters: particles alive</summary>
        [GenerateHlsl("RillParticles", Prefix = "Rill")] public const int Alive = (int)ParticleCounter.Alive;

        /// <summary>word of _RillCounters: particles that took part in the last step, the first of those alive</summary>
        [GenerateHlsl("RillParticles", Prefix = "Rill")] public const int Moved = (int)ParticleCounter.Moved;

        /// <summary>of the phase in a tag</summary>
        [GenerateHlsl("RillParticles", Prefix = "Rill")] public const int PhaseShift = ParticleTags.PhaseShift;

        /// <summary>bits of a tag that are not the phase</summary>
        [GenerateHlsl("RillParticles", Prefix = "Rill")] public const uint TagStepMask = ParticleTags.StepMask;

        /// <summary>instead of the density of a particle that goes</summary>
        [GenerateHlsl("RillParticles", Prefix = "Rill")] public const float Killed = -1f;

        /// <summary>words before the first field of a copy</summary>
        [GenerateHlsl("ParticleAccess")] public const int CopyHeader = 4;

        /// <summary>instead of the first word of a field that is not copied</summary>
        [GenerateHlsl("ParticleAccess")] public const uint NotCopied = uint.MaxValue;

        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Kill");

        readonly ComputeShader shader = StageShader.LoadCompute("ParticleAccess");
        readonly KernelVariants removeKilled;     // where water sleeps
        readonly Kernel orderById, copyOut;

        public ParticleAccess()
        {
            removeKilled = new KernelVariants(shader, "RemoveKilled", "RemoveKilledAsleep");
            orderById = new Kernel(shader, "OrderById");
            copyOut = new Kernel(shader, "CopyOut");
        }

        /// <summary>Records the removal of the particles that a pass has marked.</summary>
        public void RecordKills(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            ParticleBuffers particles = step.Particles;
            int kernel = removeKilled.For(step.MaySleep);
            cmd.BeginSample(Marker);
            step.BindConstants(shader);
            particles.Bind(cmd, shader, kernel);
            step.BindWaking(shader, kernel);
            particles.DispatchAlive(cmd, shader, kernel);
            cmd.EndSample(Marker);
        }

        /// <summary>Records which particles lie in each cell of the search at the current positions: its cell starts, and the particles by
        /// cell into SortedIds, which is free between steps.</summary>
        public void RecordOrder(in StepContext step)
        {
            step.Search.RecordOrderAtRest(step);
            step.Commands.SetComputeBufferParam(shader, orderById, Ids.OrderById, step.Particles.SortedIds);
            step.Search.DispatchOrdered(step.Commands, shader, orderById, step.Particles, step.Search.CellStartsAtRest);
        }

        /// <summary>Records a copy of the particles in world space.</summary>
        /// <param name="hasTags">Whether <paramref name="tags"/> are those of the particles, and not what stands for them.</param>
        public void RecordCopy(CommandBuffer cmd, ParticleBuffers particles, GraphicsBuffer tags, bool hasTags, Matrix4x4 domainToWorld,
            in ParticleCopyLayout layout, GraphicsBuffer copy)
        {
            cmd.SetComputeMatrixParam(shader, Ids.DomainToWorld, domainToWorld);
            Ids.Copy.Bind(cmd, shader, copyOut, hasTags, tags, copy);
            Ids.Layout.Bind(cmd, shader, copyOut, layout.PositionsAt, layout.VelocitiesAt, layout.IdsAt, layout.PhasesAt);
            particles.Bind(cmd, shader, copyOut);
            particles.DispatchAlive(cmd, shader, copyOut);
        }

        /// <param name="noTags">What stands for the tags; null while no script has read the particles.</param>
        /// <param name="stage">The stage, or null where none was made.</param>
        public static StageDescription Describe(ParticleAccess stage, in StepContext step, GraphicsBuffer noTags)
        {
            StepInput input = step.Input;
            bool needed = input.removesKilled || noTags != null;
            var description = new StageDescription("Particle access", needed, input.removesKilled
                ? "a pass of a script may remove particles" : needed ? "a script reads the particles" : "no script reads the particles");
            if (input.removesKilled && stage != null)
                description.Kernel(stage.removeKilled.For(step.MaySleep), 1);
            description.Buffer("Rill.NoTags", noTags);
            return description;
        }

        static class Ids
        {
            public static readonly int OrderById = Shader.PropertyToID("_OrderById");
            public static readonly ShaderParameters Copy = new ShaderParameters("_HasTags", "_Tags", "_Copy");
            public static readonly ShaderParameters Layout = new ShaderParameters("_PositionsAt", "_VelocitiesAt", "_IdsAt", "_PhasesAt");
            public static readonly int DomainToWorld = Shader.PropertyToID("_DomainToWorld");
        }
    }
}
