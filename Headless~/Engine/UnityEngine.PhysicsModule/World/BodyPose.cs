using System.Runtime.InteropServices;

namespace UnityEngine.Headless
{
    /// <summary>A position and a rotation, as Bullet takes them.</summary>
    [StructLayout(LayoutKind.Sequential)]
    internal struct BodyPose
    {
        public Vector3 Position;
        public Quaternion Rotation;

        public BodyPose(Vector3 position, Quaternion rotation)
        {
            Position = position;
            Rotation = rotation;
        }

        public static BodyPose Identity => new BodyPose(Vector3.zero, Quaternion.identity);

        /// <summary>A pose in the frame of this one, in the frame that this one is in.</summary>
        public BodyPose Of(in BodyPose inner) => new BodyPose(Position + Rotation * inner.Position, Rotation * inner.Rotation);

        public BodyPose Inverse()
        {
            Quaternion back = Quaternion.Inverse(Rotation);
            return new BodyPose(back * -Position, back);
        }

        public bool Same(in BodyPose other) => Position.Equals(other.Position) && Rotation.Equals(other.Rotation);
    }
}
