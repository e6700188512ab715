using System;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

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
        [SharedWithHlsl("Emitters")] public const int MaxCandidates = 16384;

        /// <summary>nothing is put nearer to a particle, d</summary>
        [SharedWithHlsl("Emitters")] public const float Clearance = 0.7f;

        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Emit");

        readonly ComputeShader shader = StageShader.LoadCompute("Emitters");
        readonly KernelVariants findRoom;     // with colliders
        readonly Kernel emit;
        readonly int reset;
        readonly LocalKeyword sleep, withTags;
        readonly GraphicsBuffer[] positionBuffers = new GraphicsBuffer[StepSources.MaxEmitters];
        readonly EmitterPositions[] uploaded = new EmitterPositions[StepSources.MaxEmitters];
        GraphicsBuffer free;

        public Emitters() : this(DeviceLimits.Current) { }

        public Emitters(in DeviceLimits limits)
        {
            findRoom = new KernelVariants(shader, "FindRoom", "FindRoomWithColliders");
            emit = new Kernel(shader, limits.Holds("Emitters", "Emit") ? "Emit" : "Emit" + KernelNeed.Small);
            reset = shader.FindKernel("Reset");
            sleep = new LocalKeyword(shader, RestingRegions.Keyword);
            withTags = new LocalKeyword(shader, ParticleTags.Keyword);
            free = GpuBuffer.Structured<uint>("Rill.Emitters.Free", MaxCandidates);
            States = new EmitterStates();
        }

        public EmitterStates States { get; private set; }

        public static bool IsNeeded(StepSources sources) => sources != null && (sources.emitterCount > 0 || sources.goneEmitters != 0);

        /// <summary>Records what all emitters do in a step, one after the other, after its last substep.</summary>
        /// <param name="tags">Null for none.</param>
        public void Record(in StepContext step, uint stepIndex, ParticleTags tags)
        {
            CommandBuffer cmd = step.Commands;
            cmd.BeginSample(Marker);
            StepSources sources = step.Input.sources;
            RestingRegions.RecordKeyword(cmd, shader, sleep, step.Resting);
            cmd.SetKeyword(shader, withTags, tags != null);
            step.BindConstants(shader);
            for (int number = 0; number < StepSources.MaxEmitters; number++)
                if ((sources.goneEmitters >> number & 1) != 0)
                    RecordReset(cmd, step.Particles, number);
            for (int e = 0; e < sources.emitterCount; e++)
                Record(step, e, stepIndex, tags);
            cmd.EndSample(Marker);
        }

        public void Dispose()
        {
            for (int number = 0; number < positionBuffers.Length; number++)
                GpuBuffer.Release(ref positionBuffers[number]);
            GpuBuffer.Release(ref free);
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
                ? $"{sources.emitterCount} emitters, each tried for room at the end of a step" : "no emitter");
            if (!needed || stage == null)
                return description;
            string variant = RestingRegions.Variant(tags != null ? ParticleTags.Keyword : null, step.Resting);
            description.Kernel("Emitters", stage.findRoom.For(step.Colliders != null).Name, sources.emitterCount, variant);
            description.Kernel("Emitters", stage.emit.Name, sources.emitterCount, variant);
            description.Buffer("Rill.Emitters.States", stage.States.Buffer);
            description.Buffer("Rill.Emitters.Free", stage.free);
            foreach (GraphicsBuffer positions in stage.positionBuffers)
                description.Buffer("Rill.Emitters.Positions", positions);
            return description;
        }

        void Record(in StepContext step, int index, uint stepIndex, ParticleTags tags)
        {
            CommandBuffer cmd = step.Commands;
            ParticleBuffers particles = step.Particles;
            int find = findRoom.For(step.Colliders != null).Index, emit = this.emit.Index;
            step.Colliders?.BindShapes(cmd, shader, find);
            step.Colliders?.BindVolume(cmd, shader, find);
            ref EmitterStep emitter = ref step.Input.sources.emitters[index];
            float duration = step.Input.timeStep;
            RecordParameters(cmd, emitter, duration, SeesNew(step.Input.sources, index, duration), stepIndex);
            GraphicsBuffer positions = PositionsOf(emitter);

            cmd.SetComputeBufferParam(shader, find, Ids.EmitterPositions, positions);
            cmd.SetComputeBufferParam(shader, find, Ids.CellStarts, step.Search.CellStarts);
            cmd.SetComputeBufferParam(shader, find, Ids.Positions, particles.Current);
            cmd.SetComputeBufferParam(shader, find, Ids.Free, free);
            cmd.SetComputeBufferParam(shader, find, Ids.EmitterStates, States.Buffer);
            cmd.SetComputeBufferParam(shader, find, Ids.Counters, particles.Counters);
            cmd.DispatchCompute(shader, find, ParticleBuffers.Groups(emitter.candidates), 1, 1);

            cmd.SetComputeBufferParam(shader, emit, Ids.EmitterPositions, positions);
            cmd.SetComputeBufferParam(shader, emit, Ids.Positions, particles.Current);
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

        void RecordParameters(CommandBuffer cmd, in EmitterStep emitter, float step, bool seesNew, uint stepIndex)
        {
            cmd.SetComputeVectorParam(shader, Ids.Origin, new float4(emitter.end.position, emitter.speed));
            cmd.SetComputeVectorParam(shader, Ids.LastOrigin, new float4(emitter.start.position, 0f));
            float4 rotation = emitter.end.rotation.value, lastRotation = emitter.start.rotation.value;
            cmd.SetComputeVectorParam(shader, Ids.Rotation, rotation);
            cmd.SetComputeVectorParam(shader, Ids.LastRotation, math.dot(rotation, lastRotation) < 0f ? -lastRotation : lastRotation);
            cmd.SetComputeVectorParam(shader, Ids.Velocity, new float4(emitter.velocity, 0f));
            cmd.SetComputeVectorParam(shader, Ids.Spin, new float4(emitter.spin, 0f));
            cmd.SetComputeVectorParam(shader, Ids.Instants, new Vector4(emitter.firstAge, emitter.interval, step, emitter.cosSpread));
            cmd.SetComputeIntParam(shader, Ids.Emitter, emitter.number);
            cmd.SetComputeIntParam(shader, Ids.Due, emitter.due);
            cmd.SetComputeIntParam(shader, Ids.FirstSerial, (int)emitter.firstSerial);
            cmd.SetComputeIntParam(shader, Ids.LayerPositions, emitter.layerPositions);
            cmd.SetComputeIntParam(shader, Ids.PositionCount, emitter.positions.Count);
            cmd.SetComputeIntParam(shader, Ids.Candidates, emitter.candidates);
            cmd.SetComputeIntParam(shader, Ids.MaxWaiting, emitter.maxWaiting);
            cmd.SetComputeIntParam(shader, Ids.Fills, emitter.positions.FillsVolume ? 1 : 0);
            cmd.SetComputeIntParam(shader, Ids.SeesNew, seesNew ? 1 : 0);
            cmd.SetComputeIntParam(shader, Ids.IsLast, emitter.isLast ? 1 : 0);
            cmd.SetComputeIntParam(shader, Ids.Tag, (int)emitter.TagIn(stepIndex));
        }

        void RecordReset(CommandBuffer cmd, ParticleBuffers particles, int number)
        {
            cmd.SetComputeIntParam(shader, Ids.Emitter, number);
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
            public static readonly int Positions = Shader.PropertyToID("_Positions");
            public static readonly int Velocities = Shader.PropertyToID("_Velocities");
            public static readonly int ParticleIds = Shader.PropertyToID("_Ids");
            public static readonly int Free = Shader.PropertyToID("_Free");
            public static readonly int EmitterStates = Shader.PropertyToID("_EmitterStates");
            public static readonly int Counters = Shader.PropertyToID("_Counters");
            public static readonly int AliveArguments = Shader.PropertyToID("_AliveArguments");
            public static readonly int Origin = Shader.PropertyToID("_Origin");
            public static readonly int LastOrigin = Shader.PropertyToID("_LastOrigin");
            public static readonly int Rotation = Shader.PropertyToID("_Rotation");
            public static readonly int LastRotation = Shader.PropertyToID("_LastRotation");
            public static readonly int Velocity = Shader.PropertyToID("_Velocity");
            public static readonly int Spin = Shader.PropertyToID("_Spin");
            public static readonly int Instants = Shader.PropertyToID("_Instants");
            public static readonly int Emitter = Shader.PropertyToID("_Emitter");
            public static readonly int Due = Shader.PropertyToID("_Due");
            public static readonly int FirstSerial = Shader.PropertyToID("_FirstSerial");
            public static readonly int LayerPositions = Shader.PropertyToID("_LayerPositions");
            public static readonly int PositionCount = Shader.PropertyToID("_PositionCount");
            public static readonly int Candidates = Shader.PropertyToID("_Candidates");
            public static readonly int MaxWaiting = Shader.PropertyToID("_MaxWaiting");
            public static readonly int Fills = Shader.PropertyToID("_Fills");
            public static readonly int SeesNew = Shader.PropertyToID("_SeesNew");
            public static readonly int IsLast = Shader.PropertyToID("_IsLast");
            public static readonly int Tag = Shader.PropertyToID("_Tag");
        }
    }
}
