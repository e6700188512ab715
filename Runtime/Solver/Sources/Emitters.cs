using System;
using System.Collections.Generic;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Puts the particles of emitters into the fluid at the end of a step. Made when first needed.</summary>
    /// <remarks>
    /// At its end, because then the grid of the step's sort still holds the particles in their order, so that room is found
    /// without another sort, and because a particle that leaves the emitter within the step is then where it has got to.
    /// </remarks>
    sealed class Emitters : Stage
    {
        /// <summary>most positions that one emitter tries in a step</summary>
        [GenerateHlsl("Emitters")] public const int MaxCandidates = 16384;

        /// <summary>nothing is put nearer to a particle, d</summary>
        [GenerateHlsl("Emitters")] public const float Clearance = 0.7f;

        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Emit");

        readonly ComputeShader shader = StageShader.LoadCompute("Emitters");
        readonly KernelVariants feel, press, findRoom;     // with colliders
        readonly Kernel emit;
        readonly Kernel reset;
        readonly StepKeywords keywords;
        readonly LocalKeyword withTags;
        readonly GraphicsBuffer[] positionBuffers = new GraphicsBuffer[StepSources.MaxEmitters];
        readonly EmitterPositions[] uploaded = new EmitterPositions[StepSources.MaxEmitters];
        // copied as it is recorded
        readonly EmitterConstants[] upload = new EmitterConstants[1];
        readonly GraphicsBuffer constants;

        public Emitters() : this(DeviceLimits.Current) { }

        /// <param name="errors">Learns of results that the device did not give; may be null.</param>
        public Emitters(in DeviceLimits limits, ReadbackErrors errors = null)
        {
            feel = new KernelVariants(shader, "Feel", "FeelWithColliders");
            press = new KernelVariants(shader, "Press", "PressWithColliders");
            findRoom = new KernelVariants(shader, "FindRoom", "FindRoomWithColliders");
            emit = new Kernel(shader, limits.Holds("Emitters", "Emit") ? "Emit" : "Emit" + KernelNeed.Small);
            reset = new Kernel(shader, "Reset");
            keywords = new StepKeywords(shader, readsLists: false, skipsAsleep: true);
            withTags = new LocalKeyword(shader, ParticleTags.Keyword);
            States = new EmitterStates(errors);
            Buffers.AddShared("Rill.Emitters.States", States.Buffer, "_EmitterStates");
            Buffers.Structured<uint>("Rill.Emitters.Free", MaxCandidates);
            constants = Buffers.Constants<EmitterConstants>("Rill.Emitters.Constants", "RillEmitter");
        }

        public EmitterStates States { get; private set; }

        public override bool Survives(ParticleChange change)
        {
            if (change == ParticleChange.Restarted)
                States.Clear();
            return true;
        }

        public override void ListState(List<StateBuffer> state) => States.ListState(state);

        public static bool IsNeeded(StepSources sources) => sources != null && (sources.emitterCount > 0 || sources.goneEmitters != 0);

        /// <summary>Records what all emitters do in a substep, one after the other, at its end.</summary>
        /// <param name="substep">Its index.</param>
        /// <param name="tags">Null for none.</param>
        public void Record(in StepContext step, int substep, uint stepIndex, ParticleTags tags)
        {
            bool isLast = substep == step.Substeps - 1;

            CommandBuffer cmd = step.Commands;
            cmd.BeginSample(Marker);
            StepSources sources = step.Input.sources;
            keywords.Record(step);
            cmd.SetKeyword(shader, withTags, tags != null);
            step.BindConstants(shader);
            for (int number = 0; number < StepSources.MaxEmitters; number++)
                if (substep == 0 && (sources.goneEmitters >> number & 1) != 0)
                    RecordReset(cmd, step.Particles, number);
            for (int e = 0; e < sources.emitterCount; e++)
                if (isLast || sources.emitters[e].EmitsInSubsteps)
                    Record(step, e, substep, stepIndex, tags);
            cmd.EndSample(Marker);
        }

        public override void Dispose()
        {
            for (int number = 0; number < positionBuffers.Length; number++)
                GpuBuffer.Release(ref positionBuffers[number]);
            States?.Dispose();
            States = null;
            base.Dispose();
        }

        /// <param name="stage">The stage, or null where none was made.</param>
        /// <param name="tags">Null for none.</param>
        public static StageDescription Describe(Emitters stage, in StepContext step, ParticleTags tags)
        {
            StepSources sources = step.Input.sources;
            bool needed = IsNeeded(sources);
            var description = new StageDescription("Emitters", needed, needed
                ? Invariant($"{sources.emitterCount} emitters, each tried for room at the end of a step") : "no emitter");
            if (!needed || stage == null)
                return description;
            string variant = stage.keywords.Variant(step, tags != null ? ParticleTags.Keyword : null);
            description.Kernel(stage.findRoom.For(step.Colliders != null), sources.emitterCount, variant);
            description.Kernel(stage.emit, sources.emitterCount, variant);
            stage.Buffers.Describe(description);
            foreach (GraphicsBuffer positions in stage.positionBuffers)
                description.Buffer("Rill.Emitters.Positions", positions);
            return description;
        }

        void Record(in StepContext step, int index, int substep, uint stepIndex, ParticleTags tags)
        {
            CommandBuffer cmd = step.Commands;
            ParticleBuffers particles = step.Particles;
            int find = findRoom.For(step.Colliders != null), emit = this.emit;
            step.Colliders?.BindShapes(cmd, shader, find);
            EmitterStep emitter = step.Input.sources.emitters[index];
            float duration = step.Input.timeStep;
            if (emitter.EmitsInSubsteps)
            {
                emitter = emitter.Part(substep, step.Substeps, duration);
                duration = step.SubstepTime;
            }
            EmitterConstants values = EmitterConstants.For(emitter, duration, SeesNew(step.Input.sources, index, duration), stepIndex, step.Layout);
            Upload(cmd, values);
            GraphicsBuffer positions = PositionsOf(emitter);

            if (values.pressCells > 0)
            {
                RecordBefore(step, feel, values.pressCells);
                RecordBefore(step, press, values.pressCells);
            }

            Ids.Find.Bind(cmd, shader, find, positions, step.Search.CellStarts);
            particles.Bind(cmd, shader, find);
            Buffers.Bind(cmd, shader, find);
            cmd.DispatchCompute(shader, find, ParticleBuffers.Groups(emitter.candidates), 1, 1);

            Ids.Emit.Bind(cmd, shader, emit, positions, tags?.Current);
            particles.Bind(cmd, shader, emit);
            Buffers.Bind(cmd, shader, emit);
            step.BindWaking(shader, emit);
            cmd.DispatchCompute(shader, emit, 1, 1, 1);
        }

        // Records kernels that read or move the water before an outlet.
        void RecordBefore(in StepContext step, KernelVariants variants, int cells)
        {
            CommandBuffer cmd = step.Commands;
            ParticleBuffers particles = step.Particles;
            int kernel = variants.For(step.Colliders != null);
            step.Colliders?.BindShapes(cmd, shader, kernel);
            particles.Bind(cmd, shader, kernel);
            cmd.SetComputeBufferParam(shader, kernel, ParticleIds.CellStarts, step.Search.CellStarts);
            Buffers.Bind(cmd, shader, kernel);
            step.BindWaking(shader, kernel);
            cmd.DispatchCompute(shader, kernel, ParticleBuffers.Groups(cells), 1, 1);
        }

        void Upload(CommandBuffer cmd, in EmitterConstants values)
        {
            upload[0] = values;
            cmd.SetBufferData(constants, upload);
        }

        void RecordReset(CommandBuffer cmd, ParticleBuffers particles, int number)
        {
            Upload(cmd, new EmitterConstants { emitter = number });
            Buffers.Bind(cmd, shader, reset);
            particles.Bind(cmd, shader, reset);
            cmd.DispatchCompute(shader, reset, 1, 1, 1);
            States.Invalidate(number);
            GpuBuffer.Release(ref positionBuffers[number]);
            uploaded[number] = null;
        }

        // Returns whether another emitter put particles nearby in this step, which are not in the grid yet.
        static bool SeesNew(StepSources sources, int index, float step)
        {
            ref EmitterStep emitter = ref sources.emitters[index];
            for (int before = 0; before < index; before++)
            {
                ref EmitterStep other = ref sources.emitters[before];
                if (math.distance(emitter.end.position, other.end.position) < emitter.Reach(step) + other.Reach(step) + (float)LatticeKernels.Support)
                    return true;
            }
            return false;
        }

        GraphicsBuffer PositionsOf(in EmitterStep emitter)
        {
            ref GraphicsBuffer buffer = ref positionBuffers[emitter.number];
            if (uploaded[emitter.number] == emitter.positions)
                return buffer;
            GpuBuffer.Release(ref buffer);
            buffer = GpuBuffer.Structured<float4>("Rill.Emitters.Positions", emitter.positions.Data.Length);
            buffer.SetData(emitter.positions.Data);
            uploaded[emitter.number] = emitter.positions;
            return buffer;
        }

        static class Ids
        {
            public static readonly ShaderParameters Find = new ShaderParameters("_EmitterPositions", "_CellStarts");
            public static readonly ShaderParameters Emit = new ShaderParameters("_EmitterPositions", "_Tags");
        }
    }
}
