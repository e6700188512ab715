using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Colliders of a fluid: those of the scene that reach into its box, those that it alone has, and what the fluid does to
    /// them.</summary>
    sealed class ColliderInputs
    {
        const int TooMany = 0;      // problem of the log

        readonly FluidSimulation fluid;
        readonly ColliderRegistry registry = new ColliderRegistry();
        OnceLog log;

        public ColliderInputs(FluidSimulation fluid) => this.fluid = fluid;

        /// <summary>Finds colliders for this fluid alone; null for none.</summary>
        public IColliderSource Source { get; set; }

        /// <summary>Colliders of the last steps where they ended, in the domain's frame, d.</summary>
        public ColliderSet Set => registry.Set;

        /// <summary>Why colliders are left out; null where none is.</summary>
        public string Problem => registry.LeftOutCount > 0 ? TooManyProblem : null;

        /// <summary>Whether every Fluid Collider acts on this fluid.</summary>
        public bool TakesAllLayers => fluid.FluidColliderLayers == FluidSimulation.AllLayers;

        /// <summary>Whether a Fluid Collider acts on this fluid where it reaches into the box.</summary>
        public bool Takes(ISceneCollider collider) => TakesAllLayers || (fluid.FluidColliderLayers & 1 << collider.Layer) != 0;

        /// <summary>Whether a collider acts on this fluid where it is now.</summary>
        public bool IsNear(IFluidCollider collider) => fluid.IsRunning && (!(collider is ISceneCollider own) || Takes(own))
            && ColliderRegistry.IsNear(collider, fluid.Box.Frame, fluid.Solver.Layout.DomainSize);

        /// <summary>Returns the owner of a collider of the set.</summary>
        public IFluidCollider OwnerOf(int index) => registry.OwnerOf(index);

        /// <summary>Raises the events of colliders that have left the fluid.</summary>
        public void RaiseExits() => registry.RaiseExit(fluid);

        /// <summary>Gathers the colliders that can touch the fluid in the coming steps.</summary>
        /// <param name="duration">Fluid time of the steps, s.</param>
        /// <param name="substepTime">s.</param>
        public void Collect(float duration, float substepTime)
        {
            var steps = new CollectedSteps(fluid, fluid.Box.Frame, fluid.Solver.Layout.DomainSize, fluid.Clock.Steps, duration, substepTime);
            registry.Collect(steps, GatherOwn());
            if (log.ShouldLog(TooMany, registry.LeftOutCount > 0))
                Debug.LogError($"Rill: FluidSimulation '{fluid.name}' {TooManyProblem}", fluid);
        }

        /// <summary>Records the readback of what the fluid did to colliders, unless earlier sums are pending.</summary>
        /// <returns>What to request after the commands ran; null for nothing.</returns>
        public ColliderReactions RecordReactions(CommandBuffer commands, in StepInput input)
        {
            ColliderReactions reactions = fluid.Solver.Reactions;
            if (reactions == null || reactions.IsPending)
                return null;
            reactions.Arrived ??= Deliver;
            fluid.Solver.RecordWettedAreas(commands);
            fluid.GetPose(out _, out Quaternion rotation);
            registry.RecordTake(commands, reactions, input, fluid.Box.Frame, rotation, fluid);
            return reactions;
        }

        /// <summary>Lets colliders begin where they are: they have not moved through the fluid since the last steps.</summary>
        public void ResetMotion() => registry.IsMotionReset = true;

        /// <summary>Drops the forces on colliders that have not come back yet.</summary>
        public void DropForces() => registry.DropForces(fluid);

        public void Clear() => registry.Clear();

        public void Save(ref TimeRecord to) => to.collidersJump = registry.IsMotionReset ? 1u : 0u;

        public void Load(in TimeRecord from) => registry.IsMotionReset = from.collidersJump != 0;

        public void Save(SnapshotContents contents, in DomainFrame frame)
            => contents.SetIfAny(SnapshotSection.Colliders, registry.Save(frame));

        public void SaveForces(SnapshotContents contents, SnapshotCapture capture)
        {
            contents.SetIfAny(SnapshotSection.Forces, registry.SaveForces(fluid));
            var taken = new List<TakenRecord>();
            ReactionsRecord reactions = registry.SaveTaken(fluid, taken);
            fluid.Solver.CaptureReactions(capture, contents, registry.Set, reactions);
            contents.SetIfAny(SnapshotSection.TakenColliders, taken);
        }

        /// <summary>Loads the colliders that are where they were, which go on from there. The others are new to the fluid, and wake what
        /// sleeps.</summary>
        /// <param name="tolerance">Distance within which a collider is where it was, d.</param>
        public void Load(SnapshotContents contents, in DomainFrame frame, in BoxMotion box, float tolerance)
        {
            ReadOnlySpan<ColliderRecord> records = contents.Values<ColliderRecord>(SnapshotSection.Colliders);
            int before = registry.Set.Count;
            bool areAllThere = registry.Load(records, frame, tolerance, GatherOwn(), fluid);
            if (!box.IsTurned)
                registry.LoadForces(fluid, contents, box.Shift);
            if (records.Length > 0 && areAllThere && fluid.Support.Gate.IsLoaded(Features.Colliders))
            {
                if (!box.IsTurned)
                    fluid.Solver.AdoptColliders(registry.Set);
                if (fluid.Solver.Reactions != null)
                    fluid.Solver.Reactions.Arrived = Deliver;
            }
            else if (records.Length + before > 0)
            {
                registry.Set.Version++;
                fluid.Solver.Wake();       // also where none is left, which no step would notice
            }
        }

        // Colliders of this fluid alone; null for none.
        List<IFluidCollider> GatherOwn()
        {
            if (Source == null)
                return null;
            fluid.GetPose(out Vector3 position, out Quaternion rotation);
            try
            {
                return Source.Gather(position, rotation, fluid.DomainSize, fluid.ParticleSpacing);
            }
            catch (Exception problem)
            {
                fluid.Inputs.Thrown.Log(problem, Source, fluid);
                return null;
            }
        }

        void Deliver() => registry.Deliver(fluid.Solver?.Reactions, fluid, fluid.ParticleSpacing);

        string TooManyProblem => Invariant($"takes {ColliderSet.MaxCount} colliders at a time; {registry.LeftOutCount} more are in its box ") +
            $"and left out, '{(registry.FirstLeftOut.IsAlive ? registry.FirstLeftOut.Name : "")}' first. Merge meshes into one field, " +
            "or disable colliders that the fluid does not reach.";
    }
}
