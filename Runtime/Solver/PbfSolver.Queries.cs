using System.Collections.Generic;
using UnityEngine.Rendering;

namespace Rill
{
    // What probes, detectors and batches ask of the state: made when first needed.
    partial class PbfSolver
    {
        QueryShader queryShader;
        Queries queries;
        QueryInput queried;     // of the newest frame

        /// <summary>Answers to probes and detectors; null while there are none.</summary>
        public Queries Queries => queries;

        QueryShader QueryShader => queryShader ??= new QueryShader();

        /// <summary>Makes what answers, where there is none yet.</summary>
        public Queries MakeQueries() => queries ??= new Queries(QueryShader, ReadbackErrors);

        /// <summary>Records the answers of the current state, after a step or between steps.</summary>
        /// <param name="slot">A <see cref="Queries.FreeSlot"/>.</param>
        public void RecordQueries(CommandBuffer cmd, QueryInput input, int slot)
        {
            queried = input;
            queries.Record(PrepareAnswers(cmd), tags, input, slot);
        }

        /// <summary>Records the answers to batches that have asked: one kind of dispatch of all after the other, since those of a kind need not
        /// wait for each other.</summary>
        public void RecordBatches(CommandBuffer cmd, List<QueryBatch> batches)
        {
            StepContext step = PrepareAnswers(cmd);
            cmd.BeginSample(QueryBatch.Marker);
            foreach (QueryBatch batch in batches)
                batch.RecordUpload(cmd);
            foreach (QueryBatch batch in batches)
                batch.RecordSearch(step, QueryShader, tags);
            foreach (QueryBatch batch in batches)
                batch.RecordPoints(step, QueryShader, tags);
            foreach (QueryBatch batch in batches)
                batch.RecordRays(step, QueryShader, tags);
            cmd.EndSample(QueryBatch.Marker);
        }

        StepContext PrepareAnswers(CommandBuffer cmd)
        {
            PrepareConstants();
            QueryShader.HasRemoved = HasMarked;
            return BetweenSteps(cmd);
        }

        /// <summary>What a batch costs.</summary>
        public void DescribeBatch(QueryBatch batch, StageDescription description) => batch.Describe(description, QueryShader, tags);

        /// <summary>Gives back what answering needs, where nothing asks any more.</summary>
        public void ReleaseQueries()
        {
            queries?.Dispose();
            queries = null;
            queried = null;
        }
    }
}
