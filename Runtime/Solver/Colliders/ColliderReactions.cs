using System;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Forces and contacts of the fluid on colliders: summed on the GPU over steps and read back without waiting. Made when a collider
    /// asks for them.</summary>
    sealed class ColliderReactions : IDisposable
    {
        /// <summary>words of a collider: three sums, three moments, and what was added</summary>
        [GenerateHlsl("Reactions", Prefix = "Reaction")] const int Stride = 13;

        /// <summary>steps of a summed displacement in d</summary>
        [GenerateHlsl("Reactions", Prefix = "Reaction")] const double Scale = 65536.0;

        /// <summary>words of a collider's wetted area: the area, three sums of its normals, three of its places</summary>
        [GenerateHlsl("Reactions")] const int WettedStride = 14;

        /// <summary>word at which those begin</summary>
        [GenerateHlsl("Reactions")] const int WettedFirst = Stride * ColliderSet.MaxCount;

        readonly int words;

        readonly ComputeShader shader;
        readonly Kernel take;
        readonly Readback readback;
        readonly BufferSet buffers = new BufferSet();
        readonly GraphicsBuffer sums;
        readonly uint[] zeros;
        float time, takenTime;

        /// <param name="hasWettedAreas">Whether how much of colliders is wet is brought back too.</param>
        /// <param name="errors">Learns of results that the device did not give; may be null.</param>
        public ColliderReactions(ComputeShader shader, bool hasWettedAreas, ReadbackErrors errors = null)
        {
            HasWettedAreas = hasWettedAreas;
            words = WordsOf(hasWettedAreas);
            zeros = new uint[words];
            readback = new Readback(GpuBuffer.Structured<uint>("Rill.Colliders.Taken", words));
            readback.Report(errors, ReadbackKinds.Forces);
            this.shader = shader;
            take = new Kernel(shader, "TakeReactions");
            sums = buffers.Structured<uint>("Rill.Colliders.Reactions", words);
            buffers.AddShared("Rill.Colliders.Taken", readback.Buffer);
            BufferClear.Now(sums);
            readback.Arrived = OnArrived;
        }

        /// <summary>Called with each result when it has come; read it with <see cref="Get"/>.</summary>
        public Action Arrived;

        /// <summary>Whether how much of colliders is wet is brought back too.</summary>
        public bool HasWettedAreas { get; }

        /// <summary>Whether a result is pending; sums go on meanwhile.</summary>
        public bool IsPending => readback.IsPending;

        /// <summary>Fluid time over which the newest result was summed, s; 0 before the first.</summary>
        public float Duration { get; private set; }

        /// <summary>Prepares a snapshot of the sums, and of those that are pending.</summary>
        /// <param name="record">What is known of what is pending besides.</param>
        public void Save(SnapshotCapture capture, SnapshotContents contents, ReactionsRecord record)
        {
            (record.time, record.takenTime) = (time, takenTime);
            record.hasWettedAreas = HasWettedAreas ? 1u : 0u;
            record.frames = ReactionsRecord.NothingPending;
            capture.Add(new StateBuffer(SnapshotSection.ReactionSums, sums, StateExtent.All), 0);
            ReadbackArrival arrival = readback.Follow();
            if (arrival != null)
                capture.Add(new StateBuffer(SnapshotSection.ReactionsTaken, readback.Buffer, StateExtent.All), 0);
            int now = Time.frameCount;
            capture.Finishing(() =>
            {
                record.frames = arrival?.FramesAfter(now) ?? ReactionsRecord.NothingPending;
                contents.Set(SnapshotSection.Reactions, record);
            });
        }

        /// <summary>Takes all of it out of one. Of one that has made no request.</summary>
        public void Load(SnapshotContents contents)
        {
            ReactionsRecord record = contents.Get<ReactionsRecord>(SnapshotSection.Reactions);
            (time, takenTime) = (record.time, record.takenTime);
            sums.SetData(contents.Values<uint>(SnapshotSection.ReactionSums).ToArray());
            if (record.frames != ReactionsRecord.NothingPending)
                readback.Resume(contents.Values<uint>(SnapshotSection.ReactionsTaken), record.frames);
        }

        /// <summary>Words of the sums.</summary>
        public static int WordsOf(bool hasWettedAreas) => WettedFirst + (hasWettedAreas ? WettedStride * ColliderSet.MaxCount : 0);

        /// <summary>Records the sums as what a kernel adds to.</summary>
        public void Bind(CommandBuffer cmd, ComputeShader reader, int kernel) => buffers.Bind(cmd, reader, kernel);

        /// <summary>Tells of a step that added to the sums.</summary>
        public void AddTime(float stepTime) => time += stepTime;

        /// <summary>Records that sums begin again, as the colliders have other numbers now; what is pending is dropped.</summary>
        public void Invalidate(CommandBuffer cmd)
        {
            cmd.SetBufferData(sums, zeros);
            time = 0f;
            readback.Invalidate();
        }

        /// <summary>Records the handing over of the sums; call <see cref="Request"/> after the commands ran.</summary>
        public void RecordTake(CommandBuffer cmd)
        {
            takenTime = time;
            time = 0f;
            cmd.SetComputeIntParam(shader, Ids.ReactionWords, words);
            buffers.Bind(cmd, shader, take);
            CoarseGrid.Dispatch(cmd, shader, take, words);
        }

        public void Request() => readback.Request();

        /// <summary>Gets what collider number <paramref name="index"/> gave to the fluid: displacements of particles, d, and their moment about
        /// its position over its moment arm.</summary>
        public void Get(int index, out double3 sum, out double3 moment)
        {
            int at = index * Stride;
            sum = new double3(Signed(at), Signed(at + 2), Signed(at + 4));
            moment = new double3(Signed(at + 6), Signed(at + 8), Signed(at + 10));
        }

        /// <summary>Returns how much of collider number <paramref name="index"/> was wet when the sums were taken, d²; only with
        /// <see cref="HasWettedAreas"/>.</summary>
        /// <param name="normal">Sum of its parts' areas times their normals, d².</param>
        /// <param name="position">Sum of its parts' areas times their positions, from the collider's own, over its moment arm.</param>
        public double WettedArea(int index, out double3 normal, out double3 position)
        {
            int at = WettedFirst + index * WettedStride;
            normal = new double3(Signed(at + 2), Signed(at + 4), Signed(at + 6));
            position = new double3(Signed(at + 8), Signed(at + 10), Signed(at + 12));
            return Signed(at);
        }

        public void Describe(StageDescription description)
        {
            description.Kernel(take, 0);
            buffers.Describe(description);
        }

        public void Dispose()
        {
            readback.Dispose();
            buffers.Dispose();
        }

        double Signed(int at) => (long)((ulong)readback.Latest[at + 1] << 32 | readback.Latest[at]) / Scale;

        void OnArrived()
        {
            Duration = takenTime;
            Arrived?.Invoke();
        }

        static class Ids
        {
            public static readonly int ReactionWords = Shader.PropertyToID("_ReactionWords");
        }
    }
}
