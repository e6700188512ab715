using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Rill
{
    /// <summary>The colliders that reach into a fluid's box, in an order that stays while they do, with how they moved since the last
    /// steps.</summary>
    sealed partial class ColliderRegistry
    {
        // A collider of the last steps, beside its motion in the set.
        struct Entry
        {
            public IFluidCollider owner;
            public ColliderMotion motion;       // of the steps before: what the set held then
            public ColliderTrack track;
            public int teleports;
        }

        /// <summary>Colliders as the solver takes them: in the domain's frame, d.</summary>
        public readonly ColliderSet Set = new ColliderSet();

        Entry[] entries, last;      // null until there was a collider
        readonly List<IFluidCollider> leavers = new List<IFluidCollider>();      // whose listeners are to be told
        int lastCount;
        bool changed, reordered;    // of the colliders since the last steps, as far as they are collected

        /// <summary>Whether colliders begin where they are: they have not moved through the fluid since the last steps.</summary>
        public bool IsMotionReset { get; set; }

        /// <summary>Those near the box beyond the most that a fluid takes.</summary>
        public int LeftOutCount { get; private set; }

        /// <summary>The first of them; null for none.</summary>
        public IFluidCollider FirstLeftOut { get; private set; }

        /// <summary>The owner of a collider of the set.</summary>
        public IFluidCollider OwnerOf(int index) => entries[index].owner;

        public void Clear() => Set.Count = 0;

        /// <summary>Gathers the colliders that can touch a fluid in the coming steps.</summary>
        /// <param name="own">Those of this fluid alone; null for none.</param>
        public void Collect(in CollectedSteps steps, List<IFluidCollider> own)
        {
            bool hasOwn = own != null && own.Count > 0;
            if (SceneColliders.Enabled.Count == 0 && !hasOwn && Set.Count == 0)
                return;
            MakeEntries();
            for (int i = 0; i < Set.Count; i++)
                entries[i].motion = Set.Items[i];
            (entries, last) = (last, entries);
            lastCount = Set.Count;
            Set.Count = 0;
            Set.Frame++;
            FirstLeftOut = null;
            LeftOutCount = 0;
            changed = reordered = false;
            DropOtherLayers(steps.fluid);
            foreach (ISceneCollider collider in SceneColliders.Enabled)
                if (steps.fluid.Inputs.Colliders.Takes(collider))
                    TryCollect(steps, collider);
            for (int i = 0; hasOwn && i < own.Count; i++)
                TryCollect(steps, own[i]);
            IsMotionReset = false;
            if (changed || Set.Count != lastCount)
                Set.Version++;
            if (reordered)
                Set.Order++;
        }

        // One that throws is left out, as one that is disabled.
        void TryCollect(in CollectedSteps steps, IFluidCollider collider)
        {
            int before = Set.Count;
            try
            {
                Collect(steps, collider);
            }
            catch (Exception problem)
            {
                Set.Count = before;
                steps.fluid.Inputs.Thrown.Log(problem, collider, steps.fluid);
            }
        }

        void Collect(in CollectedSteps steps, IFluidCollider collider)
        {
            if (!collider.TryDescribe(out ColliderMotion motion))
                return;
            ToDomain(ref motion, steps.frame);
            int before = LastIndex(collider);
            bool follows = before >= 0 && last[before].teleports == collider.Teleports
                && (!IsMotionReset || motion.seen.Equals(last[before].motion.seen))
                && steps.fluid.Box.WentAlong(last[before].motion.seen, motion.seen);
            bool skips = follows && steps.clock.FrameDropped > 0.0 && collider.IsCarried;
            if (follows)
                Follow(ref motion, last[before].motion, steps.clock);
            if (skips)
                SkipDropped(ref motion, last[before].motion, steps);
            if (!IsNear(motion, steps.size))
            {
                if (before >= 0 && collider.Leave(steps.fluid))
                    leavers.Add(collider);
                return;
            }
            if (Set.Count == ColliderSet.MaxCount)
            {
                FirstLeftOut ??= collider;
                LeftOutCount++;
                return;
            }
            if (motion.deforming != null && !TryDeform(ref motion, follows && !IsMotionReset ? last[before].motion : motion, steps.clock))
                return;
            int index = Set.Count++;
            reordered |= before != index;
            changed |= before != index || !SameShape(motion, last[before].motion) || !follows && !motion.end.Equals(last[before].motion.end);
            Set.Items[index] = motion;
            ref Entry entry = ref entries[index];
            entry.owner = collider;
            entry.teleports = collider.Teleports;
            if (!motion.reacts)
                return;
            RigidPose pose = steps.frame.World(motion.end);
            bool goesOn = follows && last[before].motion.reacts;
            entry.track = goesOn ? last[before].track : ColliderTrack.At(pose);
            if (!goesOn)
                collider.AwaitForce(steps.fluid);
            entry.track.GoTo(steps.fluid.Box.Teleported(entry.track.Pose));
            if (skips)
                entry.track.SkipTo(steps.frame.World(motion.start));
            entry.track.Follow(pose, steps.duration, steps.substepTime);
        }

        // Colliders of the last steps that the fluid takes no more: they have left it.
        void DropOtherLayers(FluidSimulation fluid)
        {
            ColliderInputs inputs = fluid.Inputs.Colliders;
            if (inputs.TakesAllLayers)
                return;
            for (int i = 0; i < lastCount; i++)
                if (last[i].owner is ISceneCollider collider && last[i].owner.IsAlive && !inputs.Takes(collider) && last[i].owner.Leave(fluid))
                    leavers.Add(collider);
        }

        void MakeEntries()
        {
            entries ??= new Entry[ColliderSet.MaxCount];
            last ??= new Entry[ColliderSet.MaxCount];
        }

        int LastIndex(IFluidCollider collider)
        {
            int likely = Set.Count;       // where it is as long as none before it came or went
            if (likely < lastCount && ReferenceEquals(last[likely].owner, collider))
                return likely;
            return IndexOf(last, lastCount, collider);
        }

        static int IndexOf(Entry[] entries, int count, IFluidCollider collider)
        {
            for (int i = 0; i < count; i++)
                if (ReferenceEquals(entries[i].owner, collider))
                    return i;
            return -1;
        }

        static void ToDomain(ref ColliderMotion motion, in DomainFrame frame)
        {
            motion.end = new RigidPose(frame.Point(motion.end.position), frame.Rotation(motion.end.rotation));
            motion.start = motion.seen = motion.end;
            motion.size /= frame.Spacing;
            motion.voxel /= frame.Spacing;
            motion.fieldUnit /= frame.Spacing;
        }

        // Frames and steps differ: an even motion is even in the fluid only if a collider goes as far in the steps as it went in their time.
        static void Follow(ref ColliderMotion motion, in ColliderMotion before, FixedStepClock clock)
        {
            motion.start = before.end;
            double reached = clock.FrameInterval - clock.FrameLag;       // after the frame before, s
            if (reached >= 0.0)
                motion.end = RigidPose.Between(before.seen, motion.seen, (float)(reached / clock.FrameInterval));
            else
                motion.end = RigidPose.Between(before.end, before.seen, (float)(1.0 + reached / clock.LastFrameLag));
        }

        // The fluid sees a body that it carries at its true velocity, on the last part of its path: squeezed into the steps that are left,
        // the whole path would seem as many times faster. What holds water sweeps it along on all of its path.
        static void SkipDropped(ref ColliderMotion motion, in ColliderMotion before, in CollectedSteps steps)
        {
            double began = steps.clock.FrameInterval - steps.clock.FrameLag - steps.duration;
            if (began > 0.0)
                motion.start = RigidPose.Between(before.seen, motion.seen, (float)(began / steps.clock.FrameInterval));
        }

        // A surface that deforms goes on from where it was, to where it is between its two newest fields at the end of the steps. False
        // where it could not be baked.
        static bool TryDeform(ref ColliderMotion motion, in ColliderMotion before, FixedStepClock clock)
        {
            double reached = (clock.FrameInterval - clock.FrameLag) / clock.FrameInterval;
            bool follows = ReferenceEquals(before.deforming, motion.deforming) && before.fieldVersion > 0;
            motion.blend = motion.deforming.Follow((float)math.saturate(reached));
            if (motion.deforming.Field == null)
                return false;
            motion.fieldVersion = motion.deforming.Field.Version;
            motion.deforms = follows && (motion.blend != before.blend || motion.fieldVersion != before.fieldVersion);
            return true;
        }

        /// <summary>Whether a collider is near enough to a fluid's box to be felt.</summary>
        public static bool IsNear(IFluidCollider collider, in DomainFrame frame, float3 size)
        {
            if (!collider.IsAlive || collider.Describe(out ColliderMotion motion) != null)
                return false;
            ToDomain(ref motion, frame);
            return IsNear(motion, size);
        }

        // Whether it or its path comes near enough to be felt; what has no end, or holds the fluid, does.
        static bool IsNear(in ColliderMotion motion, float3 size)
        {
            if (motion.shape == ColliderShape.Plane || motion.shape == ColliderShape.HeightField || motion.insideOut)
                return true;
            float3 nearest = math.clamp(motion.end.position, 0f, size);
            float reach = motion.Radius + (float)LatticeKernels.Support + math.distance(motion.start.position, motion.end.position);
            return math.distancesq(nearest, motion.end.position) < reach * reach;
        }

        static bool SameShape(in ColliderMotion a, in ColliderMotion b)
        {
            return a.shape == b.shape && math.all(a.size == b.size) && a.field == b.field && ReferenceEquals(a.deforming, b.deforming)
                && math.all(a.mirrored == b.mirrored)
                && a.voxel == b.voxel && a.friction == b.friction
                && a.bounciness == b.bounciness && a.insideOut == b.insideOut && a.contributesDensity == b.contributesDensity;
        }
    }
}
