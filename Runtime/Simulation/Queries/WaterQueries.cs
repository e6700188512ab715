using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Queries of probes, detectors and batches: recorded after the steps of a frame and while time stands still, and handed to them
    /// when their results have come.</summary>
    sealed class WaterQueries
    {
        /// <summary>The pending queries of a frame: whose they are, where and when.</summary>
        sealed class PendingQueries
        {
            public readonly FluidQuery[] probes = new FluidQuery[Queries.MaxProbes];
            public readonly Vector3[] positions = new Vector3[Queries.MaxProbes];
            public readonly bool[] isOutside = new bool[Queries.MaxProbes];
            public readonly FluidQuery[] detectors = new FluidQuery[Queries.MaxDetectors];
            public readonly DetectorPose[] poses = new DetectorPose[Queries.MaxDetectors];
            public int probeCount, detectorCount;
            public QueryFrame frame;
        }

        const double MaxStepsWithoutResults = 1.5;      // of real time

        readonly FluidSimulation fluid;
        readonly List<FluidQueryBatch> batches = new List<FluidQueryBatch>();
        readonly List<QueryBatch> recordedBatches = new List<QueryBatch>();
        PendingQueries[] pending;
        QueryInput input;
        double lastRecorded;        // real time at which the newest queries were recorded, s

        public WaterQueries(FluidSimulation fluid) => this.fluid = fluid;

        /// <summary>Whether a batch has queries of the next state.</summary>
        public bool HasBatches
        {
            get
            {
                foreach (FluidQueryBatch batch in batches)
                    if (batch.IsDue)
                        return true;
                return false;
            }
        }

        public void Attach(FluidQueryBatch batch) => batches.Add(batch);

        public void Detach(FluidQueryBatch batch) => batches.Remove(batch);

        /// <summary>Waits for the GPU, and hands over all results that are pending.</summary>
        public void Flush()
        {
            fluid.Solver?.Queries?.Complete();
            for (int i = batches.Count - 1; i >= 0; i--)
                batches[i].Flush();
        }

        /// <summary>Queries the water as it is now, waits for the GPU, and hands over the results.</summary>
        public void MeasureNow()
        {
            Flush();        // so that there is a free slot; a listener may make the fluid begin again
            if (fluid.Solver == null)
                return;
            Execute(fluid.Commands);
            Flush();
        }

        /// <summary>Whether results are late: while time passes slowly, there may be a step only once in many frames.</summary>
        public bool AreLate => !fluid.IsInEditMode && Time.unscaledTimeAsDouble - lastRecorded > MaxStepsWithoutResults * fluid.FixedStep;

        /// <summary>Records and executes the queries of a frame without a step: probes may have moved, and scripts may have changed the
        /// water.</summary>
        public void Execute(CommandBuffer commands)
        {
            commands.Clear();
            int slot = Record(commands);
            if (!RecordBatches(commands) && slot < 0)
                return;
            Graphics.ExecuteCommandBuffer(commands);
            Request(slot);
            RequestBatches();
        }

        /// <summary>Records the queries of probes and detectors of the current state.</summary>
        /// <returns>The slot to request; -1 for nothing.</returns>
        public int Record(CommandBuffer commands)
        {
            lastRecorded = Time.unscaledTimeAsDouble;
            PbfSolver solver = fluid.Solver;
            if (fluid.Inputs.Parts.QueryCount == 0)
            {
                solver.ReleaseQueries();
                return -1;
            }
            if (!fluid.Support.Has(Features.Queries))
                return -1;
            Queries queries = solver.MakeQueries();
            queries.Arrived ??= OnArrived;
            int slot = queries.FreeSlot;
            if (slot < 0)
                return -1;
            if (pending == null)
            {
                input = new QueryInput();
                pending = new PendingQueries[Queries.RingSize];
                for (int i = 0; i < pending.Length; i++)
                    pending[i] = new PendingQueries();
            }
            Gather(pending[slot]);
            if (input.pointCount + input.detectorCount == 0)
                return -1;
            solver.RecordQueries(commands, input, slot);
            return slot;
        }

        /// <summary>Requests the results of what was recorded, after its commands ran.</summary>
        public void Request(int slot)
        {
            if (slot >= 0)
                fluid.Solver.Queries.Request(slot);
        }

        /// <summary>Records the queries of batches.</summary>
        /// <returns>Whether there are any.</returns>
        public bool RecordBatches(CommandBuffer commands)
        {
            if (!HasBatches || !fluid.Support.Has(Features.Queries))
                return false;
            QueryFrame state = Begin(out DomainFrame frame, out float3 up);
            recordedBatches.Clear();
            foreach (FluidQueryBatch batch in batches)
                batch.Gather(fluid.Solver, recordedBatches, state, frame, up);
            if (recordedBatches.Count > 0)
                fluid.Solver.RecordBatches(commands, recordedBatches);
            return recordedBatches.Count > 0;
        }

        public void RequestBatches()
        {
            foreach (FluidQueryBatch batch in batches)
                batch.Request();
        }

        /// <summary>Begins again with the fluid.</summary>
        public void Restart()
        {
            lastRecorded = Time.unscaledTimeAsDouble;
            foreach (FluidQueryBatch batch in batches)
                batch.OnRestart();
            fluid.Inputs.Parts.RestartQueries();
        }

        public StageDescription DescribeBatches()
        {
            int points = 0, rays = 0;
            foreach (FluidQueryBatch batch in batches)
                (points, rays) = (points + batch.PointCount, rays + batch.RayCount);
            bool isUsed = HasBatches;
            var description = new StageDescription("Query batches", isUsed, isUsed
                ? Invariant($"{points} points and {rays} rays of scripts, once a frame, outside the step") : "no script asks in a batch");
            foreach (FluidQueryBatch batch in batches)
                batch.Describe(fluid.Solver, description);
            return description;
        }

        void Gather(PendingQueries to)
        {
            to.frame = Begin(out DomainFrame frame, out input.up);
            to.probeCount = to.detectorCount = 0;
            float3 size = fluid.Solver.Layout.DomainSize;
            foreach (FluidPart part in fluid.Inputs.Parts.Probes)
            {
                if (part == null || !part.TryGetPose(frame, out PoseInDomain pose))
                    continue;
                int i = to.probeCount++;
                to.probes[i] = (FluidQuery)part;
                to.positions[i] = part.transform.position;
                to.isOutside[i] = math.any(pose.position < 0f) || math.any(pose.position > size);
                input.points[i] = new float4(math.clamp(pose.position, 0f, size), 0f);
            }
            GatherDetectors(to, frame, false);
            int simple = to.detectorCount;
            GatherDetectors(to, frame, true);
            input.meshCount = to.detectorCount - simple;
            input.pointCount = to.probeCount;
            input.detectorCount = to.detectorCount;
        }

        void GatherDetectors(PendingQueries to, in DomainFrame frame, bool areMeshes)
        {
            foreach (FluidPart part in fluid.Inputs.Parts.Detectors)
            {
                if (part == null || !(part is IDetector detector) || detector.MeshField != null != areMeshes
                    || !detector.TryGetRegion(frame, fluid.ParticleSpacing, out DetectorRegion region, out DetectorPose pose))
                    continue;
                int i = to.detectorCount++;
                to.detectors[i] = (FluidQuery)part;
                to.poses[i] = pose;
                input.detectors[i] = region;
                input.fields[i] = areMeshes ? detector.MeshField.Texture : null;
            }
        }

        // Returns the state that is queried, with its frame and the direction against gravity in it, of length 1; 0 without gravity.
        QueryFrame Begin(out DomainFrame frame, out float3 up)
        {
            frame = fluid.Box.Frame;
            Vector3 gravity = fluid.Gravity;
            bool hasGravity = math.length(gravity) > 1e-6f;
            up = hasGravity ? math.normalize(frame.Vector(-gravity)) : 0f;
            return new QueryFrame
            {
                step = fluid.StepCount,
                time = fluid.FluidTime,
                rotation = frame.Box.rotation,
                spacing = fluid.ParticleSpacing,
                density = fluid.Material.density,
                up = hasGravity ? -gravity.normalized : Vector3.zero,
                shift = fluid.Box.WorldShift,
            };
        }

        void OnArrived(int slot)
        {
            Queries queries = fluid.Solver?.Queries;
            if (queries == null)
                return;
            PendingQueries from = pending[slot];
            for (int i = 0; i < from.probeCount; i++)
            {
                FluidQuery probe = from.probes[i];
                if (IsAttached(probe))
                    ((IProbe)probe).SetResult(from.frame, from.positions[i], from.isOutside[i], queries.Latest(slot), i * Queries.ProbeWords);
            }
            for (int i = 0; i < from.detectorCount; i++)
            {
                FluidQuery detector = from.detectors[i];
                if (IsAttached(detector))
                    ((IDetector)detector).SetResult(from.frame, from.poses[i], queries, slot, i);
            }
            // After all are set; a listener may restart or disable the fluid.
            for (int i = 0; i < from.probeCount; i++)
                if (from.probes[i] != null)
                    from.probes[i].RaiseEvents();
            for (int i = 0; i < from.detectorCount; i++)
                if (from.detectors[i] != null)
                    from.detectors[i].RaiseEvents();
        }

        bool IsAttached(FluidQuery query) => query != null && ReferenceEquals(query.Simulation, fluid) && query.Number >= 0;
    }
}
