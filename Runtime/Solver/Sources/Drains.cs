using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using Unity.Collections;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>A drain in one step; lengths in d, in the domain's frame.</summary>
    [GenerateHlsl("Drains")]
    [StructLayout(LayoutKind.Sequential)]
    struct DrainRegion
    {
        [GenerateHlsl("Drains")] public const uint NoLimit = uint.MaxValue;
        [GenerateHlsl("Drains")] public const uint NoEmitter = uint.MaxValue;

        /// <summary>from its own frame to the domain's, quaternion</summary>
        public float4 rotation;
        /// <summary>a step ago</summary>
        public float4 lastRotation;
        /// <summary>d, in the domain's frame</summary>
        public float3 center;
        public uint isSphere;
        /// <summary>a step ago</summary>
        public float3 lastCenter;
        /// <summary>particles that go in this step at most; kNoLimit for all</summary>
        public uint limit;
        /// <summary>1 over half the box's sides, or over the radius; 1/d</summary>
        public float3 inverseHalf;
        /// <summary>number of the emitter that puts the particles back; kNoEmitter for none</summary>
        public uint emitter;
        /// <summary>of its states, below kMaxDrains</summary>
        public uint number;
    }

    /// <summary>State of each drain that only the GPU knows, words of _DrainStates.</summary>
    [GenerateHlsl("Drains", Prefix = "Drain")]
    enum DrainWord
    {
        /// <summary>particles of the limit that are left from the steps before</summary>
        Carried,
        /// <summary>random ranks below this go in this step</summary>
        RandomRanks,
        /// <summary>since the reset</summary>
        Drained,
    }

    /// <summary>Removes particles in drains and those whose time is over, at the start of a step. Made when first needed.</summary>
    sealed class Drains : Stage
    {
        /// <summary>ranks among which the particles of a drain with a limit draw theirs</summary>
        [GenerateHlsl("Drains")] const int RandomRanks = 1024;

        /// <summary>words of a drain in _DrainStates</summary>
        [GenerateHlsl("Drains", Prefix = "Drain")] public const int Words = 4;

        const string LifetimesKeyword = "RILL_LIFETIMES", RecyclingKeyword = "RILL_RECYCLING";

        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Drain");

        readonly ComputeShader shader = StageShader.LoadCompute("Drains");
        readonly Kernel countRandomRanks, selectRandom, drain;
        readonly StepKeywords keywords;
        readonly LocalKeyword lifetimes, recycling;
        readonly uint[] zeros = new uint[StepSources.MaxDrains * Words];
        readonly Readback readback = new Readback(GpuBuffer.Structured<uint>("Rill.Drains.States", StepSources.MaxDrains * Words));
        readonly GraphicsBuffer regions;
        GraphicsBuffer histogram;
        uint gone;

        /// <param name="errors">Learns of results that the device did not give; may be null.</param>
        public Drains(ReadbackErrors errors = null)
        {
            readback.Report(errors, ReadbackKinds.Drains);
            countRandomRanks = new Kernel(shader, "CountRandomRanks");
            selectRandom = new Kernel(shader, "SelectRandom");
            drain = new Kernel(shader, "Drain");
            keywords = new StepKeywords(shader, readsLists: false, skipsAsleep: true);
            lifetimes = new LocalKeyword(shader, LifetimesKeyword);
            recycling = new LocalKeyword(shader, RecyclingKeyword);
            regions = Buffers.Structured<DrainRegion>("Rill.Drains.Regions", StepSources.MaxDrains, "_Drains");
            Buffers.AddShared("Rill.Drains.States", readback.Buffer, "_DrainStates");
            regions.SetData(new DrainRegion[StepSources.MaxDrains]);
            Clear();
        }

        /// <param name="tags">Null where no particle has a lifetime.</param>
        public static bool IsNeeded(StepSources sources, ParticleTags tags) => sources != null && sources.drainCount > 0 || tags != null;

        /// <summary>No drain has drained anything.</summary>
        public void Clear()
        {
            BufferClear.Now(readback.Buffer);
            readback.Invalidate();
        }

        public override bool Survives(ParticleChange change)
        {
            if (change == ParticleChange.Restarted)
                Clear();
            return true;
        }

        public override void ListState(List<StateBuffer> state)
            => state.Add(new StateBuffer(SnapshotSection.DrainStates, readback.Buffer, StateExtent.All));

        /// <summary>Drains whose numbers go to others: bit d for number d.</summary>
        public void Remove(uint drains) => gone |= drains;

        /// <summary>Records that the drains to forget have taken nothing, also where none takes anything in this step.</summary>
        public void RecordForgotten(CommandBuffer cmd)
        {
            for (int number = 0; gone != 0; number++, gone >>= 1)
                if ((gone & 1) != 0)
                    RecordReset(cmd, number);
        }

        /// <summary>Records what goes, from the particles at the start of a step.</summary>
        /// <param name="lastSubsteps">Number of substeps of the last step.</param>
        /// <param name="emitters">Null where nothing is recycled.</param>
        /// <param name="tags">Null where no particle has a lifetime.</param>
        public void Record(in StepContext step, int lastSubsteps, EmitterStates emitters, ParticleTags tags)
        {
            CommandBuffer cmd = step.Commands;
            ParticleBuffers particles = step.Particles;
            StepSources sources = step.Input.sources;
            cmd.BeginSample(Marker);
            keywords.Record(step);
            cmd.SetKeyword(shader, lifetimes, tags != null);
            cmd.SetKeyword(shader, recycling, emitters != null);
            step.BindConstants(shader);
            int count = sources?.drainCount ?? 0;
            Ids.Drain.Bind(cmd, shader, drain, count, (float)lastSubsteps, tags?.Current, emitters?.Buffer);
            if (count > 0)
                cmd.SetBufferData(regions, sources.drains, 0, 0, count);
            if (count > 0 && sources.limitsDrains)
                RecordRandomSelection(cmd, particles);
            else
                Buffers.Release(ref histogram);

            particles.Bind(cmd, shader, drain);
            Buffers.Bind(cmd, shader, drain);
            step.BindWaking(shader, drain);
            cmd.DispatchCompute(shader, drain, particles.AliveArguments, GpuBuffer.DispatchArgumentsAt);
            cmd.EndSample(Marker);
        }

        /// <summary>Asks for the numbers as the commands executed so far leave them. Nothing while some are pending.</summary>
        public void Request() => readback.Request();

        /// <summary>Waits for the numbers that are pending, and for nothing else.</summary>
        public void Complete() => readback.Complete();

        /// <summary>Particles that a drain has removed, as far as it has come back since the last <see cref="Clear"/>.</summary>
        public int Drained(int number) => readback.HasResult ? (int)readback.Latest[number * Words + (int)DrainWord.Drained] : 0;

        public override void Dispose()
        {
            readback.Dispose();
            base.Dispose();
        }

        /// <param name="stage">The stage, or null where none was made.</param>
        /// <param name="tags">Null where no particle has a lifetime.</param>
        public static StageDescription Describe(Drains stage, in StepContext step, ParticleTags tags)
        {
            StepSources sources = step.Input.sources;
            bool needed = IsNeeded(sources, tags);
            int count = sources?.drainCount ?? 0;
            var description = new StageDescription("Drains", needed, !needed ? "no drain, and no particle has a lifetime"
                : Invariant($"{count} drains{(tags != null ? ", and particles with a lifetime" : "")}"));
            if (!needed || stage == null)
                return description;
            string variant = stage.keywords.Variant(step, tags != null ? LifetimesKeyword : null);
            if (count > 0 && sources.recycles)
                variant = variant == null ? RecyclingKeyword : variant + " " + RecyclingKeyword;
            if (count > 0 && sources.limitsDrains)
            {
                description.Kernel(stage.countRandomRanks, 1, variant);
                description.Kernel(stage.selectRandom, 1, variant);
            }
            description.Kernel(stage.drain, 1, variant);
            stage.Buffers.Describe(description);
            return description;
        }

        void RecordReset(CommandBuffer cmd, int number)
        {
            cmd.SetBufferData(readback.Buffer, zeros, 0, number * Words, Words);
            readback.Zero(number * Words, Words);
        }

        void RecordRandomSelection(CommandBuffer cmd, ParticleBuffers particles)
        {
            if (histogram == null)
            {
                histogram = Buffers.Structured<uint>("Rill.Drains.Histogram", StepSources.MaxDrains * RandomRanks, "_DrainHistogram");
                BufferClear.Now(histogram);
            }
            particles.Bind(cmd, shader, countRandomRanks);
            Buffers.Bind(cmd, shader, countRandomRanks);
            cmd.DispatchCompute(shader, countRandomRanks, particles.AliveArguments, GpuBuffer.DispatchArgumentsAt);

            Buffers.Bind(cmd, shader, selectRandom);
            cmd.DispatchCompute(shader, selectRandom, 1, 1, 1);
        }

        static class Ids
        {
            public static readonly ShaderParameters Drain = new ShaderParameters("_DrainCount", "_Substeps", "_Tags", "_EmitterStates");
        }
    }
}
