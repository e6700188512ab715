using UnityEngine;

namespace Rill
{
    /// <summary>How much of a buffer is state.</summary>
    enum StateExtent
    {
        All,
        /// <summary>Elements of the particles alive.</summary>
        Particles,
        /// <summary>Elements of those that took part in the last step: the first of those alive.</summary>
        Moved,
    }

    /// <summary>A buffer that the next step depends on, and where it stands in a snapshot. All others a step makes again before it reads
    /// them.</summary>
    readonly struct StateBuffer
    {
        public readonly SnapshotSection Section;
        public readonly GraphicsBuffer Buffer;
        public readonly StateExtent Extent;

        public StateBuffer(SnapshotSection section, GraphicsBuffer buffer, StateExtent extent)
        {
            Section = section;
            Buffer = buffer;
            Extent = extent;
        }

        /// <summary>Its elements that are state.</summary>
        public long Elements(uint particles, uint moved) => Extent == StateExtent.All ? Buffer.count : Extent == StateExtent.Moved ? moved
            : particles;
    }
}
