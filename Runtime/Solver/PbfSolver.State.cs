using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    // Snapshots: all that the next step depends on, out of the solver and into it.
    partial class PbfSolver
    {
        long maxParticles;     // as far as is known without asking the GPU

        /// <summary>Particles at most, as far as is known without asking the GPU.</summary>
        public int MaxAlive => (int)Math.Min(maxParticles, Layout.Capacity);

        /// <summary>Prepares a snapshot of the state that the commands executed so far leave; its sections of the component are yet to be
        /// set.</summary>
        /// <exception cref="InvalidOperationException">More than can be read back.</exception>
        public SnapshotCapture Capture(SnapshotContents contents)
        {
            int most = MaxAlive;
            Save(contents, most);
            var capture = new SnapshotCapture(Layout, contents);
            var state = new List<StateBuffer>();
            ListState(state);
            foreach (StateBuffer buffer in state)
                capture.Add(buffer, most);
            if (neighborSearch.IsSorted)
                capture.Add(new StateBuffer(SnapshotSection.CellStarts, neighborSearch.CellStarts, StateExtent.All), most);
            if (hasLists && Viscosity != null)
            {
                NeighborLists lists = densityConstraint.Lists;
                capture.Add(new StateBuffer(SnapshotSection.NeighborCounts, lists.Counts, StateExtent.Moved), most);
                capture.AddLists(lists.First, Layout.ListWords(Math.Min(most, Layout.FirstListParticles)));
                if (lists.TwoLists)
                    capture.AddLists(lists.Second, Layout.ListWords(Math.Max(most - Layout.FirstListParticles, 0)));
            }
            return capture;
        }

        /// <summary>Adds what was summed of the fluid's forces on colliders.</summary>
        /// <param name="record">What is known of what is pending besides.</param>
        public void CaptureReactions(SnapshotCapture capture, SnapshotContents contents, ColliderSet set, in ReactionsRecord record)
        {
            if (Colliders != null && Colliders.HasSumsOf(set))
                Reactions.Save(capture, contents, record);
        }

        /// <summary>Prepares what there is to see of the particles, without what a step needs besides.</summary>
        /// <exception cref="InvalidOperationException">More than can be read back.</exception>
        public SnapshotCapture CaptureParticles()
        {
            int most = MaxAlive;
            var contents = new SnapshotContents();
            contents.Set(SnapshotSection.Solver, new SolverRecord { maxParticles = (uint)most });
            var capture = new SnapshotCapture(Layout, contents);
            capture.Add(new StateBuffer(SnapshotSection.Counters, particles.Counters, StateExtent.All), most);
            capture.Add(new StateBuffer(SnapshotSection.Positions, particles.Positions, StateExtent.Particles), most);
            capture.Add(new StateBuffer(SnapshotSection.Velocities, particles.Velocities, StateExtent.Particles), most);
            capture.Add(new StateBuffer(SnapshotSection.Ids, particles.Ids, StateExtent.Particles), most);
            if (ParticleTags != null)
                capture.Add(new StateBuffer(SnapshotSection.Tags, ParticleTags.Current, StateExtent.Particles), most);
            return capture;
        }

        /// <summary>Why a snapshot does not fit this solver, with what to do; null where it does.</summary>
        public string ProblemOf(SnapshotContents contents)
        {
            SolverRecord record = contents.Get<SolverRecord>(SnapshotSection.Solver);
            if (record.spacing != Layout.Spacing)
                return Invariant($"it is of a fluid with a particle spacing of {record.spacing} m, but this one has {Layout.Spacing} m. ") +
                    Invariant($"Set the Particle Spacing to {record.spacing}.");
            if (math.any(record.domainSize != Layout.DomainSize))
                return $"it is of a box of {Text(record.domainSize * record.spacing)} m, but this one is " +
                    $"{Text(Layout.DomainSize * Layout.Spacing)} m. Set the Domain Size to that of the snapshot.";
            if (record.particles > Layout.Capacity)
                return Invariant($"it has {record.particles:N0} particles, more than the capacity of {Layout.Capacity:N0}. Raise the ") +
                    Invariant($"Capacity to at least {record.particles:N0}.");
            if (contents.Has(SnapshotSection.CellStarts)
                && contents.Bytes(SnapshotSection.CellStarts).Length != sizeof(uint) * (long)neighborSearch.CellStarts.count)
                return "its cells are not those of its own box, so it is damaged. Use another.";
            if (contents.Has(SnapshotSection.Rest) && !RestingRegions.Fits(Layout, contents))
                return "its resting regions are not those of its own box, so it is damaged. Use another.";
            if (contents.Has(SnapshotSection.Coarse) && !CoarseFits(contents))
                return "its coarse grid is none of its own box, so it is damaged. Use another.";
            return null;
        }

        /// <summary>Replaces the present state by a snapshot, at once.</summary>
        /// <param name="contents">One that fits, see <see cref="ProblemOf"/>.</param>
        /// <param name="features">Those that may be made: the scene asks for them, and device and build have them.</param>
        public void Restore(SnapshotContents contents, FeatureSet features)
        {
            Clear();
            Load(contents);
            MakeStages(contents, features);
            var state = new List<StateBuffer>();
            ListState(state);
            foreach (StateBuffer buffer in state)
                Upload(buffer.Buffer, contents.Bytes(buffer.Section));
            if (contents.Has(SnapshotSection.Reactions) && features.Has(Features.Colliders))
                NeedColliders();
            Colliders?.LoadReactions(contents);
            hasLists = contents.Has(SnapshotSection.NeighborCounts) && Viscosity != null;
            if (hasLists)
                densityConstraint.Lists.Upload(Layout, contents.Values<uint>(SnapshotSection.Neighbors),
                    contents.Values<uint>(SnapshotSection.NeighborCounts));
            using (var cmd = new CommandBuffer { name = "Rill.Restore" })
            {
                particleUpload.RecordArguments(cmd, particles, Layout.Capacity);
                Graphics.ExecuteCommandBuffer(cmd);
            }
            isRestored = true;
            neighborSearch.IsSorted = contents.Has(SnapshotSection.CellStarts);
            Upload(neighborSearch.CellStarts, contents.Bytes(SnapshotSection.CellStarts));
        }

        /// <summary>Takes over the colliders of the next step without a change that would wake sleeping water.</summary>
        public void AdoptColliders(ColliderSet set)
        {
            if (Resting == null && Reactions == null)
                return;
            NeedColliders().Adopt(set);
        }

        // The buffers that the next step depends on, but for the neighbor lists.
        void ListState(List<StateBuffer> state)
        {
            state.Add(new StateBuffer(SnapshotSection.Counters, particles.Counters, StateExtent.All));
            state.Add(new StateBuffer(SnapshotSection.Positions, particles.Positions, StateExtent.Particles));
            state.Add(new StateBuffer(SnapshotSection.Velocities, particles.Velocities, StateExtent.Particles));
            state.Add(new StateBuffer(SnapshotSection.Ids, particles.Ids, StateExtent.Particles));
            state.Add(new StateBuffer(SnapshotSection.StartPositions, particles.Start, StateExtent.Moved));
            foreach (Stage stage in stages)
                stage?.ListState(state);
        }

        // All that is not a buffer.
        void Save(SnapshotContents contents, int most)
        {
            contents.Set(SnapshotSection.Solver, new SolverRecord
            {
                spacing = Layout.Spacing,
                domainSize = Layout.DomainSize,
                maxParticles = (uint)most,
                stepIndex = stepIndex,
                lastSubsteps = lastSubsteps,
                minAdded = minAdded,
                maxAdded = maxAdded,
                flags = (hasNew ? SolverRecord.HasNew : 0u) | (isStart ? SolverRecord.IsStart : 0u)
                    | (HasMarked ? SolverRecord.HasMarked : 0u),
                hasLifetimes = hasLifetimes ? 1u : 0u,
            });
            if (Resting != null)
                contents.Set(SnapshotSection.Rest, Resting.Save());
            if (Coarse != null)
            {
                contents.Set(SnapshotSection.Coarse, new CoarseRecord { wantedSize = Coarse.Grid.WantedSize });
                contents.Set(SnapshotSection.FlowTime, Coarse.FlowTime);
            }
            if (Extrapolation != null)
                contents.Set(SnapshotSection.Extrapolation, Extrapolation.Record);
            if (Fields != null)
                contents.SetValues(SnapshotSection.Fields, Fields.Last);
        }

        void Load(SnapshotContents contents)
        {
            SolverRecord record = contents.Get<SolverRecord>(SnapshotSection.Solver);
            maxParticles = record.maxParticles;
            stepIndex = record.stepIndex;
            lastSubsteps = record.lastSubsteps;
            minAdded = record.minAdded;
            maxAdded = record.maxAdded;
            hasNew = (record.flags & SolverRecord.HasNew) != 0;
            isStart = (record.flags & SolverRecord.IsStart) != 0;
            markedAfter = (record.flags & SolverRecord.HasMarked) != 0 ? stepIndex + 1 : 0;
            hasLifetimes = record.hasLifetimes != 0;
        }

        // Those of which the snapshot has a state. What a step then does not need it gives back, as ever.
        void MakeStages(SnapshotContents contents, FeatureSet features)
        {
            if (contents.Has(SnapshotSection.Tags))
                NeedTags();
            hasLifetimes &= features.Has(Features.Drains);
            if (contents.Has(SnapshotSection.Rest) && features.Has(Features.Sleep))
            {
                RestingRegions resting = Resting ?? Keep(Features.Sleep, new RestingRegions(Layout));
                resting.Load(contents.Get<RestRecord>(SnapshotSection.Rest));
            }
            if (contents.Has(SnapshotSection.Coarse) && features.Has(Features.DeepWater))
                Keep(Features.DeepWater,
                    new CoarseCorrection(Layout, contents.Get<CoarseRecord>(SnapshotSection.Coarse).wantedSize, Limits,
                    contents.Has(SnapshotSection.Slips) && features.Has(Features.Materials))
                    {
                        FlowTime = contents.Get<float>(SnapshotSection.FlowTime),
                        IsFirst = false,
                    });
            if (contents.Has(SnapshotSection.Extrapolation))
                Keep(Features.Extrapolation, new VelocityExtrapolation(Layout.Capacity)).Record
                    = contents.Get<ExtrapolationRecord>(SnapshotSection.Extrapolation);
            if (contents.Has(SnapshotSection.Slips) && features.Has(Features.Materials))
                Keep(Features.Materials, new MaterialTable(Layout.Capacity));
            if (contents.Has(SnapshotSection.Conformation) && features.Has(Features.Elasticity))
                Keep(Features.Elasticity, new Viscoelasticity(Layout.Capacity));
            if (contents.Has(SnapshotSection.FrictionStress) && features.Has(Features.GrainFriction))
                Keep(Features.GrainFriction, new GrainFriction(Layout));
            if (contents.Has(SnapshotSection.NeighborCounts) && features.Has(Features.Viscosity))
                Keep(Features.Viscosity, new ImplicitViscosity(Layout.Capacity));
            if (contents.Has(SnapshotSection.EmitterStates) && features.Has(Features.Emitters))
                NeedEmitters();
            if (contents.Has(SnapshotSection.DrainStates) && features.Has(Features.Drains))
                NeedDrains();
            if (contents.Has(SnapshotSection.Fields) && features.Has(Features.ForceFields))
                (Fields ?? Keep(Features.ForceFields, new ForceFields())).Last = contents.Values<FieldRegion>(SnapshotSection.Fields);
            else
            {
                if (contents.Has(SnapshotSection.Fields))
                    Wake();     // they have gone
                Release(Features.ForceFields);        // what the scene has then counts as come
            }
        }

        Colliders NeedColliders() => Colliders ?? Keep(Features.Colliders, new Colliders(Layout, ReadbackErrors));

        bool CoarseFits(SnapshotContents contents)
        {
            float size = contents.Get<CoarseRecord>(SnapshotSection.Coarse).wantedSize;
            if (!CoarseGrid.IsCellSize(Layout.DomainSize, size))
                return false;
            long bytes = sizeof(float) * (long)new CoarseGrid(Layout.DomainSize, size).Total;
            foreach (SnapshotSection section in new[] { SnapshotSection.CoarseSurface, SnapshotSection.CoarseErrors,
                SnapshotSection.FlowPotential, SnapshotSection.ErrorPotential })
                if (contents.Bytes(section).Length != bytes)
                    return false;
            return true;
        }

        static void Upload(GraphicsBuffer buffer, byte[] bytes)
        {
            if (bytes.Length > 0)
                buffer.SetData(MemoryMarshal.Cast<byte, uint>(bytes).ToArray(), 0, 0, bytes.Length / sizeof(uint));
        }

        static string Text(float3 v) => Invariant($"{v.x} x {v.y} x {v.z}");
    }
}
