using UnityEngine;

namespace Rill
{
    /// <summary>Where a detector was when it asked.</summary>
    struct DetectorPose
    {
        /// <summary>World space, m.</summary>
        public Vector3 position;
        /// <summary>Of its shape, m³.</summary>
        public float volume;
    }
}
