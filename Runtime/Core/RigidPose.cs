using Unity.Mathematics;

namespace Rill
{
    /// <summary>A place and an orientation.</summary>
    struct RigidPose
    {
        public float3 position;
        public quaternion rotation;

        public RigidPose(float3 position, quaternion rotation)
        {
            this.position = position;
            this.rotation = rotation;
        }

        /// <summary>How far two poses are apart at most, of points within a reach.</summary>
        public static float Distance(in RigidPose a, in RigidPose b, float reach)
            => math.distance(a.position, b.position) + reach * math.length(RotationVector(a.rotation, b.rotation));

        public bool Equals(in RigidPose other) => position.Equals(other.position) && rotation.Equals(other.rotation);

        /// <summary>At a fraction of the way from one to another; at 1, and where they are the same, that one to the bit.</summary>
        public static RigidPose Between(in RigidPose from, in RigidPose to, float fraction)
        {
            if (fraction == 1f || from.Equals(to))
                return to;
            return new RigidPose(math.lerp(from.position, to.position, fraction), math.slerp(from.rotation, to.rotation, fraction));
        }

        /// <summary>The way from one orientation to another by the shorter side: its axis times its angle, rad.</summary>
        public static float3 RotationVector(quaternion from, quaternion to)
        {
            float4 turn = math.mul(to, math.conjugate(from)).value;
            turn = turn.w < 0f ? -turn : turn;
            float sine = math.length(turn.xyz);
            return sine > 1e-7f ? turn.xyz * (2f * math.atan2(sine, turn.w) / sine) : 2f * turn.xyz;
        }
    }
}
