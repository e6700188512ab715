using System;

namespace UnityEngine.Headless
{
    /// <summary>A joint as Bullet has it: six degrees of freedom between a frame on the connected body, or in the world, and one on the
    /// joint's own.</summary>
    internal sealed class SolvedJoint
    {
        readonly ContactWorld world;
        IntPtr handle;
        readonly BodyPose centerOfOwn, centerOfOther;
        readonly Rigidbody own, other;

        public SolvedJoint(ContactWorld world, Joint joint, Vector3 connectedAnchor)
        {
            this.world = world;
            own = joint.Body;
            other = joint.connectedBody;
            BodyActor actor = world.ActorOf(own), connected = other != null ? world.ActorOf(other) : null;
            centerOfOwn = actor.Center;
            centerOfOther = connected?.Center ?? BodyPose.Identity;
            BodyPose frame = new BodyPose(Vector3.Scale(joint.anchor, joint.transform.lossyScale), Along(joint.axis));
            // The frame on the other stands as the own one does now, about the connected anchor.
            BodyPose now = own.State.Pose.Of(frame);
            Vector3 position = other != null ? Vector3.Scale(connectedAnchor, other.transform.lossyScale) : connectedAnchor;
            Quaternion turn = other != null ? Quaternion.Inverse(other.State.Rotation) * now.Rotation : now.Rotation;
            handle = Bullet.JointNew(world.Handle, actor.Handle, centerOfOwn.Inverse().Of(frame), connected?.Handle ?? IntPtr.Zero,
                centerOfOther.Inverse().Of(new BodyPose(position, turn)), joint.enableCollision ? 1 : 0);
            Wake();
        }

        /// <summary>Whether the bodies are still those that it was made for.</summary>
        public bool Fits(ContactWorld here) => here == world && world.ActorOf(own).Center.Same(centerOfOwn)
            && (other == null || world.ActorOf(other).Center.Same(centerOfOther));

        public void Set(JointAxis[] axes)
        {
            Bullet.JointSet(handle, axes);
            Wake();
        }

        /// <returns>The angle about the axis, radians.</returns>
        public float Read(out Vector3 force, out Vector3 torque)
        {
            Bullet.JointGet(handle, out force, out torque, out float angle);
            return angle;
        }

        public void Delete()
        {
            if (handle != IntPtr.Zero)
                Bullet.JointDelete(world.Handle, handle);
            handle = IntPtr.Zero;
        }

        void Wake()
        {
            own.WakeUp();
            if (other != null)
                other.WakeUp();
        }

        static Quaternion Along(Vector3 axis)
            => axis == Vector3.zero ? Quaternion.identity : Quaternion.FromToRotation(Vector3.right, axis.normalized);
    }
}
