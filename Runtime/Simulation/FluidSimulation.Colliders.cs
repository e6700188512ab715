using System;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    // Colliders: those that reach into the box, in its frame, with how they moved since the last steps.
    public sealed partial class FluidSimulation
    {
        readonly ColliderSet colliders = new ColliderSet();
        FluidCollider[] colliderOwners, lastOwners;
        ColliderMotion[] lastMotions;
        int[] colliderTeleports, lastTeleports;
        int lastColliderCount;
        FluidCollider leftOut;      // the first beyond the most
        int leftOutCount;
        bool tooManyIsKnown;
        bool collidersJump;         // what moved since the last steps has not moved through the fluid

        /// <summary>Colliders of the last steps.</summary>
        internal int ColliderCount => colliders.Count;

        /// <summary>Gathers the colliders that can touch the fluid in the coming steps.</summary>
        /// <param name="duration">Fluid time of the steps, s.</param>
        void CollectColliders(float duration)
        {
            if (FluidCollider.Enabled.Count == 0 && colliders.Count == 0)
                return;
            colliderOwners ??= new FluidCollider[ColliderSet.Most];
            lastOwners ??= new FluidCollider[ColliderSet.Most];
            lastMotions ??= new ColliderMotion[ColliderSet.Most];
            colliderTeleports ??= new int[ColliderSet.Most];
            lastTeleports ??= new int[ColliderSet.Most];
            (colliderOwners, lastOwners) = (lastOwners, colliderOwners);
            (colliderTeleports, lastTeleports) = (lastTeleports, colliderTeleports);
            Array.Copy(colliders.Items, lastMotions, colliders.Count);
            lastColliderCount = colliders.Count;
            colliders.Count = 0;

            GetPose(out Vector3 place, out Quaternion rotation);
            var frame = new DomainFrame(place, rotation, domainSize, particleSpacing);
            leftOut = null;
            leftOutCount = 0;
            bool changed = false, reordered = false;
            BeginTracks();
            foreach (FluidCollider collider in FluidCollider.Enabled)
            {
                if (!collider.TryDescribe(out ColliderMotion motion))
                    continue;
                ToDomain(ref motion, frame);
                int last = LastIndex(collider);
                bool follows = last >= 0 && lastTeleports[last] == collider.Teleports && (!collidersJump || motion.seen.Equals(lastMotions[last].seen));
                if (follows)
                    Follow(ref motion, lastMotions[last]);
                if (!IsNear(motion))
                {
                    if (last >= 0)
                        collider.Leave(this);
                    continue;
                }
                if (colliders.Count == ColliderSet.Most)
                {
                    leftOut = leftOut == null ? collider : leftOut;
                    leftOutCount++;
                    continue;
                }
                int index = colliders.Count++;
                reordered |= last != index;
                changed |= last != index || !SameShape(motion, lastMotions[last]);
                colliders.Items[index] = motion;
                colliderOwners[index] = collider;
                colliderTeleports[index] = collider.Teleports;
                if (motion.reacts)
                    Track(index, follows ? last : -1, frame.World(motion.end), duration);
            }
            collidersJump = false;
            if (changed || colliders.Count != lastColliderCount)
                colliders.Version++;
            if (reordered)
                colliders.Order++;
            SayTooMany();
        }

        void ClearColliders() => colliders.Count = 0;

        int LastIndex(FluidCollider collider)
        {
            int likely = colliders.Count;       // where it is as long as none before it came or went
            if (likely < lastColliderCount && ReferenceEquals(lastOwners[likely], collider))
                return likely;
            return Array.IndexOf(lastOwners, collider, 0, lastColliderCount);
        }

        void ToDomain(ref ColliderMotion motion, in DomainFrame frame)
        {
            motion.end = new RigidPose(frame.Point(motion.end.position), frame.Rotation(motion.end.rotation));
            motion.start = motion.seen = motion.end;
            motion.size /= particleSpacing;
            motion.voxel /= particleSpacing;
            motion.fieldUnit /= particleSpacing;
        }

        // Frames and steps differ: an even motion is even in the fluid only if a collider goes as far in the steps as it went in their time.
        void Follow(ref ColliderMotion motion, in ColliderMotion last)
        {
            motion.start = last.end;
            double reached = clock.FrameInterval - clock.FrameLag;       // after the frame before, s
            if (reached >= 0.0)
                motion.end = RigidPose.Between(last.seen, motion.seen, (float)(reached / clock.FrameInterval));
            else
                motion.end = RigidPose.Between(last.end, last.seen, (float)(1.0 + reached / clock.LastFrameLag));
        }

        // Whether it or its way comes near enough to be felt; what has no end, or holds the fluid, does.
        bool IsNear(in ColliderMotion motion)
        {
            if (motion.shape == ColliderShape.Plane || motion.shape == ColliderShape.HeightField || motion.insideOut)
                return true;
            float3 size = (float3)domainSize / particleSpacing;
            float3 nearest = math.clamp(motion.end.position, 0f, size);
            float reach = motion.Radius + (float)LatticeKernels.Support + math.distance(motion.start.position, motion.end.position);
            return math.distancesq(nearest, motion.end.position) < reach * reach;
        }

        static bool SameShape(in ColliderMotion a, in ColliderMotion b)
        {
            return a.shape == b.shape && math.all(a.size == b.size) && a.field == b.field && math.all(a.mirrored == b.mirrored) && a.voxel == b.voxel && a.friction == b.friction
                && a.bounciness == b.bounciness && a.insideOut == b.insideOut && a.contributesDensity == b.contributesDensity;
        }

        void SayTooMany()
        {
            if (leftOutCount > 0 && !tooManyIsKnown)
                Debug.LogError($"Rill: FluidSimulation '{name}' {TooManyProblem}", this);
            tooManyIsKnown = leftOutCount > 0;
        }
    }
}
