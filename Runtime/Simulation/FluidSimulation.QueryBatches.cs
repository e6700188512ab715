using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    // What scripts ask of the water in batches: asked for after the steps of a frame, like probes.
    public sealed partial class FluidSimulation
    {
        readonly List<FluidQueryBatch> queryBatches = new List<FluidQueryBatch>();
        readonly List<QueryBatch> askedBatches = new List<QueryBatch>();

        internal void Attach(FluidQueryBatch batch) => queryBatches.Add(batch);

        internal void Detach(FluidQueryBatch batch) => queryBatches.Remove(batch);

        bool AsksBatches
        {
            get
            {
                foreach (FluidQueryBatch batch in queryBatches)
                    if (batch.IsAsking)
                        return true;
                return false;
            }
        }

        // Whether there is anything to request.
        bool RecordBatches()
        {
            if (!AsksBatches || !Has(Features.Queries))
                return false;
            QueryFrame state = BeginQueries(out DomainFrame frame, out float3 up);
            askedBatches.Clear();
            foreach (FluidQueryBatch batch in queryBatches)
                batch.Ask(pbf, askedBatches, state, frame, up);
            if (askedBatches.Count > 0)
                pbf.RecordBatches(commands, askedBatches);
            return askedBatches.Count > 0;
        }

        void RequestBatches()
        {
            foreach (FluidQueryBatch batch in queryBatches)
                batch.Request();
        }

        StageDescription DescribeBatches()
        {
            int points = 0, rays = 0;
            foreach (FluidQueryBatch batch in queryBatches)
                (points, rays) = (points + batch.PointCount, rays + batch.RayCount);
            bool isUsed = AsksBatches;
            var description = new StageDescription("Query batches", isUsed, isUsed
                ? Invariant($"{points} points and {rays} rays of scripts, once a frame, outside the step") : "no script asks in a batch");
            foreach (FluidQueryBatch batch in queryBatches)
                batch.Describe(pbf, description);
            return description;
        }
    }
}
