using System;
using System.Runtime.InteropServices;
using Unity.Collections;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Shape of a detector.</summary>
    [GenerateHlsl("Queries")]
    public enum DetectorShape
    {
        /// <summary>A box with sides along the axes of the object.</summary>
        Box,
        /// <summary>A sphere.</summary>
        Sphere,
        /// <summary>A capsule along the object's y axis.</summary>
        Capsule,
        /// <summary>A mesh, by its baked signed distance field, with the object's scale, which has to be even.</summary>
        Mesh,
    }

    /// <summary>A detector at the end of a step; lengths in d, in the domain's frame.</summary>
    [GenerateHlsl("Queries")]
    [StructLayout(LayoutKind.Sequential)]
    struct DetectorRegion
    {
        /// <summary>from its own frame to the domain's, quaternion</summary>
        public float4 rotation;
        /// <summary>d</summary>
        public float3 center;
        /// <summary>a <see cref="DetectorShape"/></summary>
        public uint shape;
        /// <summary>box: half sides; sphere and capsule: x radius, y half the straight part; mesh: half of its field, negative where
        /// mirrored</summary>
        public float3 size;
        /// <summary>mesh: d for a meter of its field</summary>
        public float fieldUnit;
        /// <summary>lowest corner of what it can find particles in, d</summary>
        public float3 low;
        /// <summary>mesh: half a voxel of its field, d</summary>
        public float halfVoxel;
        /// <summary>and the highest</summary>
        public float3 high;
        public float unused;
    }

    /// <summary>Words of a probe's result; floats by their bits.</summary>
    [GenerateHlsl("Queries", Prefix = "Probe")]
    enum ProbeWord
    {
        /// <summary>relative to rest</summary>
        Density,
        /// <summary>and 2, 3: d/s</summary>
        Velocity,
        Phase = Velocity + 3,
        /// <summary>of the surface over the probe, against gravity, d</summary>
        Height,
        /// <summary>and 7, 8: out of the water, length 1</summary>
        Normal,
        /// <summary>and 10, 11: d/s</summary>
        SurfaceVelocity = Normal + 3,
        /// <summary>of <see cref="ProbeFlag"/></summary>
        Flags = SurfaceVelocity + 3,
    }

    /// <summary>Flags of a probe's result.</summary>
    [Flags, GenerateHlsl("Queries")]
    enum ProbeFlag
    {
        /// <summary>particles within the kernel's support</summary>
        NearWater = 1,
        /// <summary>on the line along gravity</summary>
        HasSurface = 2,
    }

    /// <summary>Queries of one state; lengths in d, in the domain's frame.</summary>
    sealed class QueryInput
    {
        /// <summary>xyz within the domain.</summary>
        public readonly float4[] points = new float4[Queries.MaxProbes];
        /// <summary>Those that are meshes come last.</summary>
        public readonly DetectorRegion[] detectors = new DetectorRegion[Queries.MaxDetectors];
        /// <summary>Signed distance fields of the detectors that are meshes.</summary>
        public readonly Texture3D[] fields = new Texture3D[Queries.MaxDetectors];
        public int pointCount, detectorCount, meshCount;
        /// <summary>Against gravity, length 1; 0 without gravity.</summary>
        public float3 up;
    }

    /// <summary>Answers what probes and detectors ask of the state that a step left, without waiting. Made when first needed.</summary>
    sealed class Queries : Stage
    {
        /// <summary>Most probes of one simulation.</summary>
        public const int MaxProbes = 64;

        /// <summary>most detectors of one simulation</summary>
        [GenerateHlsl("Queries")] public const int MaxDetectors = 32;

        /// <summary>phases of particles</summary>
        [GenerateHlsl("Queries")] public const int Phases = 8;

        /// <summary>words of a probe's result</summary>
        [GenerateHlsl("Queries")] public const int ProbeWords = 16;

        /// <summary>words of a detector's result: 64-bit sums, of the velocity along x, y, z and of the volume of each phase</summary>
        [GenerateHlsl("Queries")] public const int DetectorWords = 2 * (3 + Phases);

        /// <summary>steps of a particle's volume</summary>
        [GenerateHlsl("Queries")] public const double VolumeScale = 65536.0;

        /// <summary>steps of a particle's velocity times its volume, 1 d/s</summary>
        [GenerateHlsl("Queries")] public const double VelocityScale = 256.0;

        /// <summary>Requests that may be pending: an answer to each frame, though it comes some frames later.</summary>
        public const int RingSize = 4;

        const int FirstDetectorWord = MaxProbes * ProbeWords;
        const int Words = FirstDetectorWord + MaxDetectors * DetectorWords;

        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Queries");

        readonly QueryShader shader;
        readonly ReadbackRing ring;
        readonly uint[] zeros = new uint[MaxDetectors * DetectorWords];
        readonly GraphicsBuffer points, found, detectors;

        /// <param name="errors">Learns of results that the device did not give; may be null.</param>
        public Queries(QueryShader shader, ReadbackErrors errors = null)
        {
            this.shader = shader;
            points = Buffers.Structured<float4>("Rill.Queries.Points", MaxProbes);
            found = Buffers.Structured<uint>("Rill.Queries.Found", MaxProbes);
            detectors = Buffers.Structured<DetectorRegion>("Rill.Queries.Detectors", MaxDetectors);
            BufferClear.Now(found);
            ring = new ReadbackRing("Rill.Queries.Results", RingSize, Words, slot => Arrived?.Invoke(slot));
            ring.Report(errors, ReadbackKinds.Queries);
        }

        /// <summary>Called with the slot of each result when it has come; in the order of the requests.</summary>
        public Action<int> Arrived;

        /// <summary>Slot of the next request; -1 while all are pending.</summary>
        public int FreeSlot => ring.Free();

        /// <summary>Records the answers to a slot; call <see cref="Request"/> after the commands ran. Right after a step, before anything
        /// sorts again.</summary>
        public void Record(in StepContext step, ParticleTags tags, QueryInput input, int slot)
        {
            CommandBuffer cmd = step.Commands;
            GraphicsBuffer results = ring.Buffer(slot);
            cmd.BeginSample(Marker);
            var asked = new PointBuffers { points = points, found = found, count = input.pointCount, up = input.up };
            if (input.pointCount > 0)
                cmd.SetBufferData(points, input.points, 0, 0, input.pointCount);
            if (input.detectorCount > 0)
            {
                cmd.SetBufferData(detectors, input.detectors, 0, 0, input.detectorCount);
                cmd.SetBufferData(results, zeros, 0, FirstDetectorWord, input.detectorCount * DetectorWords);
            }
            // All uploads first, and the detectors beside the search, which writes elsewhere: the GPU waits once before and once after both.
            if (input.pointCount > 0)
                shader.SearchPoints(step, tags, asked);
            if (input.detectorCount > 0)
            {
                int simple = input.detectorCount - input.meshCount;
                shader.RecordDetectors(step, tags, detectors, results, FirstDetectorWord, simple, input.fields, input.meshCount);
            }
            if (input.pointCount > 0)
                shader.AnswerPoints(step, tags, asked, results);
            cmd.EndSample(Marker);
        }

        /// <summary>Asks for what was recorded for a slot, after its command buffer was executed.</summary>
        public void Request(int slot) => ring.Request(slot);

        /// <summary>Waits for the results that are pending, and for nothing else.</summary>
        public void Complete() => ring.Complete();

        /// <summary>Results from before a restart are dropped when they come.</summary>
        public override bool Survives(ParticleChange change)
        {
            if (change == ParticleChange.Restarted)
                ring.Invalidate();
            return true;
        }

        /// <summary>Returns the results of a slot: from <see cref="ProbeWords"/> times its number on, the words of each probe.</summary>
        public NativeArray<uint> Latest(int slot) => ring.Latest(slot);

        /// <summary>A sum of a detector's result: 0 to 2 velocity times volume in particles, d/s; from 3 on the volume of each phase, in
        /// particles.</summary>
        public double DetectorSum(int slot, int index, int sum)
        {
            NativeArray<uint> words = ring.Latest(slot);
            int at = FirstDetectorWord + index * DetectorWords + 2 * sum;
            return (long)((ulong)words[at + 1] << 32 | words[at]) / (sum < 3 ? VelocityScale : VolumeScale);
        }

        public override void Dispose()
        {
            Arrived = null;
            ring?.Dispose();
            base.Dispose();
        }

        /// <param name="stage">The stage, or null where none was made.</param>
        public static StageDescription Describe(Queries stage, QueryInput input, ParticleTags tags)
        {
            int probes = input?.pointCount ?? 0, regions = input?.detectorCount ?? 0;
            bool needed = stage != null && probes + regions > 0;
            var description = new StageDescription("Queries", needed, needed
                ? Invariant($"{probes} probes and {regions} detectors, once a frame, outside the step") : "no probe and no detector");
            if (!needed)
                return description;
            if (probes > 0)
                stage.shader.DescribePoints(description, tags);
            if (regions > 0)
                stage.shader.DescribeDetectors(description, tags, regions - input.meshCount, input.meshCount);
            stage.Buffers.Describe(description);
            stage.ring.Describe(description);
            return description;
        }
    }
}
