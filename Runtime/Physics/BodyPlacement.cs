using UnityEngine;

namespace Rill
{
    /// <summary>Pose and motion of a Rigidbody, out of it and into it.</summary>
    static class BodyPlacement
    {
        public static void Save(Rigidbody body, ref BodyRecord to)
        {
            Transform shown = body.transform;
            to.pose = new PoseRecord(new RigidPose(body.position, body.rotation));
            to.shown = new PoseRecord(new RigidPose(shown.position, shown.rotation));
            to.velocity = body.GetPointVelocity(body.worldCenterOfMass);
            to.angularVelocity = body.angularVelocity;
            to.force = body.GetAccumulatedForce();
            to.torque = body.GetAccumulatedTorque();
            to.flags = body.IsSleeping() ? BodyRecord.Sleeps : 0;
        }

        /// <summary>Puts a body back.</summary>
        /// <returns>False where it is kinematic, and got no velocity.</returns>
        public static bool Restore(Rigidbody body, in BodyRecord from, in BoxMotion box)
        {
            RigidPose pose = from.pose.Pose, shown = from.shown.Pose;
            body.transform.SetPositionAndRotation(box.Point(shown.position), box.Rotation(shown.rotation));
            UnityEngine.Physics.SyncTransforms();       // else the object's pose would become the body's in the next step
            body.position = box.Point(pose.position);
            body.rotation = box.Rotation(pose.rotation);
            if (body.isKinematic)
                return false;
            body.Sleep();       // which forgets what acts on it
            if (from.Has(BodyRecord.Sleeps))
                return true;
            SetVelocity(body, box.Vector(from.velocity));
            body.angularVelocity = box.Vector(from.angularVelocity);
            body.WakeUp();
            AddIfAny(body, box.Vector(from.force), box.Vector(from.torque));
            return true;
        }

        static void AddIfAny(Rigidbody body, Vector3 force, Vector3 torque)
        {
            if (force != Vector3.zero)
                body.AddForce(force);
            if (torque != Vector3.zero)
                body.AddTorque(torque);
        }

        // linearVelocity from Unity 6 on, which keeps this name too.
        static void SetVelocity(Rigidbody body, Vector3 velocity)
        {
#pragma warning disable 618
            body.velocity = velocity;
#pragma warning restore 618
        }
    }
}
