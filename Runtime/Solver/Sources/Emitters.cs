using System;
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
    sealed class Emitters : IDisposable
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
        readonly LocalKeyword sleep, withTags;
        readonly GraphicsBuffer[] positionBuffers = new GraphicsBuffer[StepSources.MaxEmitters];
        readonly EmitterPositions[] uploaded = new EmitterPositions[StepSources.MaxEmitters];
        // copied as it is recorded
        readonly EmitterConstants[] upload = new EmitterConstants[1];
        GraphicsBuffer free, constants;

        public Emitters() : this(DeviceLimits.Current) { }

        /// <param name="errors">Learns of results that the device did not give; may be null.</param>
        public Emitters(in DeviceLimits limits, ReadbackErrors errors = null)
        {
            feel = new KernelVariants(shader, "Feel", "FeelWithColliders");
            press = new KernelVariants(shader, "Press", "PressWithColliders");
            findRoom = new KernelVariants(shader, "FindRoom", "FindRoomWithColliders");
            emit = new Kernel(shader, limits.Holds("Emitters", "Emit") ? "Emit" : "Emit" + KernelNeed.Small);
            reset = new Kernel(shader, "Reset");
            sleep = new LocalKeyword(shader, RestingRegions.Keyword);
            withTags = new LocalKeyword(shader, ParticleTags.Keyword);
            free = GpuBuffer.Structured<uint>("Rill.Emitters.Free", MaxCandidates);
            constants = GpuBuffer.Constants<EmitterConstants>("Rill.Emitters.Constants");
            States = new EmitterStates(errors);
        }

        public EmitterStates States { get; private set; }

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
            RestingRegions.RecordKeyword(cmd, shader, sleep, step.Resting);
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

        public void Dispose()
        {
            for (int number = 0; number < positionBuffers.Length; number++)
                GpuBuffer.Release(ref positionBuffers[number]);
            GpuBuffer.Release(ref free);
            GpuBuffer.Release(ref constants);
            States?.Dispose();
            States = null;
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
            string variant = RestingRegions.Variant(tags != null ? ParticleTags.Keyword : null, step.Resting);
            description.Kernel(stage.findRoom.For(step.Colliders != null), sources.emitterCount, variant);
            description.Kernel(stage.emit, sources.emitterCount, variant);
            description.Buffer("Rill.Emitters.States", stage.States.Buffer);
            description.Buffer("Rill.Emitters.Free", stage.free);
            description.Buffer("Rill.Emitters.Constants", stage.constants);
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
            step.Colliders?.BindVolume(cmd, shader, find);
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

            cmd.SetComputeBufferParam(shader, find, Ids.EmitterPositions, positions);
            cmd.SetComputeBufferParam(shader, find, Ids.CellStarts, step.Search.CellStarts);
            cmd.SetComputeBufferParam(shader, find, Ids.Positions, particles.Positions);
            cmd.SetComputeBufferParam(shader, find, Ids.Free, free);
            cmd.SetComputeBufferParam(shader, find, Ids.EmitterStates, States.Buffer);
            cmd.SetComputeBufferParam(shader, find, Ids.Counters, particles.Counters);
            cmd.DispatchCompute(shader, find, ParticleBuffers.Groups(emitter.candidates), 1, 1);

            cmd.SetComputeBufferParam(shader, emit, Ids.EmitterPositions, positions);
            cmd.SetComputeBufferParam(shader, emit, Ids.Positions, particles.Positions);
            cmd.SetComputeBufferParam(shader, emit, Ids.Velocities, particles.Velocities);
            cmd.SetComputeBufferParam(shader, emit, Ids.ParticleIds, particles.Ids);
            cmd.SetComputeBufferParam(shader, emit, Ids.Free, free);
            cmd.SetComputeBufferParam(shader, emit, Ids.EmitterStates, States.Buffer);
            cmd.SetComputeBufferParam(shader, emit, Ids.Counters, particles.Counters);
            cmd.SetComputeBufferParam(shader, emit, Ids.AliveArguments, particles.AliveArguments);
            if (tags != null)
                cmd.SetComputeBufferParam(shader, emit, ParticleTags.Ids.Tags, tags.Current);
            step.Resting?.BindMotion(cmd, shader, emit);
            cmd.DispatchCompute(shader, emit, 1, 1, 1);
        }

        // What looks at the water before an outlet, or moves it.
        void RecordBefore(in StepContext step, KernelVariants variants, int cells)
        {
            CommandBuffer cmd = step.Commands;
            ParticleBuffers particles = step.Particles;
            int kernel = variants.For(step.Colliders != null);
            step.Colliders?.BindShapes(cmd, shader, kernel);
            step.Colliders?.BindVolume(cmd, shader, kernel);
            cmd.SetComputeBufferParam(shader, kernel, Ids.Counters, particles.Counters);
            cmd.SetComputeBufferParam(shader, kernel, Ids.CellStarts, step.Search.CellStarts);
            cmd.SetComputeBufferParam(shader, kernel, Ids.StartPositions, particles.Start);
            cmd.SetComputeBufferParam(shader, kernel, Ids.Positions, particles.Positions);
            cmd.SetComputeBufferParam(shader, kernel, Ids.Velocities, particles.Velocities);
            cmd.SetComputeBufferParam(shader, kernel, Ids.EmitterStates, States.Buffer);
            step.Resting?.BindMotion(cmd, shader, kernel);
            cmd.DispatchCompute(shader, kernel, ParticleBuffers.Groups(cells), 1, 1);
        }

        void Upload(CommandBuffer cmd, in EmitterConstants values)
        {
            upload[0] = values;
            cmd.SetBufferData(constants, upload);
            cmd.SetComputeConstantBufferParam(shader, Ids.Constants, constants, 0, constants.stride);
        }

        void RecordReset(CommandBuffer cmd, ParticleBuffers particles, int number)
        {
            Upload(cmd, new EmitterConstants { emitter = number });
            cmd.SetComputeBufferParam(shader, reset, Ids.EmitterStates, States.Buffer);
            cmd.SetComputeBufferParam(shader, reset, Ids.Counters, particles.Counters);
            cmd.DispatchCompute(shader, reset, 1, 1, 1);
            States.Invalidate(number);
            GpuBuffer.Release(ref positionBuffers[number]);
            uploaded[number] = null;
        }

        // What another put nearby in this step is not in the grid yet.
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
            public static readonly int EmitterPositions = Shader.PropertyToID("_EmitterPositions");
            public static readonly int CellStarts = Shader.PropertyToID("_CellStarts");
            public static readonly int StartPositions = Shader.PropertyToID("_StartPositions");
            public static readonly int Positions = Shader.PropertyToID("_Positions");
            public static readonly int Velocities = Shader.PropertyToID("_Velocities");
            public static readonly int ParticleIds = Shader.PropertyToID("_Ids");
            public static readonly int Free = Shader.PropertyToID("_Free");
            public static readonly int EmitterStates = Shader.PropertyToID("_EmitterStates");
            public static readonly int Counters = Shader.PropertyToID("_Counters");
            public static readonly int AliveArguments = Shader.PropertyToID("_AliveArguments");
            public static readonly int Constants = Shader.PropertyToID("RillEmitter");
        }
    }
}
