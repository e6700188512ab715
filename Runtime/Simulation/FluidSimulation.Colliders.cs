using System;
using System.Collections.Generic;
using UnityEngine;

namespace Rill
{
    // Colliders: those that reach into the box, and what the fluid does to them.
    public sealed partial class FluidSimulation
    {
        const int Everything = ~0;

        [Tooltip("Layers whose Fluid Colliders act on this fluid. Fluid Physics Colliders has layers of its own.")]
        [SerializeField] LayerMask fluidColliderLayers = Everything;

        readonly ColliderRegistry colliders = new ColliderRegistry();
        [NonSerialized] bool tooManyIsKnown;

        /// <summary>Layers whose Fluid Colliders act on this fluid; all by default. Acts from the next step on: a collider that another mask,
        /// or another layer of its object, takes out has left the fluid. Without effect on what a <c>FluidPhysicsColliders</c> takes.</summary>
        public LayerMask FluidColliderLayers { get => fluidColliderLayers; set => fluidColliderLayers = value; }

        /// <summary>Whether every Fluid Collider acts on this fluid.</summary>
        internal bool TakesAllLayers => fluidColliderLayers == Everything;

        /// <summary>Whether a Fluid Collider acts on this fluid where it reaches into the box.</summary>
        internal bool Takes(ISceneCollider collider) => TakesAllLayers || (fluidColliderLayers & 1 << collider.Layer) != 0;

        /// <summary>Whether a collider acts on this fluid where it is now.</summary>
        internal bool IsNear(IFluidCollider collider) => pbf != null && (!(collider is ISceneCollider own) || Takes(own))
            && ColliderRegistry.IsNear(collider, Frame, pbf.Layout.DomainSize);

        /// <summary>Colliders of the last steps.</summary>
        internal int ColliderCount => colliders.Set.Count;

        /// <summary>Colliders of the last steps where they ended, in the domain's frame, d.</summary>
        internal ColliderSet ColliderSet => colliders.Set;

        /// <summary>The owner of one of them.</summary>
        internal IFluidCollider ColliderOwner(int index) => colliders.OwnerOf(index);

        internal DomainFrame Frame
        {
            get
            {
                GetPose(out Vector3 place, out Quaternion rotation);
                return new DomainFrame(place, rotation, domainSize, particleSpacing);
            }
        }

        /// <summary>Finds colliders for this fluid alone; null for none.</summary>
        internal IColliderSource ColliderSource { get; set; }

        /// <summary>Sources that have thrown an exception since it was enabled.</summary>
        internal ThrownSources Thrown { get; } = new ThrownSources();

        // Those of this fluid alone; null for none.
        List<IFluidCollider> GatherOwnColliders()
        {
            if (ColliderSource == null)
                return null;
            GetPose(out Vector3 place, out Quaternion rotation);
            try
            {
                return ColliderSource.Gather(place, rotation, domainSize, particleSpacing);
            }
            catch (Exception problem)
            {
                Thrown.Log(problem, ColliderSource, this);
                return null;
            }
        }

        /// <summary>Gathers the colliders that can touch the fluid in the coming steps.</summary>
        /// <param name="duration">Fluid time of the steps, s.</param>
        void CollectColliders(float duration)
        {
            float substepTime = FixedStep / effective.StableSubsteps(GravityStep);      // as PrepareInput will have it
            var steps = new CollectedSteps(this, Frame, pbf.Layout.DomainSize, clock, duration, substepTime);
            colliders.Collect(steps, GatherOwnColliders());
            if (colliders.LeftOutCount > 0 && !tooManyIsKnown)
                Debug.LogError($"Rill: FluidSimulation '{name}' {TooManyProblem}", this);
            tooManyIsKnown = colliders.LeftOutCount > 0;
        }

        /// <summary>Records the handing over of what the fluid did to colliders, unless earlier sums are pending.</summary>
        /// <returns>What to request after the commands ran; null for nothing.</returns>
        ColliderReactions TakeReactions()
        {
            ColliderReactions reactions = pbf.Reactions;
            if (reactions == null || reactions.IsPending)
                return null;
            reactions.Arrived ??= OnReactions;
            pbf.RecordWettedAreas(commands);
            GetPose(out _, out Quaternion rotation);
            colliders.RecordTake(commands, reactions, input, Frame, rotation, this);
            return reactions;
        }

        void OnReactions() => colliders.Deliver(pbf?.Reactions, this, particleSpacing);
    }
}
