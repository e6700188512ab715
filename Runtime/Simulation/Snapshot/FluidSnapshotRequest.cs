using UnityEngine;

namespace Rill
{
    /// <summary>A snapshot that comes from the GPU. Yield it in a coroutine, or look at <see cref="IsDone"/> in each frame.</summary>
    public sealed class FluidSnapshotRequest : CustomYieldInstruction
    {
        /// <summary>Whether it has come, or failed.</summary>
        public bool IsDone { get; private set; }

        /// <summary>The snapshot; null before it has come, and where it failed.</summary>
        public FluidSnapshot Snapshot { get; private set; }

        /// <summary>Why there is none, and what to do; null where it has come or is pending.</summary>
        public string Problem { get; private set; }

        /// <summary>Whether a coroutine goes on waiting.</summary>
        public override bool keepWaiting => !IsDone;

        internal void Finish(SnapshotContents contents, string problem)
        {
            Snapshot = contents != null ? new FluidSnapshot(contents) : null;
            Problem = problem;
            IsDone = true;
        }
    }
}
