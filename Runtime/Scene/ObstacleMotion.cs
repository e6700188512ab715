using UnityEngine;

namespace Rill
{
    /// <summary>How an obstacle moved over the steps in which a force on it was summed: means over their time, world space.</summary>
    readonly struct ObstacleMotion
    {
        /// <summary>Of its middle, m.</summary>
        public readonly Vector3 Position;
        public readonly Quaternion Rotation;
        /// <summary>m/s².</summary>
        public readonly Vector3 Acceleration;
        /// <summary>rad/s².</summary>
        public readonly Vector3 AngularAcceleration;

        public ObstacleMotion(Vector3 position, Quaternion rotation, Vector3 acceleration, Vector3 angularAcceleration)
        {
            Position = position;
            Rotation = rotation;
            Acceleration = acceleration;
            AngularAcceleration = angularAcceleration;
        }
    }
}
