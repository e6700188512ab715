using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Rill
{
    // What a snapshot holds of the colliders.
    sealed partial class ColliderRegistry
    {
        public List<ColliderRecord> Save(in DomainFrame frame)
        {
            var records = new List<ColliderRecord>();
            for (int i = 0; i < Set.Count; i++)
            {
                ColliderMotion motion = Set.Items[i];
                IFluidCollider owner = entries[i].owner;
                ColliderMotion now = default;
                bool isThere = owner.IsThere && owner.Describe(out now) == null;
                if (isThere)
                    ToDomain(ref now, frame);
                records.Add(new ColliderRecord
                {
                    shape = (int)motion.shape,
                    size = motion.size,
                    now = isThere ? new PoseRecord(now.end) : default,
                    end = new PoseRecord(motion.end),
                    seen = new PoseRecord(motion.seen),
                    follows = isThere && entries[i].teleports == owner.Teleports ? 1u : 0u,
                });
            }
            return records;
        }

        /// <summary>Takes those that are where they were: they go on from there.</summary>
        /// <param name="tolerance">Of positions and sizes, d.</param>
        /// <param name="own">Those of this fluid alone; null for none.</param>
        /// <returns>Whether all were.</returns>
        public bool Load(ReadOnlySpan<ColliderRecord> records, in DomainFrame frame, float tolerance, List<IFluidCollider> own,
            FluidSimulation fluid)
        {
            MakeEntries();
            ForgetForces(fluid);
            Set.Count = 0;
            foreach (ColliderRecord record in records)
                if (record.follows != 0 && TryFind(record, frame, tolerance, own, fluid, out IFluidCollider owner, out ColliderMotion motion))
                {
                    motion.start = motion.end = record.end.Pose;
                    motion.seen = record.seen.Pose;
                    motion.size = record.size;      // to the bit
                    entries[Set.Count].owner = owner;
                    entries[Set.Count].teleports = owner.Teleports;
                    Set.Items[Set.Count++] = motion;
                }
            return Set.Count == records.Length;
        }

        bool TryFind(in ColliderRecord record, in DomainFrame frame, float tolerance, List<IFluidCollider> own, FluidSimulation fluid,
            out IFluidCollider found, out ColliderMotion motion)
        {
            foreach (FluidCollider collider in FluidCollider.Enabled)
                if (fluid.Takes(collider) && IsOf(record, frame, tolerance, found = collider, out motion))
                    return true;
            for (int i = 0; own != null && i < own.Count; i++)
                if (IsOf(record, frame, tolerance, found = own[i], out motion))
                    return true;
            motion = default;
            found = null;
            return false;
        }

        bool IsOf(in ColliderRecord record, in DomainFrame frame, float tolerance, IFluidCollider collider, out ColliderMotion motion)
        {
            motion = default;
            if (IndexOf(entries, Set.Count, collider) >= 0 || collider.Describe(out motion) != null)
                return false;
            ToDomain(ref motion, frame);
            return (int)motion.shape == record.shape && math.distance(motion.size, record.size) <= tolerance
                && record.now.IsAt(motion.end, tolerance);
        }
    }
}
