using UnityEngine;

namespace Rill
{
    /// <summary>How the box of a fluid lies against where it was in a snapshot.</summary>
    readonly struct BoxMotion
    {
        /// <summary>Whether it is turned.</summary>
        public readonly bool IsTurned;
        /// <summary>m; 0 to the bit where it has not moved.</summary>
        public readonly Vector3 Shift;

        readonly bool isSame;
        readonly Vector3 from, to;
        readonly Quaternion turn;

        /// <param name="from">In the snapshot, world space, m.</param>
        /// <param name="to">Now.</param>
        public BoxMotion(in RigidPose from, in RigidPose to)
        {
            isSame = from.Equals(to);
            (this.from, this.to) = (from.position, to.position);
            IsTurned = !new PoseRecord(from).IsAt(new RigidPose(from.position, to.rotation), 0f);
            turn = IsTurned ? (Quaternion)to.rotation * Quaternion.Inverse(from.rotation) : Quaternion.identity;
            Shift = isSame ? Vector3.zero : this.to - this.from;
        }

        /// <summary>A point that goes along with the box.</summary>
        public Vector3 Point(Vector3 then) => isSame ? then : to + turn * (then - from);

        /// <summary>A velocity, or another direction.</summary>
        public Vector3 Vector(Vector3 then) => IsTurned ? turn * then : then;

        public Quaternion Rotation(Quaternion then) => IsTurned ? turn * then : then;
    }
}
