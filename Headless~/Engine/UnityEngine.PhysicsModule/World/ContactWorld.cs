using System;
using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>Bullet's world of a physics scene: what is in it follows Unity's objects at each step and before queries.</summary>
    internal sealed class ContactWorld : IDisposable
    {
        public readonly IntPtr Handle = Bullet.WorldNew();
        public readonly SceneData Scene;
        public readonly Dictionary<int, ColliderSlot> Slots = new Dictionary<int, ColliderSlot>();
        public readonly ContactEvents Events;

        readonly Dictionary<Rigidbody, BodyActor> actors = new Dictionary<Rigidbody, BodyActor>();
        int lastNumber;

        public ContactWorld(SceneData scene)
        {
            Scene = scene;
            Events = new ContactEvents(this);
            foreach ((int a, int b) in CollisionLayers.Ignored)
                Ignore(a, b, true);
        }

        public void Dispose()
        {
            foreach (Joint joint in PhysicsWorld.Joints)
                joint.LeaveWorld();
            foreach (ColliderSlot slot in new List<ColliderSlot>(Slots.Values))
                slot.Leave();
            Bullet.WorldDelete(Handle);
        }

        public void Ignore(int a, int b, bool ignore) => Bullet.WorldIgnore(Handle, a, b, ignore ? 1 : 0);

        public BodyActor ActorOf(Rigidbody body)
        {
            if (!actors.TryGetValue(body, out BodyActor actor))
                actors.Add(body, actor = new BodyActor(body, this, lastNumber++));
            return actor;
        }

        public void Remove(Rigidbody body)
        {
            if (!actors.TryGetValue(body, out BodyActor actor))
                return;
            foreach (Joint joint in PhysicsWorld.Joints)
                if (joint.Holds(body))
                    joint.LeaveWorld();
            foreach (ColliderSlot slot in new List<ColliderSlot>(Slots.Values))
                if (slot.Body == actor)
                    slot.Leave();
            actor.Delete();
            actors.Remove(body);
        }

        /// <summary>Contacts and joints change how bodies move.</summary>
        public void Solve(List<Rigidbody> bodies, float time)
        {
            foreach (Collider collider in PhysicsWorld.Colliders)
                if (PhysicsWorld.SceneOf(collider.gameObject) == Scene && collider.attachedRigidbody == null)
                    collider.Sync();
            foreach (Joint joint in PhysicsWorld.Joints)
                if (PhysicsWorld.SceneOf(joint.gameObject) == Scene)
                    joint.Prepare(this, time);
            Sync();
            Events.BeginStep(bodies);
            int count = Bullet.WorldStep(Handle, time, Physics.bounceThreshold);
            foreach (Rigidbody body in bodies)
                if (actors.TryGetValue(body, out BodyActor actor))
                    actor.Take();
            Events.EndStep(count);
            foreach (Joint joint in PhysicsWorld.Joints.ToArray())
                if (PhysicsWorld.SceneOf(joint.gameObject) == Scene)
                    joint.EndStep();
        }

        /// <summary>Every collider and body as it is known to the physics now.</summary>
        public void Sync()
        {
            Bullet.WorldLayers(Handle, CollisionLayers.Masks);
            foreach (Collider collider in PhysicsWorld.Colliders)
            {
                if (collider.Slot != null && collider.Slot.World != this && PhysicsWorld.SceneOf(collider.gameObject) == Scene)
                    collider.Slot.Leave();
                if (collider.Slot != null && collider.Slot.World == this && PhysicsWorld.SceneOf(collider.gameObject) != Scene)
                    collider.Slot.Leave();
                if (PhysicsWorld.SceneOf(collider.gameObject) != Scene)
                    continue;
                if (collider.Slot == null)
                    Slots.Add(collider.Id, collider.Slot = new ColliderSlot(collider, this));
                collider.Slot.Sync(ActiveBody(collider));
            }
            foreach (BodyActor actor in actors.Values)
                actor.Give();
        }

        static Rigidbody ActiveBody(Collider collider)
        {
            Rigidbody body = collider.attachedRigidbody;
            return body != null && body.Activated ? body : null;
        }
    }
}
