using System.Runtime.InteropServices;
using UnityEngine;

namespace Rill
{
    /// <summary>How a collider moved over the steps in which a force on it was summed: means over their time, world space.</summary>
    [StructLayout(LayoutKind.Sequential, Pack = 4)]      // as it stands in snapshots
    readonly struct RelativeMotion
    {
        /// <summary>Position of its center, m.</summary>
        public readonly Vector3 Position;
        public readonly Quaternion Rotation;
        /// <summary>Against the water around it, m/s; see <see cref="SlipVelocity"/>.</summary>
        public readonly Vector3 Slip;
        /// <summary>rad/s.</summary>
        public readonly Vector3 AngularSlip;
        /// <summary>Time in which the water comes to move along, s.</summary>
        public readonly float Memory;

        public RelativeMotion(Vector3 position, Quaternion rotation, Vector3 slip, Vector3 angularSlip, float memory)
        {
            Position = position;
            Rotation = rotation;
            Slip = slip;
            AngularSlip = angularSlip;
            Memory = memory;
        }
    }
}
