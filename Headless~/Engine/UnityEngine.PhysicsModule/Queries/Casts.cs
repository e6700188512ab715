using System;
using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>Hits of rays and of moved or standing shapes in a physics scene. Nothing is allocated where nothing has to grow: each kind of
    /// query fills one list, which holds until the next.</summary>
    internal static class Casts
    {
        static readonly List<RaycastHit> rays = new List<RaycastHit>(), sweeps = new List<RaycastHit>();
        static readonly List<Collider> overlaps = new List<Collider>();
        static HitData[] hits = new HitData[32];
        static int[] ids = new int[32];

        /// <summary>Nearest first; colliders that the ray begins in are not found, as in Unity.</summary>
        public static List<RaycastHit> Rays(SceneData scene, Vector3 origin, Vector3 direction, float distance, int layerMask,
            QueryTriggerInteraction triggers)
        {
            rays.Clear();
            if (direction == Vector3.zero)
                return rays;
            ContactWorld world = PhysicsWorld.Queried(scene);
            int backs = Physics.queriesHitBackfaces ? 1 : 0, count;
            direction = direction.normalized;
            while ((count = Bullet.Ray(world.Handle, origin, direction, distance, backs, hits, hits.Length)) > hits.Length)
                hits = new HitData[count];
            for (int i = 0; i < count; i++)
                if (hits[i].Distance > 0f && Find(world, hits[i].Collider, layerMask, triggers) is Collider found)
                    rays.Add(new RaycastHit(found, hits[i]));
            return rays;
        }

        /// <summary>Nearest first. What overlaps at the start is hit at distance 0, with the reversed direction as its normal.</summary>
        public static List<RaycastHit> Sweeps(SceneData scene, in ShapeDescription shape, BodyPose from, Vector3 direction, float distance,
            int layerMask, QueryTriggerInteraction triggers)
        {
            sweeps.Clear();
            if (direction == Vector3.zero)
                return sweeps;
            direction = direction.normalized;
            List<Collider> around = Overlaps(scene, shape, from, layerMask, triggers);
            foreach (Collider collider in around)
                sweeps.Add(new RaycastHit(collider, new HitData { Normal = -direction }));
            ContactWorld world = PhysicsWorld.Queried(scene);
            IntPtr made = shape.Make();
            int count;
            while ((count = Bullet.Sweep(world.Handle, made, from, direction, distance, hits, hits.Length)) > hits.Length)
                hits = new HitData[count];
            Bullet.ShapeDelete(made);
            for (int i = 0; i < count; i++)
                if (Find(world, hits[i].Collider, layerMask, triggers) is Collider found && !around.Contains(found))
                    sweeps.Add(new RaycastHit(found, hits[i]));
            return sweeps;
        }

        /// <summary>In the order in which the colliders were made.</summary>
        public static List<Collider> Overlaps(SceneData scene, in ShapeDescription shape, BodyPose pose, int layerMask,
            QueryTriggerInteraction triggers)
        {
            overlaps.Clear();
            ContactWorld world = PhysicsWorld.Queried(scene);
            IntPtr made = shape.Make();
            int count;
            while ((count = Bullet.Overlap(world.Handle, made, pose, ids, ids.Length)) > ids.Length)
                ids = new int[count];
            Bullet.ShapeDelete(made);
            for (int i = 0; i < count; i++)
                if (Find(world, ids[i], layerMask, triggers) is Collider found)
                    overlaps.Add(found);
            return overlaps;
        }

        public static ShapeDescription Box(Vector3 half) => new ShapeDescription { Kind = ShapeKind.Box,
            Size = new Vector3(Mathf.Abs(half.x), Mathf.Abs(half.y), Mathf.Abs(half.z)) };

        public static ShapeDescription Sphere(float radius) => new ShapeDescription { Kind = ShapeKind.Sphere, Size = new Vector3(radius, 0f, 0f) };

        public static ShapeDescription Capsule(Vector3 from, Vector3 to, float radius, out BodyPose pose)
        {
            pose = new BodyPose(0.5f * (from + to), from == to ? Quaternion.identity : Quaternion.FromToRotation(Vector3.up, to - from));
            return new ShapeDescription { Kind = ShapeKind.Capsule, Axis = 1, Size = new Vector3(radius, 0.5f * Vector3.Distance(from, to), 0f) };
        }

        // Null where layers or triggers leave it out.
        static Collider Find(ContactWorld world, int id, int layerMask, QueryTriggerInteraction triggers)
        {
            if (!world.Slots.TryGetValue(id, out ColliderSlot slot) || (layerMask & 1 << slot.Collider.gameObject.layer) == 0)
                return null;
            bool counts = !slot.Collider.isTrigger || triggers == QueryTriggerInteraction.Collide
                || triggers == QueryTriggerInteraction.UseGlobal && Physics.queriesHitTriggers;
            return counts ? slot.Collider : null;
        }
    }
}
