using System;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Bits of _TransferRule.</summary>
    [Flags]
    [GenerateHlsl("ParticleTransfer", Prefix = "Transfer")]
    enum TransferRule
    {
        Move = 0,
        /// <summary>what goes stays too: ghosts</summary>
        Copies = 1,
        /// <summary>what is outside of the region goes</summary>
        Outside = 2,
        /// <summary>ids stay what they are</summary>
        KeepsIds = 4,
        /// <summary>all that is left goes, wherever it is</summary>
        All = 8,
    }

    /// <summary>Words of a transfer in _TransferStates.</summary>
    [GenerateHlsl("ParticleTransfer", Prefix = "Transfer")]
    enum TransferWord
    {
        /// <summary>particles moved, since the reset</summary>
        Handed,
        /// <summary>that would go and stay, for want of capacity</summary>
        Held,
        /// <summary>copied for this frame</summary>
        Ghosts,
        /// <summary>that the capacity left out</summary>
        Missing,
    }

    /// <summary>Particles in buffers, of a fluid or outside of one.</summary>
    readonly struct ParticleSet
    {
        /// <summary>float4, xyz d.</summary>
        public readonly GraphicsBuffer Positions;
        /// <summary>float4, xyz d/s.</summary>
        public readonly GraphicsBuffer Velocities;
        public readonly GraphicsBuffer Ids;
        /// <summary>Null for none.</summary>
        public readonly GraphicsBuffer Tags;
        /// <summary>By <see cref="ParticleCounter"/>.</summary>
        public readonly GraphicsBuffer Counters;
        public readonly GraphicsBuffer AliveArguments;
        public readonly int Capacity;

        public ParticleSet(GraphicsBuffer positions, GraphicsBuffer velocities, GraphicsBuffer ids, GraphicsBuffer tags,
            GraphicsBuffer counters, GraphicsBuffer aliveArguments, int capacity)
        {
            Positions = positions;
            Velocities = velocities;
            Ids = ids;
            Tags = tags;
            Counters = counters;
            AliveArguments = aliveArguments;
            Capacity = capacity;
        }

        /// <summary>Buffers of the set that a transfer reads, and of the one that it writes.</summary>
        public static readonly ShaderParameters From = Parameters("_From"), To = Parameters("_To");

        /// <summary>Records the set as what a kernel reads or writes.</summary>
        public void Bind(CommandBuffer cmd, ComputeShader shader, int kernel, ShaderParameters parameters)
            => parameters.Bind(cmd, shader, kernel, Positions, Velocities, Ids, Tags, Counters, AliveArguments);

        static ShaderParameters Parameters(string prefix) => new ShaderParameters(
            prefix, prefix + "Velocities", prefix + "Ids", prefix + "Tags", prefix + "Counters", prefix + "Arguments");
    }

    /// <summary>Region of the particles that go from one set to another, and their positions in the other.</summary>
    struct TransferRegion
    {
        /// <summary>Origin of the frame that gives in the frame that takes, d.</summary>
        public float3 offset;
        /// <summary>From the frame that gives to the one that takes.</summary>
        public quaternion rotation;
        /// <summary>Box of the fluid that takes, or whose outside is taken, d.</summary>
        public float3 size;
        /// <summary>Normal, and in w the distance along it beyond which particles go, d; 0 for all of the box.</summary>
        public float4 plane;
        /// <summary>Lowest corner of a box whose particles stay, in the frame that gives, d.</summary>
        public float3 staysCorner;
        /// <summary>Its size, d; 0 for no such box.</summary>
        public float3 staysSize;
        /// <summary>Steps of the fluid that takes less those of the one that gives.</summary>
        public uint stepsAhead;
        /// <summary>End of the box of the fluid that takes which that of the other covers, see StepInput.openFaces; 0 for none.</summary>
        public uint openFaces;
        /// <summary>Phases that particles get in the set that takes, PhaseBits for each phase, from phase 0 on: the bits
        /// of its number that change. 0 where all keep theirs.</summary>
        public uint phaseChanges;
        /// <summary>Number of the words of this transfer, below <see cref="ParticleTransfer.MaxTransfers"/>.</summary>
        public int number;
    }

    /// <summary>Moves or copies particles from one set to the end of another, in their order. Made when first needed by what takes.</summary>
    sealed class ParticleTransfer : Stage
    {
        /// <summary>Maximum number of fluids that one takes from: the number is in the ids of ghosts.</summary>
        public const int MaxTransfers = 16;

        const int OwnTransfers = 4;     // of the fluid itself, behind those: see PbfSolver.Exchange.cs

        /// <summary>words of a transfer in _TransferStates</summary>
        [GenerateHlsl("ParticleTransfer", Prefix = "Transfer")] public const int Words = 4;

        const uint FirstGhost = 0x80000000u;
        const int GhostNumberShift = 24;        // a rank is below the most particles of a simulation

        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.HandOver");

        readonly ComputeShader shader = StageShader.LoadCompute("ParticleTransfer");
        readonly Kernel mark, markApart, writeMotion, commit, removeGhosts;
        readonly KernelVariants writeIds;       // with tags
        readonly Readback readback = new Readback(GpuBuffer.Structured<uint>("Rill.Transfer.States", (MaxTransfers + OwnTransfers) * Words));
        GraphicsBuffer goes, goneBefore;
        PrefixSum sum;

        /// <param name="errors">Learns of results that the device did not give; may be null.</param>
        public ParticleTransfer(ReadbackErrors errors = null)
        {
            readback.Report(errors, ReadbackKinds.Transfers);
            mark = new Kernel(shader, "MarkGoing");
            markApart = new Kernel(shader, "MarkGoingApart");
            writeMotion = new Kernel(shader, "WriteMotion");
            writeIds = new KernelVariants(shader, "WriteIds", "WriteIdsTagged");
            commit = new Kernel(shader, "Commit");
            removeGhosts = new Kernel(shader, "RemoveGhosts");
            Buffers.AddShared("Rill.Transfer.States", readback.Buffer, "_TransferStates");
            Clear();
        }

        /// <summary>Nothing was transferred.</summary>
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

        /// <summary>Nothing was transferred under a number.</summary>
        public void Reset(int number)
        {
            readback.Buffer.SetData(new uint[Words], 0, number * Words, Words);
            readback.Zero(number * Words, Words);
        }

        /// <summary>Asks for the numbers as the commands executed so far leave them. Nothing while some are pending.</summary>
        public void Request() => readback.Request();

        /// <summary>A number of a transfer, as far as it has come back.</summary>
        public int Latest(int number, TransferWord word) => readback.HasResult ? (int)readback.Latest[number * Words + (int)word] : 0;

        /// <summary>Records a transfer. Tags go along where both sets have some.</summary>
        public void Record(CommandBuffer cmd, in ParticleSet from, in ParticleSet to, in TransferRegion region, TransferRule rule)
        {
            cmd.BeginSample(Marker);
            RecordParameters(cmd, mark, from, to, region, rule);
            Bind(cmd, mark, from, to);
            Dispatch(cmd, mark, from);
            RecordWrites(cmd, from, to);
            cmd.EndSample(Marker);
        }

        /// <summary>Records a first transfer between two fluids: of what both were filled with, the one that takes keeps its own, and the
        /// other's is removed.</summary>
        /// <param name="taker">What takes, its particles listed by cell as they are.</param>
        public void RecordApart(in StepContext taker, in ParticleSet from, in ParticleSet to, in TransferRegion region)
        {
            CommandBuffer cmd = taker.Commands;
            RecordParameters(cmd, markApart, from, to, region, TransferRule.Move);
            taker.BindConstants(shader);
            Bind(cmd, markApart, from, to);
            taker.BindOrderAtRest(shader, markApart);
            Dispatch(cmd, markApart, from);
            RecordWrites(cmd, from, to);
        }

        /// <summary>Records the removal of all ghosts.</summary>
        public void RecordRemoval(CommandBuffer cmd, in ParticleSet fluid)
        {
            fluid.Bind(cmd, shader, removeGhosts, ParticleSet.From);
            Dispatch(cmd, removeGhosts, fluid);
        }

        public override void Dispose()
        {
            readback.Dispose();
            ReleaseScratch();
            base.Dispose();
        }

        /// <param name="stage">The stage, or null where none was made.</param>
        /// <param name="connections">Neighbors that the fluid takes from.</param>
        /// <param name="tagged">Whether particles have tags.</param>
        /// <param name="outside">Particles outside the box; null for none.</param>
        public static StageDescription Describe(ParticleTransfer stage, int connections, bool tagged, OutsideParticles outside)
        {
            bool needed = connections > 0 || outside != null;
            var description = new StageDescription("Transfer", needed, !needed ? "no connection, and nothing is kept outside the box"
                : Invariant($"{connections} fluids hand particles over, once a ") +
                $"frame{(outside != null ? ", and some are kept outside the box" : "")}");
            if (!needed || stage == null)
                return description;
            outside?.Describe(description);
            stage.Buffers.Describe(description);
            if (connections == 0)
                return description;
            description.Kernel(stage.mark, 2 * connections);
            description.Kernel(stage.writeMotion, 2 * connections);
            description.Kernel(stage.writeIds.For(tagged), 2 * connections);
            description.Kernel(stage.commit, 2 * connections);
            description.Kernel(stage.removeGhosts, 1);
            stage.sum?.DescribeKernels(description, 2 * connections);
            return description;
        }

        // All are numbers, which the kernels after the first find too.
        void RecordParameters(CommandBuffer cmd, int kernel, in ParticleSet from, in ParticleSet to, in TransferRegion region, TransferRule rule)
        {
            Ids.Region.Bind(cmd, shader, kernel, region.offset, region.rotation.value, region.size, region.plane, region.staysCorner,
                new float4(region.staysSize, math.any(region.staysSize > 0f) ? 1f : 0f));
            Ids.Rule.Bind(cmd, shader, kernel, (int)rule, from.Capacity, to.Capacity, region.number * Words,
                FirstGhost | (uint)region.number << GhostNumberShift, region.stepsAhead, region.phaseChanges);
        }

        void RecordWrites(CommandBuffer cmd, in ParticleSet from, in ParticleSet to)
        {
            sum.Record(cmd, goes, goneBefore, from.Capacity + 1);

            bool tagged = from.Tags != null && to.Tags != null;
            int ids = writeIds.For(tagged);
            Bind(cmd, ids, from, to);
            Dispatch(cmd, ids, from);

            Bind(cmd, writeMotion, from, to);
            Dispatch(cmd, writeMotion, from);

            Bind(cmd, commit, from, to);
            cmd.DispatchCompute(shader, commit, 1, 1, 1);
        }

        void Bind(CommandBuffer cmd, int kernel, in ParticleSet from, in ParticleSet to)
        {
            Buffers.Bind(cmd, shader, kernel);
            from.Bind(cmd, shader, kernel, ParticleSet.From);
            to.Bind(cmd, shader, kernel, ParticleSet.To);
        }

        void Dispatch(CommandBuffer cmd, int kernel, in ParticleSet set)
            => cmd.DispatchCompute(shader, kernel, set.AliveArguments, GpuBuffer.DispatchArgumentsAt);

        /// <summary>Makes room to take from a set of so many, before anything is recorded: what is recorded keeps its buffers.</summary>
        // The sum leaves the marks 0 that it has read.
        public void Reserve(int capacity)
        {
            if (goes != null && goes.count > capacity)
                return;
            ReleaseScratch();
            goes = Buffers.Structured<uint>("Rill.Transfer.Goes", capacity + 1);
            BufferClear.Now(goes);
            goneBefore = Buffers.Structured<uint>("Rill.Transfer.GoneBefore", capacity + 1);
            sum = new PrefixSum(StageShader.LoadCompute("PrefixSum"), capacity + 1);
        }

        void ReleaseScratch()
        {
            Buffers.Release(ref goes);
            Buffers.Release(ref goneBefore);
            sum?.Dispose();
            sum = null;
        }

        static class Ids
        {
            public static readonly ShaderParameters Region = new ShaderParameters(
                "_FrameOffset", "_FrameRotation", "_RegionSize", "_RegionPlane", "_StaysCorner", "_StaysSize");
            public static readonly ShaderParameters Rule = new ShaderParameters(
                "_TransferRule", "_FromCapacity", "_ToCapacity", "_StatesAt", "_GhostIds", "_StepsAhead", "_PhaseChanges");
        }
    }
}
