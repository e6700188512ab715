using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    // What probes and detectors ask of the water: asked for after the steps of a frame, handed to them when it has come.
    public sealed partial class FluidSimulation
    {
        /// <summary>A frame's questions that are pending: who asked, where and when.</summary>
        sealed class AskedQueries
        {
            public readonly FluidProbe[] probes = new FluidProbe[Queries.MaxProbes];
            public readonly Vector3[] positions = new Vector3[Queries.MaxProbes];
            public readonly bool[] isOutside = new bool[Queries.MaxProbes];
            public readonly FluidDetector[] detectors = new FluidDetector[Queries.MaxDetectors];
            public readonly DetectorPose[] poses = new DetectorPose[Queries.MaxDetectors];
            public int probeCount, detectorCount;
            public QueryFrame frame;
        }

        readonly FluidProbe[] probes = new FluidProbe[Queries.MaxProbes];
        readonly FluidDetector[] detectors = new FluidDetector[Queries.MaxDetectors];
        AskedQueries[] asked;
        QueryInput queryInput;
        int queryPartCount;

        /// <summary>
        /// Waits for the GPU and hands all results that are pending to probes and detectors. For tests and tools in the Editor: it holds
        /// the frame up, and in the game a result that is a few frames old is there without waiting.
        /// </summary>
        public void FlushQueries()
        {
            if (pbf?.Queries != null)
                AsyncGPUReadback.WaitAllRequests();
        }

        // Records what is asked of the state that the steps of this frame left; the slot to request, -1 for nothing.
        int RecordQueries()
        {
            if (queryPartCount == 0)
            {
                pbf.ReleaseQueries();
                return -1;
            }
            if (IsRefused(DeviceFeature.Queries) || !HasStages(StageSet.Queries))
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
            GetPose(out Vector3 place, out Quaternion rotation);
            var frame = new DomainFrame(place, rotation, domainSize, particleSpacing);
            float3 up = frame.Vector(-gravity);
            queryInput.up = math.length(gravity) > 1e-6f ? math.normalize(up) : 0f;
            to.frame = new QueryFrame
            {
                step = StepCount,
                time = FluidTime,
                rotation = rotation,
                spacing = particleSpacing,
                density = material.density,
                up = math.length(gravity) > 1e-6f ? -gravity.normalized : Vector3.zero,
            };
            to.probeCount = to.detectorCount = 0;
            float3 size = pbf.Layout.DomainSize;
            foreach (FluidProbe probe in probes)
            {
                if (probe == null || !probe.TryGetPose(frame, out PoseInDomain pose))
                    continue;
                int i = to.probeCount++;
                to.probes[i] = probe;
                to.positions[i] = probe.transform.position;
                to.isOutside[i] = math.any(pose.position < 0f) || math.any(pose.position > size);
                queryInput.points[i] = new float4(math.clamp(pose.position, 0f, size), 0f);
            }
            foreach (FluidDetector detector in detectors)
            {
                if (detector == null || !detector.TryGetRegion(frame, particleSpacing, out DetectorRegion region, out DetectorPose pose))
                    continue;
                int i = to.detectorCount++;
                to.detectors[i] = detector;
                to.poses[i] = pose;
                queryInput.detectors[i] = region;
            }
            queryInput.pointCount = to.probeCount;
            queryInput.detectorCount = to.detectorCount;
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
                FluidProbe probe = of.probes[i];
                if (probe != null && ReferenceEquals(probe.Simulation, this) && probe.Number >= 0)
                    probe.SetResult(of.frame, of.positions[i], of.isOutside[i], queries, slot, i);
            }
            for (int i = 0; i < of.detectorCount; i++)
            {
                FluidDetector detector = of.detectors[i];
                if (detector != null && ReferenceEquals(detector.Simulation, this) && detector.Number >= 0)
                    detector.SetResult(of.frame, of.poses[i], queries, slot, i);
            }
            // After all are set; a listener may restart or disable the fluid.
            for (int i = 0; i < of.detectorCount; i++)
                if (of.detectors[i] != null)
                    of.detectors[i].RaiseEvents();
        }

        void RestartQueries()
        {
            if (queryPartCount == 0)
                return;
            foreach (FluidProbe probe in probes)
                if (probe != null)
                    probe.OnRestart();
            foreach (FluidDetector detector in detectors)
                if (detector != null)
                    detector.OnRestart();
        }
    }

    /// <summary>Of which state the results of a frame are.</summary>
    struct QueryFrame
    {
        public int step;
        /// <summary>s</summary>
        public double time;
        /// <summary>From the box to world space.</summary>
        public Quaternion rotation;
        /// <summary>m</summary>
        public float spacing;
        /// <summary>At rest, kg/m³.</summary>
        public float density;
        /// <summary>Against gravity in world space, length 1; 0 without gravity.</summary>
        public Vector3 up;
    }
}
