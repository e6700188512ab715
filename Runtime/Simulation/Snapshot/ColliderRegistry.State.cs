using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    // Colliders in snapshots.
    sealed partial class ColliderRegistry
    {
        readonly int[] found = new int[ColliderSet.MaxCount];       // the records of those of the set

        public List<ColliderRecord> Save(in DomainFrame frame)
        {
            var records = new List<ColliderRecord>();
            for (int i = 0; i < Set.Count; i++)
            {
                ColliderMotion motion = Set.Items[i];
                IFluidCollider owner = entries[i].owner;
                ColliderMotion now = default;
                bool isAlive = owner.IsAlive && owner.Describe(out now) == null;
                if (isAlive)
                    ToDomain(ref now, frame);
                records.Add(new ColliderRecord
                {
                    shape = (int)motion.shape,
                    size = motion.size,
                    now = isAlive ? new PoseRecord(now.end) : default,
                    end = new PoseRecord(motion.end),
                    seen = new PoseRecord(motion.seen),
                    follows = isAlive && entries[i].teleports == owner.Teleports ? 1u : 0u,
                });
            }
            return records;
        }

        /// <summary>Forces on the colliders as far as they are known; none where no collider measures its force.</summary>
        public List<ForceRecord> SaveForces(FluidSimulation fluid)
        {
            var records = new List<ForceRecord>();
            if (!Set.Reacts)
                return records;
            for (int i = 0; i < Set.Count; i++)
            {
                var record = new ForceRecord();
                if (Set.Items[i].reacts)
                {
                    record.flags = ForceRecord.Reacts;
                    record.track = entries[i].track;
                    entries[i].owner.SaveForce(fluid, ref record);
                }
                records.Add(record);
            }
            return records;
        }

        /// <summary>Colliders that wait for sums that are pending.</summary>
        public ReactionsRecord SaveTaken(FluidSimulation fluid, List<TakenRecord> records)
        {
            for (int i = 0; i < takenCount; i++)
                records.Add(new TakenRecord { motion = taken[i].motion, position = taken[i].position, arm = taken[i].arm });
            return new ReactionsRecord
            {
                takenImpulse = takenImpulse,
                takenRotation = takenRotation,
                shiftSince = fluid.Box.WorldShift - takenShift,
                takenStep = takenStep,
            };
        }

        /// <summary>Takes what was known of the forces on those that were found.</summary>
        /// <param name="moved">How far the fluid is from where it was, m.</param>
        public void LoadForces(FluidSimulation fluid, SnapshotContents contents, Vector3 moved)
        {
            ReadOnlySpan<ForceRecord> forces = contents.Values<ForceRecord>(SnapshotSection.Forces);
            for (int i = 0; i < Set.Count && forces.Length > 0; i++)
            {
                ref readonly ForceRecord record = ref forces[found[i]];
                if (!record.Has(ForceRecord.Reacts) || !Set.Items[i].reacts)
                    continue;
                entries[i].track = record.track;
                entries[i].track.Shift(moved);
                entries[i].owner.LoadForce(fluid, record, moved);
            }
            ReadOnlySpan<TakenRecord> records = contents.Values<TakenRecord>(SnapshotSection.TakenColliders);
            takenCount = 0;
            if (records.Length != Set.Count || !contents.Has(SnapshotSection.Reactions))
                return;
            taken ??= new Taken[ColliderSet.MaxCount];
            takenCount = records.Length;
            for (int i = 0; i < takenCount; i++)
                taken[i] = new Taken
                {
                    owner = entries[i].owner,
                    motion = records[i].motion,
                    position = records[i].position,
                    arm = records[i].arm,
                };
            ReactionsRecord sums = contents.Get<ReactionsRecord>(SnapshotSection.Reactions);
            takenImpulse = sums.takenImpulse;
            takenRotation = sums.takenRotation;
            takenShift = fluid.Box.WorldShift - sums.shiftSince - moved;
            takenStep = sums.takenStep;
        }

        /// <summary>Takes those that are where they were: they go on from there.</summary>
        /// <param name="tolerance">Tolerance of positions and sizes, d.</param>
        /// <param name="own">Those of this fluid alone; null for none.</param>
        /// <returns>Whether all were.</returns>
        public bool Load(ReadOnlySpan<ColliderRecord> records, in DomainFrame frame, float tolerance, List<IFluidCollider> own,
            FluidSimulation fluid)
        {
            MakeEntries();
            DropForces(fluid);
            Set.Count = 0;
            for (int i = 0; i < records.Length; i++)
            {
                ref readonly ColliderRecord record = ref records[i];
                if (record.follows != 0 && TryFind(record, frame, tolerance, own, fluid, out IFluidCollider owner, out ColliderMotion motion))
                {
                    found[Set.Count] = i;
                    motion.start = motion.end = record.end.Pose;
                    motion.seen = record.seen.Pose;
                    motion.size = record.size;      // to the bit
                    entries[Set.Count].owner = owner;
                    entries[Set.Count].teleports = owner.Teleports;
                    Set.Items[Set.Count++] = motion;
                }
            }
            return Set.Count == records.Length;
        }

        bool TryFind(in ColliderRecord record, in DomainFrame frame, float tolerance, List<IFluidCollider> own, FluidSimulation fluid,
            out IFluidCollider found, out ColliderMotion motion)
        {
            foreach (ISceneCollider collider in SceneColliders.Enabled)
                if (fluid.Inputs.Colliders.Takes(collider) && IsOf(record, frame, tolerance, found = collider, out motion))
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
