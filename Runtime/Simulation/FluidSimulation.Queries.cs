using System;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    // What probes and detectors ask of the water: asked for after the steps of a frame and while time stands, handed to them when it has
    // come.
    public sealed partial class FluidSimulation
    {
        /// <summary>A frame's questions that are pending: who asked, where and when.</summary>
        sealed class AskedQueries
        {
            public readonly FluidQuery[] probes = new FluidQuery[Queries.MaxProbes];
            public readonly Vector3[] positions = new Vector3[Queries.MaxProbes];
            public readonly bool[] isOutside = new bool[Queries.MaxProbes];
            public readonly FluidQuery[] detectors = new FluidQuery[Queries.MaxDetectors];
            public readonly DetectorPose[] poses = new DetectorPose[Queries.MaxDetectors];
            public int probeCount, detectorCount;
            public QueryFrame frame;
        }

        readonly FluidQuery[] probes = new FluidQuery[Queries.MaxProbes];
        readonly FluidQuery[] detectors = new FluidQuery[Queries.MaxDetectors];
        AskedQueries[] asked;
        QueryInput queryInput;
        [NonSerialized] int queryPartCount;
        [NonSerialized] double lastAnswers;     // when the newest were asked for, s of real time

        const double MaxStepsWithoutAnswer = 1.5;       // as far as real time goes

        /// <summary>
        /// Waits for the GPU and hands all results that are pending to probes, detectors and batches of this fluid; other readbacks of the game
        /// are left pending. For tests and tools in the Editor: it holds the frame up, and in the game a result that is a few frames old is
        /// there without waiting.
        /// </summary>
        public void FlushQueries()
        {
            pbf?.Queries?.Complete();
            for (int i = queryBatches.Count - 1; i >= 0; i--)
                queryBatches[i].Flush();
        }

        /// <summary>
        /// Asks for all probes, detectors and batches of this fluid of the water as it stands at this moment, waits for the GPU, and hands
        /// the results over before it returns. For tests, tools and small scenes: it holds the frame up by all that the GPU still has to do.
        /// Does nothing while the fluid is not running.
        /// </summary>
        /// <exception cref="InvalidOperationException">Called in a pass of <see cref="BeforeStep"/>.</exception>
        public void MeasureQueriesNow()
        {
            ThrowInPass("measuring");
            FlushQueries();             // so that there is a free slot
            if (pbf == null)
                return;
            AnswerQueries();
            FlushQueries();
        }

        // While time crawls a step may come once in many frames.
        bool AnswersAreLate => !IsInEditMode && Time.unscaledTimeAsDouble - lastAnswers > MaxStepsWithoutAnswer * FixedStep;

        // In a frame without a step: who asks may have moved, and what the water is may have been changed by scripts.
        void AnswerQueries()
        {
            commands.Clear();
            int queries = RecordQueries();
            if (!RecordBatches() && queries < 0)
                return;
            Graphics.ExecuteCommandBuffer(commands);
            RequestQueries(queries);
            RequestBatches();
        }

        // Records what is asked of the current state; the slot to request, -1 for nothing.
        int RecordQueries()
        {
            lastAnswers = Time.unscaledTimeAsDouble;
            if (queryPartCount == 0)
            {
                pbf.ReleaseQueries();
                return -1;
            }
            if (!Has(Features.Queries))
                return -1;
            Queries queries = pbf.MakeQueries();
            queries.Arrived ??= OnQueries;
            int slot = queries.FreeSlot;
            if (slot < 0)
                return -1;
            if (asked == null)
            {
                queryInput = new QueryInput();
                asked = new AskedQueries[Queries.RingSize];
                for (int i = 0; i < asked.Length; i++)
                    asked[i] = new AskedQueries();
            }
            Ask(asked[slot]);
            if (queryInput.pointCount + queryInput.detectorCount == 0)
                return -1;
            pbf.RecordQueries(commands, queryInput, slot);
            return slot;
        }

        void Ask(AskedQueries to)
        {
            to.frame = BeginQueries(out DomainFrame frame, out queryInput.up);
            to.probeCount = to.detectorCount = 0;
            float3 size = pbf.Layout.DomainSize;
            foreach (FluidQuery probe in probes)
            {
                if (probe == null || !probe.TryGetPose(frame, out PoseInDomain pose))
                    continue;
                int i = to.probeCount++;
                to.probes[i] = probe;
                to.positions[i] = probe.transform.position;
                to.isOutside[i] = math.any(pose.position < 0f) || math.any(pose.position > size);
                queryInput.points[i] = new float4(math.clamp(pose.position, 0f, size), 0f);
            }
            AskDetectors(to, frame, false);
            int simple = to.detectorCount;
            AskDetectors(to, frame, true);
            queryInput.meshCount = to.detectorCount - simple;
            queryInput.pointCount = to.probeCount;
            queryInput.detectorCount = to.detectorCount;
        }

        void AskDetectors(AskedQueries to, in DomainFrame frame, bool areMeshes)
        {
            foreach (FluidQuery part in detectors)
            {
                if (part == null || !(part is IDetector detector) || detector.MeshField != null != areMeshes
                    || !detector.TryGetRegion(frame, particleSpacing, out DetectorRegion region, out DetectorPose pose))
                    continue;
                int i = to.detectorCount++;
                to.detectors[i] = part;
                to.poses[i] = pose;
                queryInput.detectors[i] = region;
                queryInput.fields[i] = areMeshes ? detector.MeshField.Texture : null;
            }
        }

        // The state that is asked, its frame, and against gravity in it, length 1; 0 without gravity.
        QueryFrame BeginQueries(out DomainFrame frame, out float3 up)
        {
            GetPose(out Vector3 place, out Quaternion rotation);
            frame = new DomainFrame(place, rotation, domainSize, particleSpacing);
            bool hasGravity = math.length(gravity) > 1e-6f;
            up = hasGravity ? math.normalize(frame.Vector(-gravity)) : 0f;
            return new QueryFrame
            {
                step = StepCount,
                time = FluidTime,
                rotation = rotation,
                spacing = particleSpacing,
                density = material.density,
                up = hasGravity ? -gravity.normalized : Vector3.zero,
                shift = WorldShift,
            };
        }

        void RequestQueries(int slot)
        {
            if (slot >= 0)
                pbf.Queries.Request(slot);
        }

        void OnQueries(int slot)
        {
            Queries queries = pbf?.Queries;
            if (queries == null)
                return;
            AskedQueries of = asked[slot];
            for (int i = 0; i < of.probeCount; i++)
            {
                FluidQuery probe = of.probes[i];
                if (probe != null && ReferenceEquals(probe.Simulation, this) && probe.Number >= 0)
                    ((IProbe)probe).SetResult(of.frame, of.positions[i], of.isOutside[i], queries.Latest(slot), i * Queries.ProbeWords);
            }
            for (int i = 0; i < of.detectorCount; i++)
            {
                FluidQuery detector = of.detectors[i];
                if (detector != null && ReferenceEquals(detector.Simulation, this) && detector.Number >= 0)
                    ((IDetector)detector).SetResult(of.frame, of.poses[i], queries, slot, i);
            }
            // After all are set; a listener may restart or disable the fluid.
            for (int i = 0; i < of.probeCount; i++)
                if (of.probes[i] != null)
                    of.probes[i].RaiseEvents();
            for (int i = 0; i < of.detectorCount; i++)
                if (of.detectors[i] != null)
                    of.detectors[i].RaiseEvents();
        }

        void RestartQueries()
        {
            lastAnswers = Time.unscaledTimeAsDouble;
            foreach (FluidQueryBatch batch in queryBatches)
                batch.OnRestart();
            if (queryPartCount == 0)
                return;
            foreach (FluidQuery probe in probes)
                if (probe != null)
                    probe.OnRestart();
            foreach (FluidQuery detector in detectors)
                if (detector != null)
                    detector.OnRestart();
        }
    }
}
