using System;
using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>What rays and moved or standing shapes find in a physics scene, before layers and triggers are looked at.</summary>
    internal static class Casts
    {
        static HitData[] hits = new HitData[32];
        static int[] ids = new int[32];

        /// <summary>Nearest first; colliders that the ray begins in are not found, as in Unity.</summary>
        public static List<RaycastHit> Rays(SceneData scene, Vector3 origin, Vector3 direction, float distance)
        {
            ContactWorld world = PhysicsWorld.Queried(scene);
            direction = direction.normalized;
            int count;
            while ((count = Bullet.Ray(world.Handle, origin, direction, distance, Physics.queriesHitBackfaces ? 1 : 0, hits, hits.Length)) > hits.Length)
                hits = new HitData[count];
            List<RaycastHit> found = Read(world, count);
            found.RemoveAll(hit => hit.distance <= 0f);
            return found;
        }

        /// <summary>Nearest first. One that overlaps at the start is hit at distance 0, with the way back as its normal.</summary>
        public static List<RaycastHit> Sweeps(SceneData scene, in ShapeDescription shape, BodyPose from, Vector3 direction, float distance)
        {
            ContactWorld world = PhysicsWorld.Queried(scene);
            direction = direction.normalized;
            IntPtr made = shape.Make();
            int count;
            while ((count = Bullet.Sweep(world.Handle, made, from, direction, distance, hits, hits.Length)) > hits.Length)
                hits = new HitData[count];
            List<RaycastHit> found = Read(world, count);
            Bullet.ShapeDelete(made);
            List<Collider> around = Overlaps(scene, shape, from);
            found.RemoveAll(hit => around.Contains(hit.collider));
            foreach (Collider collider in around)
                found.Insert(0, new RaycastHit(collider, new HitData { Normal = -direction }));
            return found;
        }

        /// <summary>In the order in which the colliders were made.</summary>
        public static List<Collider> Overlaps(SceneData scene, in ShapeDescription shape, BodyPose pose)
        {
            ContactWorld world = PhysicsWorld.Queried(scene);
            IntPtr made = shape.Make();
            int count;
            while ((count = Bullet.Overlap(world.Handle, made, pose, ids, ids.Length)) > ids.Length)
                ids = new int[count];
            Bullet.ShapeDelete(made);
            var found = new List<Collider>(count);
            for (int i = 0; i < count; i++)
                if (world.Slots.TryGetValue(ids[i], out ColliderSlot slot))
                    found.Add(slot.Collider);
            return found;
        }

        /// <summary>What layers and triggers leave.</summary>
        public static bool Counts(Collider collider, int layerMask, QueryTriggerInteraction triggers)
            => (layerMask & 1 << collider.gameObject.layer) != 0 && (!collider.isTrigger || triggers == QueryTriggerInteraction.Collide
                || triggers == QueryTriggerInteraction.UseGlobal && Physics.queriesHitTriggers);

        public static ShapeDescription Box(Vector3 half) => new ShapeDescription { Kind = ShapeKind.Box,
            Size = new Vector3(Mathf.Abs(half.x), Mathf.Abs(half.y), Mathf.Abs(half.z)) };

        public static ShapeDescription Sphere(float radius) => new ShapeDescription { Kind = ShapeKind.Sphere, Size = new Vector3(radius, 0f, 0f) };

        public static ShapeDescription Capsule(Vector3 from, Vector3 to, float radius, out BodyPose pose)
        {
            pose = new BodyPose(0.5f * (from + to), from == to ? Quaternion.identity : Quaternion.FromToRotation(Vector3.up, to - from));
            return new ShapeDescription { Kind = ShapeKind.Capsule, Axis = 1, Size = new Vector3(radius, 0.5f * Vector3.Distance(from, to), 0f) };
        }

        static List<RaycastHit> Read(ContactWorld world, int count)
        {
            var found = new List<RaycastHit>(count);
            for (int i = 0; i < count; i++)
                if (world.Slots.TryGetValue(hits[i].Collider, out ColliderSlot slot))
                    found.Add(new RaycastHit(slot.Collider, hits[i]));
            return found;
        }
    }
}
