using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>
    /// Asks the water of a <see cref="FluidSimulation"/> from code: at many points, for each what a <see cref="FluidProbe"/> says, and along
    /// rays, where they hit the water. Make one for what is asked together, set points and rays when they move, read the newest results at any
    /// time, and dispose of it.
    /// </summary>
    /// <remarks>
    /// Measured after the last step of each frame; the results come two or three frames later, without waiting, and say of which step they
    /// are. A batch has buffers of its own size on the GPU, one upload and one readback a frame: ask in one batch what is asked together.
    /// Setting and reading allocates no managed memory. In a build, the shaders need a probe or a detector in the scene, or
    /// <see cref="ShadersInBuild.AllFeatures"/> on the fluid.
    /// </remarks>
    public sealed partial class FluidQueryBatch : IDisposable
    {
        /// <summary>Most points of one batch.</summary>
        public const int MaxPoints = 16384;

        /// <summary>Most rays of one batch.</summary>
        public const int MaxRays = 16384;

        /// <summary>The questions about a state, and where they were asked.</summary>
        sealed class PendingQuestions : IDisposable
        {
            public NativeArray<float4> points;      // world space, m; w 1 outside the box
            public NativeArray<FluidRay> rays;
            public int pointCount, rayCount, version;
            public QueryFrame frame;
            public DomainFrame domain;

            public PendingQuestions(int pointCapacity, int rayCapacity)
            {
                points = new NativeArray<float4>(pointCapacity, Allocator.Persistent);
                rays = new NativeArray<FluidRay>(rayCapacity, Allocator.Persistent);
            }

            public void Dispose()
            {
                points.Dispose();
                rays.Dispose();
            }
        }

        readonly FluidSimulation fluid;
        readonly PendingQuestions[] questions = new PendingQuestions[QueryBatch.RingSize];
        QueryBatch buffers;
        int version, recordedVersion = -1, recorded = -1, newest = -1;
        bool isDisposed;

        /// <summary>Makes a batch that asks nothing until points or rays are set.</summary>
        /// <param name="fluid">The fluid that is asked.</param>
        /// <param name="points">Most points, 0 to <see cref="MaxPoints"/>. Memory is taken for all of them.</param>
        /// <param name="rays">Most rays, 0 to <see cref="MaxRays"/>. Memory is taken for all of them.</param>
        /// <exception cref="ArgumentNullException">No fluid.</exception>
        /// <exception cref="ArgumentOutOfRangeException">A number is out of range, or both are 0.</exception>
        public FluidQueryBatch(FluidSimulation fluid, int points, int rays = 0)
        {
            if (fluid == null)
                throw new ArgumentNullException(nameof(fluid));
            if (points < 0 || points > MaxPoints || points + rays == 0)
                throw Limit.OutOfRange(nameof(points), points,
                    Invariant($"A batch asks at 0 to {MaxPoints:N0} points, or casts at least one ray: make several for more."));
            if (rays < 0 || rays > MaxRays)
                throw Limit.OutOfRange(nameof(rays), rays, Invariant($"A batch casts 0 to {MaxRays:N0} rays: make ") +
                    "several for more.");
            this.fluid = fluid;
            (PointCapacity, RayCapacity) = (points, rays);
            this.points = new NativeArray<float3>(points, Allocator.Persistent);
            pointUpload = new NativeArray<float4>(points, Allocator.Persistent);
            this.rays = new NativeArray<FluidRay>(rays, Allocator.Persistent);
            rayUpload = new NativeArray<RayQuery>(rays, Allocator.Persistent);
            for (int i = 0; i < questions.Length; i++)
                questions[i] = new PendingQuestions(points, rays);
            fluid.Results.Queries.Attach(this);
        }

        /// <summary>The fluid that is asked.</summary>
        public FluidSimulation Simulation => fluid;

        /// <summary>Whether the questions are asked after the steps of each frame, as they are at first. Off: once each time that they are
        /// set.</summary>
        public bool Repeats { get; set; } = true;

        /// <summary>Whether what was set last has no result yet.</summary>
        public bool IsPending => HasQuestions && (newest < 0 || questions[newest].version != version);

        /// <summary>Whether there is a result to read, which may be of what was set before.</summary>
        public bool HasResult => !isDisposed && newest >= 0 && fluid != null && fluid.IsRunning;

        /// <summary>Waits for the GPU until the newest step's results of this batch are there, and for nothing else. For tests and tools in the
        /// Editor: see <see cref="FluidSimulation.FlushQueries"/>.</summary>
        /// <exception cref="ObjectDisposedException">The batch was disposed of.</exception>
        public void Flush()
        {
            NeedAlive();
            buffers?.Complete();
        }

        /// <summary>Asks what was set of the water as it stands at this moment and waits for the results: see
        /// <see cref="FluidSimulation.MeasureQueriesNow"/>.</summary>
        /// <exception cref="ObjectDisposedException">The batch was disposed of.</exception>
        public void MeasureNow()
        {
            NeedAlive();
            if (fluid != null)
                fluid.MeasureQueriesNow();
        }

        /// <summary>Stops asking and gives the memory back, at any time: a pending request is forgotten.</summary>
        public void Dispose()
        {
            if (isDisposed)
                return;
            isDisposed = true;
            fluid.Results.Queries.Detach(this);
            buffers?.Dispose();
            buffers = null;
            points.Dispose();
            pointUpload.Dispose();
            rays.Dispose();
            rayUpload.Dispose();
            foreach (PendingQuestions of in questions)
                of.Dispose();
        }

        /// <summary>Puts points, the newest answers to them and those that are pending into a snapshot.</summary>
        internal void Save(SnapshotWater to, SnapshotCapture capture)
        {
            to.points.Clear();
            for (int i = 0; i < pointCount; i++)
                to.points.Add(points[i]);
            if (buffers == null)
                return;
            if (newest >= 0)
                to.answers.Add(Answer(questions[newest], buffers.Latest(newest).ToArray()));
            var pending = new List<int>();
            buffers.ListPending(pending);
            foreach (int slot in pending)
            {
                ReadbackArrival arrival = buffers.Follow(slot);
                if (arrival == null)
                    continue;
                SnapshotAnswer answer = Answer(questions[slot], null);
                to.answers.Add(answer);
                capture.Add(buffers.Results(slot), bytes => answer.words = MemoryMarshal.Cast<byte, uint>(bytes).ToArray());
                int now = Time.frameCount;
                capture.Finishing(() => answer.frames = arrival.FramesAfter(now));
            }
        }

        /// <summary>Takes them out of one, for a batch that has asked nothing yet.</summary>
        /// <param name="moved">How far the fluid is from where it was in the snapshot, m.</param>
        internal void Load(SnapshotWater from, Vector3 moved)
        {
            if (from.points.Count > PointCapacity)
                return;
            for (int i = 0; i < from.points.Count; i++)
                points[i] = from.points[i] + (float3)moved;
            SetPointCount(from.points.Count);
            if (from.answers.Count == 0)
                return;
            MakeBuffers();
            for (int slot = 0; slot < from.answers.Count; slot++)
            {
                SnapshotAnswer answer = from.answers[slot];
                if (answer.points.Length > PointCapacity || answer.words.Length != buffers.Results(slot).count)
                    continue;       // of another batch
                PendingQuestions to = questions[slot];
                to.frame = answer.frame;
                to.frame.shift = fluid.Box.WorldShift - answer.shiftSince - moved;
                to.version = recordedVersion = version;
                to.pointCount = answer.points.Length;
                to.rayCount = 0;
                for (int i = 0; i < to.pointCount; i++)
                    to.points[i] = answer.points[i];
                buffers.Resume(slot, answer.words, answer.frames);
            }
        }

        SnapshotAnswer Answer(PendingQuestions of, uint[] words)
        {
            var answer = new SnapshotAnswer
            {
                frame = of.frame,
                shiftSince = fluid.Box.WorldShift - of.frame.shift,
                points = of.points.GetSubArray(0, of.pointCount).ToArray(),
                words = words,
            };
            answer.frame.shift = Vector3.zero;
            return answer;
        }

        void MakeBuffers() => buffers ??= new QueryBatch(PointCapacity, RayCapacity, OnArrived, OnLost);

        /// <summary>Whether a question is to be asked of the next state.</summary>
        internal bool IsDue => HasQuestions && (Repeats || recordedVersion != version);

        /// <summary>Results of before are dropped; what was asked once is asked again.</summary>
        internal void OnRestart()
        {
            newest = -1;
            recordedVersion = -1;
            buffers?.Invalidate();
        }

        /// <summary>Asks the questions about the current state.</summary>
        /// <param name="batches">Gets what is to be recorded.</param>
        internal void Gather(PbfSolver solver, List<QueryBatch> batches, in QueryFrame frame, in DomainFrame domain, float3 up)
        {
            recorded = -1;
            if (!IsDue)
                return;
            MakeBuffers();
            int slot = buffers.FreeSlot(newest);
            if (slot < 0)
                return;
            PendingQuestions to = questions[slot];
            (to.frame, to.domain, to.version) = (frame, domain, version);
            GatherPoints(to, domain, solver.Layout.DomainSize);
            float length = GatherRays(to, domain, solver.Layout.DomainSize);
            var input = new BatchInput
            {
                points = pointUpload,
                rays = rayUpload,
                pointCount = pointCount,
                rayCount = rayCount,
                rayLength = length,
                up = up,
            };
            buffers.Prepare(input, slot);
            batches.Add(buffers);
            recordedVersion = version;
            recorded = slot;
        }

        /// <summary>Asks for what was recorded, after its commands ran.</summary>
        internal void Request()
        {
            if (recorded >= 0)
                buffers.Request(recorded, fluid.Solver.ReadbackErrors);
            recorded = -1;
        }

        internal void Describe(PbfSolver solver, StageDescription description)
        {
            if (buffers != null)
                solver.DescribeBatch(buffers, description);
        }

        bool HasQuestions => !isDisposed && pointCount + rayCount > 0;

        void OnArrived(int slot) => newest = slot;

        // A question that is asked once is asked again.
        void OnLost(int slot)
        {
            if (questions[slot].version == recordedVersion)
                recordedVersion = -1;
        }

        float AgeOf(PendingQuestions of) => (float)(fluid.FrameTime - of.frame.time);

        void CheckCount(int count, int capacity, string what, string name)
        {
            NeedAlive();
            if (count < 0 || count > capacity)
                throw Limit.OutOfRange(name, count,
                    Invariant($"{count:N0} {what} are more than this batch was made for, {capacity:N0}: make it larger, or several."));
        }

        static void CheckPart(int length, int start, int count, string what)
        {
            if (start < 0 || count < 0 || start > length - count)
                throw Limit.OutOfRange(nameof(count), count,
                    Invariant($"{count} {what} from {start} on are not in an array of {length}."));
        }

        static void CheckIndex(int index, int count, string what, string limit)
        {
            if (index < 0 || index >= count)
                throw Limit.OutOfRange(nameof(index), index,
                    Invariant($"Index {index} is not one of {count:N0} {what}: give 0 to below {limit}."));
        }

        static void CheckRoom(int length, int count, int capacity, string limit, string name)
        {
            if (length < count)
                throw new ArgumentException(
                    Invariant($"'{name}' holds {length:N0} elements, and {count:N0} results came back: make it as long as {limit}, ") +
                    Invariant($"{capacity:N0} here."), name);
        }

        void NeedAlive()
        {
            if (isDisposed)
                throw new ObjectDisposedException(nameof(FluidQueryBatch));
        }
    }
}
