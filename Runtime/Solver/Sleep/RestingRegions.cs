using System;
using System.Collections.Generic;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>
    /// States of a region. Particles asleep are not moved. Those at the edge still have lists and multipliers, which their neighbors that
    /// move push against; the others are further from all that moves than any kernel reaches.
    /// </summary>
    [GenerateHlsl("RestingRegions")]
    enum RegionState { Asleep, AsleepAtEdge, Awake }

    /// <summary>
    /// Lets water that has come to rest sleep, by regions of the box: its particles stay where they are and most of a
    /// step's passes skip them. Made when first needed.
    /// </summary>
    sealed class RestingRegions : Stage
    {
        /// <summary>side of a region, d</summary>
        [GenerateHlsl("RestingRegions")] public const float RegionSize = 8f;

        /// <summary>How long a region is at rest before it sleeps, s.</summary>
        public const float Delay = 0.5f;

        /// <summary>Speed of one particle that wakes its region, over that of a region: well above the jitter of water at rest.</summary>
        public const float JitterRatio = 25f;

        /// <summary>Keyword of the kernels that leave out what sleeps.</summary>
        public const string Keyword = "RILL_SLEEP";

        /// <summary>words of a region in _RegionMotion</summary>
        [GenerateHlsl("RestingRegions")] const int MotionStride = 5;

        const int TensionBytes = 2 * sizeof(float);     // of a material, before the last: tension and angle
        const int GrainBytes = 2 * sizeof(float);       // before contacts: friction and cohesion
        const int ContactBytes = sizeof(int);           // the last, with what fills up the struct
        const float GravityChange = 0.01f;      // fraction of it that wakes everything

        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Rest");

        readonly ComputeShader shader = StageShader.LoadCompute("RestingRegions");
        readonly Kernel measureMotion, countQuiet, spread;
        readonly int total;
        readonly GraphicsBuffer motion, quietSteps, states;
        StepInput last;
        RestRecord? restored;
        bool wake = true;

        public RestingRegions(SolverLayout layout)
        {
            measureMotion = new Kernel(shader, "MeasureMotion");
            countQuiet = new Kernel(shader, "CountQuiet");
            spread = new Kernel(shader, "Spread");
            total = Total(layout);
            motion = Buffers.Structured<uint>("Rill.Regions.Motion", (long)total * MotionStride);
            quietSteps = Buffers.Structured<uint>("Rill.Regions.QuietSteps", total);
            states = Buffers.Structured<uint>("Rill.Regions.States", total);
            BufferClear.Now(motion, quietSteps);
        }

        /// <summary>uint [regions], 0 asleep, 1 asleep beside what is awake, 2 awake; x first.</summary>
        public GraphicsBuffer States => states;

        /// <summary>Whether the regions of a snapshot are those of a layout.</summary>
        public static bool Fits(SolverLayout layout, SnapshotContents contents)
        {
            long bytes = sizeof(uint) * (long)Total(layout);
            return contents.Bytes(SnapshotSection.QuietSteps).Length == bytes && contents.Bytes(SnapshotSection.RegionMotion).Length
                == MotionStride * bytes;
        }

        /// <summary>Confined vortices are there to keep moving, so with them nothing sleeps.</summary>
        public static bool IsNeeded(in StepInput input) => input.settings.sleepSpeed > 0f && !VorticityConfinement.IsNeeded(input);

        public override void ListState(List<StateBuffer> state)
        {
            state.Add(new StateBuffer(SnapshotSection.RegionMotion, motion, StateExtent.All));
            state.Add(new StateBuffer(SnapshotSection.QuietSteps, quietSteps, StateExtent.All));
        }

        /// <summary>Returns the state besides buffers that the next step depends on.</summary>
        public RestRecord Save()
        {
            RestRecord record = restored ?? new RestRecord
            {
                gravity = last.gravity,
                timeStep = last.timeStep,
                settings = Crc32C.Of(StructBytes.Of(ref last.settings)),
                material = Checksum(last.material),
            };
            record.wake = wake ? 1u : 0u;
            return record;
        }

        /// <summary>Takes what was saved: the next step wakes what rests only where it would have, had there been no end.</summary>
        public void Load(in RestRecord record)
        {
            restored = record;
            wake = record.wake != 0;
        }

        /// <summary>Wakes everything in the next step.</summary>
        public void Wake() => wake = true;

        public override bool Survives(ParticleChange change)
        {
            Wake();
            return true;
        }

        /// <summary>Records what rests in this substep, from the particles at its start.</summary>
        public void Record(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            ParticleBuffers particles = step.Particles;
            float dt = step.SubstepTime;
            float path = step.Input.settings.sleepSpeed * dt / step.Layout.Spacing;
            wake |= HasChanged(step.Input);
            cmd.BeginSample(Marker);
            step.BindConstants(shader);
            Ids.Sleep.Bind(cmd, shader, measureMotion, path, JitterRatio * path, (int)math.ceil(Delay / dt), wake);
            particles.Bind(cmd, shader, measureMotion);
            Buffers.Bind(cmd, shader, measureMotion);
            cmd.DispatchCompute(shader, measureMotion, particles.AliveArguments, GpuBuffer.DispatchArgumentsAt);

            Buffers.Bind(cmd, shader, countQuiet);
            CoarseGrid.Dispatch(cmd, shader, countQuiet, total);

            Buffers.Bind(cmd, shader, spread);
            CoarseGrid.Dispatch(cmd, shader, spread, total);
            cmd.EndSample(Marker);
            wake = false;
        }

        /// <summary>Records what a kernel looks up. The shader's keyword is that of <see cref="StepKeywords"/>.</summary>
        public void Bind(CommandBuffer cmd, ComputeShader shader, int kernel) => cmd.SetComputeBufferParam(shader, kernel, Ids.RegionStates, states);

        /// <summary>Records where a kernel wakes regions that particles come to or leave.</summary>
        public void BindMotion(CommandBuffer cmd, ComputeShader shader, int kernel)
            => cmd.SetComputeBufferParam(shader, kernel, Ids.RegionMotion, motion);

        /// <param name="regions">The stage, or null where none was made.</param>
        public static StageDescription Describe(RestingRegions regions, in StepInput input)
        {
            bool needed = IsNeeded(input);
            string reason = needed ? Invariant($"what is slower than {input.settings.sleepSpeed} m/s for {Delay} s sleeps, in regions ") +
                Invariant($"of {RegionSize} spacings")
                : input.settings.sleepSpeed > 0f ? "vorticity confinement keeps the water moving" : "the sleep speed is 0";
            var description = new StageDescription("Resting regions", needed, reason);
            if (!needed || regions == null)
                return description;
            description.Kernel(regions.measureMotion, input.settings.substeps);
            description.Kernel(regions.countQuiet, input.settings.substeps);
            description.Kernel(regions.spread, input.settings.substeps);
            regions.Buffers.Describe(description);
            return description;
        }

        /// <summary>Checksum of a material. One without contacts, friction or surface tension has that from before there was any, for
        /// older snapshots.</summary>
        public static uint Checksum(FluidMaterial material)
        {
            ReadOnlySpan<byte> bytes = StructBytes.Of(ref material);
            bool isGranular = material.frictionAngle != 0f || material.cohesion != 0f;
            int newer = material.contacts ? 0 : ContactBytes;
            if (newer > 0 && !isGranular)
                newer += material.surfaceTension != 0f ? GrainBytes : GrainBytes + TensionBytes;
            return Crc32C.Of(bytes.Slice(0, bytes.Length - newer));
        }

        static int Total(SolverLayout layout)
        {
            int3 counts = math.max((int3)math.ceil(layout.DomainSize / RegionSize), 1);
            return counts.x * counts.y * counts.z;
        }

        // Rest is rest under these forces and settings: all of both structs, so that a field that is added to one counts by itself.
        bool HasChanged(in StepInput input)
        {
            if (restored is RestRecord before)
            {
                StepInput now = input;
                bool same = Crc32C.Of(StructBytes.Of(ref now.settings)) == before.settings
                    && Checksum(now.material) == before.material;
                last = same ? input : default;
                last.gravity = before.gravity;
                last.timeStep = before.timeStep;
                restored = null;
            }
            bool changed = math.distance(input.gravity, last.gravity) > GravityChange * math.length(last.gravity) || input.timeStep != last.timeStep
                || !StructBytes.AreSame(input.settings, last.settings) || !StructBytes.AreSame(input.material, last.material)
                || !StructBytes.AreSame(input.phases, last.phases);
            if (changed)
                last = input;
            return changed;
        }

        static class Ids
        {
            public static readonly int RegionMotion = Shader.PropertyToID("_RegionMotion");
            public static readonly int RegionStates = Shader.PropertyToID("_RegionStates");
            public static readonly ShaderParameters Sleep = new ShaderParameters(
                "_SleepDisplacement", "_JitterDisplacement", "_StepsToSleep", "_Wake");
        }
    }
}
