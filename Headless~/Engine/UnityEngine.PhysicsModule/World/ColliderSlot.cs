using System;

namespace UnityEngine.Headless
{
    /// <summary>A collider in Bullet's world: on the actor of its body, or as an actor of its own.</summary>
    internal sealed class ColliderSlot
    {
        public readonly Collider Collider;
        public readonly ContactWorld World;

        /// <summary>Null where it is an actor of its own.</summary>
        public BodyActor Body;

        public IntPtr Shape { get; private set; }

        /// <summary>In the frame of its body.</summary>
        public BodyPose LocalPose;

        IntPtr actor;
        bool isTrigger, wasKinematic;
        ShapeDescription description;
        BodyPose pose;
        Rigidbody owner;

        public ColliderSlot(Collider collider, ContactWorld world)
        {
            Collider = collider;
            World = world;
        }

        /// <summary>Takes over what changed: shape, body, pose, material.</summary>
        /// <param name="body">That it belongs to; null for none.</param>
        public void Sync(Rigidbody body)
        {
            ShapeDescription now = Collider.Describe();
            bool isChanged = !now.Equals(description) || body != owner || Collider.isTrigger != isTrigger
                || now.Kind == ShapeKind.Triangles && body != null && body.isKinematic != wasKinematic;
            if (isChanged)
                Rebuild(now, body);
            if (Shape == IntPtr.Zero)
                return;
            SetData();
            if (Body != null)
                SyncInBody(isChanged);
            else
                SyncAlone();
        }

        /// <summary>Out of the world, with its shape.</summary>
        public void Leave()
        {
            Detach();
            World.Events.Remove(Collider);
            Bullet.ColliderRemove(World.Handle, Collider.Id);
            World.Slots.Remove(Collider.Id);
            Collider.Slot = null;
        }

        void Detach()
        {
            Body?.Remove(this);
            Body = null;
            if (actor != IntPtr.Zero)
                Bullet.ActorDelete(World.Handle, actor);
            actor = IntPtr.Zero;
            if (Shape != IntPtr.Zero)
                Bullet.ShapeDelete(Shape);
            Shape = IntPtr.Zero;
        }

        void Rebuild(in ShapeDescription now, Rigidbody body)
        {
            Detach();
            description = now;
            owner = body;
            isTrigger = Collider.isTrigger;
            wasKinematic = body != null && body.isKinematic;
            if (CanMeet(now, body))
                Shape = now.Make();
            if (Shape == IntPtr.Zero)
                return;
            if (body != null && !isTrigger)
            {
                Body = World.ActorOf(body);
                Body.Add(this);
                return;
            }
            actor = Bullet.ActorNew(World.Handle, isTrigger ? ActorKind.Trigger : ActorKind.Static);
            Bullet.ActorShapes(World.Handle, actor, 1, new[] { Shape }, new[] { Collider.Id }, new[] { BodyPose.Identity });
            pose = default;
        }

        bool CanMeet(in ShapeDescription now, Rigidbody body)
        {
            if (now.Kind != ShapeKind.Triangles)
                return true;
            if (isTrigger)
                Debug.LogError($"Triggers on concave MeshColliders are not supported: '{Collider.name}'", Collider);
            else if (body != null && !body.isKinematic)
                Debug.LogError("Non-convex MeshCollider with non-kinematic Rigidbody is no longer supported since Unity 5: " +
                    $"'{Collider.name}'. If you want to use a non-convex mesh either make the Rigidbody kinematic or remove the Rigidbody " +
                    "component.", Collider);
            else
                return true;
            return false;
        }

        void SyncInBody(bool isChanged)
        {
            BodyPose local = Collider.PoseIn(owner.transform);
            if (!isChanged && ShapeDescription.Near(local.Position, LocalPose.Position) && local.Rotation.Equals(LocalPose.Rotation))
                return;
            LocalPose = local;
            Body.IsReshaped = true;
        }

        void SyncAlone()
        {
            BodyPose now = owner == null ? Collider.SyncedPose : owner.State.Pose.Of(Collider.PoseIn(owner.transform));
            if (now.Same(pose))
                return;
            pose = now;
            Bullet.ActorPose(World.Handle, actor, now);
        }

        void SetData()
        {
            PhysicMaterial material = Collider.MaterialInUse;
            var data = new ColliderData
            {
                Body = owner != null ? World.ActorOf(owner).Number : -1,
                Flags = (isTrigger ? 1 : 0) | (owner != null && !owner.isKinematic ? 2 : 0) | (owner != null && !owner.detectCollisions ? 4 : 0),
                Layer = Collider.gameObject.layer,
                Includes = (uint)(Collider.includeLayers.value | (owner != null ? owner.includeLayers.value : 0)),
                Excludes = (uint)(Collider.excludeLayers.value | (owner != null ? owner.excludeLayers.value : 0)),
                StaticFriction = material != null ? material.staticFriction : 0.6f,
                DynamicFriction = material != null ? material.dynamicFriction : 0.6f,
                Bounciness = material != null ? material.bounciness : 0f,
                FrictionCombine = material != null ? (int)material.frictionCombine : 0,
                BounceCombine = material != null ? (int)material.bounceCombine : 0,
            };
            Bullet.ColliderSet(World.Handle, Collider.Id, data);
        }
    }
}
