using System;
using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>A body in Bullet's world: its colliders about its center of mass, and how it moves.</summary>
    internal sealed class BodyActor
    {
        public readonly Rigidbody Rigidbody;
        public readonly IntPtr Handle;

        /// <summary>By which colliders tell bodies apart.</summary>
        public readonly int Number;

        /// <summary>Its colliders have changed since they were given to Bullet.</summary>
        public bool IsReshaped = true;

        readonly ContactWorld world;
        readonly List<ColliderSlot> slots = new List<ColliderSlot>();
        BodyPose center;       // of mass with the principal axes, in the frame of the body
        BodyData before;
        bool isAsleep;          // as Bullet left it

        public BodyActor(Rigidbody rigidbody, ContactWorld world, int number)
        {
            Rigidbody = rigidbody;
            Number = number;
            this.world = world;
            Handle = Bullet.ActorNew(world.Handle, ActorKind.Body);
        }

        /// <summary>The frame of the center of mass in the body's.</summary>
        public BodyPose Center => new BodyPose(Rigidbody.centerOfMass, Rigidbody.inertiaTensorRotation);

        public void Add(ColliderSlot slot)
        {
            slots.Add(slot);
            IsReshaped = true;
        }

        /// <summary>Bullet lets go of the shape at once: it may be gone after this.</summary>
        public void Remove(ColliderSlot slot)
        {
            slots.Remove(slot);
            GiveShapes();
            IsReshaped = true;
        }

        public void Delete() => Bullet.ActorDelete(world.Handle, Handle);

        /// <summary>Gives pose, motion and properties, before a step or a query.</summary>
        public void Give()
        {
            BodyPose now = Center;
            if (IsReshaped || !now.Same(center))
            {
                center = now;
                GiveShapes();
                IsReshaped = false;
                Rigidbody.State.IsTouched = true;
            }
            before = new BodyData
            {
                Pose = Rigidbody.State.Pose.Of(center),
                Velocity = Rigidbody.State.Velocity,
                AngularVelocity = Rigidbody.State.AngularVelocity,
                Mass = Rigidbody.mass,
                Inertia = Rigidbody.inertiaTensor,
                LinearFactor = Free(RigidbodyConstraints.FreezePositionX),
                AngularFactor = Free(RigidbodyConstraints.FreezeRotationX),
                SleepThreshold = Rigidbody.sleepThreshold,
                SweptRadius = Rigidbody.collisionDetectionMode == CollisionDetectionMode.Discrete ? 0f : SweptRadius(),
                IsKinematic = Rigidbody.isKinematic ? 1 : 0,
                Activity = Activity(),
            };
            Bullet.BodySet(world.Handle, Handle, before);
        }

        /// <summary>Takes the result of contacts and joints. A body that nothing touched goes on to the last digit as a free one.</summary>
        public void Take()
        {
            if (Rigidbody.isKinematic)
                return;
            Bullet.BodyGet(Handle, before, out SolvedBody after);
            isAsleep = after.IsAsleep != 0;
            if (isAsleep)
                Rigidbody.Sleep();
            else
                Rigidbody.State.Sleeps = false;
            if (after.IsChanged == 0 || isAsleep)
                return;
            Rigidbody.State.Velocity = after.Velocity;
            Rigidbody.State.AngularVelocity = after.AngularVelocity;
            Rigidbody.State.Limit(Rigidbody);
            if (!after.Pose.Same(before.Pose))
                Rigidbody.State.Push(after.Pose.Of(center.Inverse()));
        }

        BodyActivity Activity()
        {
            BodyState state = Rigidbody.State;
            if (Rigidbody.isKinematic)
                return state.IsTouched || state.Velocity != Vector3.zero || state.AngularVelocity != Vector3.zero ? BodyActivity.Awake
                    : BodyActivity.Asleep;
            // Bullet may have woken since what it had put to sleep.
            return state.Sleeps ? isAsleep ? BodyActivity.Unchanged : BodyActivity.Asleep : state.IsTouched ? BodyActivity.Awake
            : BodyActivity.Unchanged;
        }

        Vector3 Free(RigidbodyConstraints first)
        {
            Vector3 free = Vector3.one;
            for (int axis = 0; axis < 3; axis++)
                if (((int)Rigidbody.constraints & (int)first << axis) != 0)
                    free[axis] = 0f;
            return free;
        }

        // A ball within the thinnest of its shapes.
        float SweptRadius()
        {
            float radius = float.PositiveInfinity;
            foreach (ColliderSlot slot in slots)
            {
                Vector3 half = slot.Collider.Describe().LocalBounds().extents;
                radius = Mathf.Min(radius, Mathf.Min(half.x, Mathf.Min(half.y, half.z)));
            }
            return float.IsInfinity(radius) ? 0f : radius;
        }

        void GiveShapes()
        {
            var shapes = new IntPtr[slots.Count];
            var ids = new int[slots.Count];
            var poses = new BodyPose[slots.Count];
            BodyPose back = center.Inverse();
            for (int i = 0; i < slots.Count; i++)
            {
                shapes[i] = slots[i].Shape;
                ids[i] = slots[i].Collider.Id;
                BodyPose pose = back.Of(slots[i].LocalPose);
                // Rounding must not keep a shape about the center of mass from being one.
                poses[i] = pose.Position.sqrMagnitude < 1e-14f && pose.Rotation.Equals(Quaternion.identity) ? BodyPose.Identity : pose;
            }
            Bullet.ActorShapes(world.Handle, Handle, slots.Count, shapes, ids, poses);
        }
    }
}
