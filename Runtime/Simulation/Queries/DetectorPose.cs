using UnityEngine;

namespace Rill
{
    /// <summary>Pose of a detector when its query was recorded.</summary>
    struct DetectorPose
    {
        /// <summary>World space, m.</summary>
        public Vector3 position;
        /// <summary>Volume of its shape, m³.</summary>
        public float volume;
    }
}
