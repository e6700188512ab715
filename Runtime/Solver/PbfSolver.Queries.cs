using UnityEngine.Rendering;

namespace Rill
{
    // What probes and detectors ask of the state: made when first needed.
    sealed partial class PbfSolver
    {
        Queries queries;
        QueryInput queried;     // of the newest frame

        /// <summary>Answers to probes and detectors; null while there are none.</summary>
        public Queries Queries => queries;

        /// <summary>Makes what answers, where there is none yet.</summary>
        public Queries MakeQueries() => queries ??= new Queries();

        /// <summary>Records the answers of the state that the last step left; not after <see cref="RecordStatistics"/> of that state, which
        /// sorts again.</summary>
        /// <param name="slot">A <see cref="Queries.FreeSlot"/>.</param>
        public void RecordQueries(CommandBuffer cmd, QueryInput input, int slot)
        {
            queried = input;
            queries.Record(BetweenSteps(cmd), tags, input, slot);
        }

        /// <summary>Gives back what answering needs, where nothing asks any more.</summary>
        public void ReleaseQueries()
        {
            queries?.Dispose();
            queries = null;
            queried = null;
        }
    }
}
