using System.Collections.Generic;
using UnityEngine;

namespace Rill
{
    /// <summary>A free Rigidbody that a fluid carries by layer: by all its colliders that the fluid takes.</summary>
    sealed class GatheredBody : ICarriedBody
    {
        readonly FloatingBody floating = new FloatingBody();

        public GatheredBody(Rigidbody body) => Body = body;

        public Rigidbody Body { get; }

        /// <summary>Looked for again before the steps of a frame.</summary>
        public List<GatheredCollider> Parts { get; } = new List<GatheredCollider>();

        /// <summary>The fluid carries it no more.</summary>
        public void Drop() => floating.Reset();

        Component ICarriedBody.Body => Body;

        bool ICarriedBody.IsCarriedBy(FluidSimulation fluid)
        {
            if (Body == null || Body.isKinematic)
                return false;
            foreach (GatheredCollider part in Parts)
                if (fluid.Inputs.Colliders.IsNear(part))
                    return true;
            return false;
        }

        void ICarriedBody.Save(FluidSimulation fluid, SnapshotBody to, SnapshotCapture capture) => floating.Save(Body, fluid, to, capture);

        bool ICarriedBody.Restore(SnapshotBody from, in BoxMotion box) => BodyPlacement.Restore(Body, from.record, box);

        void ICarriedBody.Load(FluidSimulation fluid, SnapshotBody from, in BoxMotion box) => floating.Load(fluid, from, box);

        /// <summary>Lets the fluid act on the body.</summary>
        /// <param name="inUpdate">In Update, and not in FixedUpdate.</param>
        public void Carry(FluidSimulation fluid, bool inUpdate)
        {
            if (Body == null || Body.isKinematic || !fluid.IsRunning)
                return;
            PhysicsStep step = inUpdate ? PhysicsStep.OfUpdate(Body.gameObject) : PhysicsStep.OfFixedUpdate(Body.gameObject);
            if (step.Time <= 0f)
                return;
            PendingReadbacks.FinishResumed();
            FloatingBody.Smooth(Body);
            floating.Begin(Body, step, FloatingResponse.DefaultVirtualMass, FloatingResponse.DefaultDamping);
            foreach (GatheredCollider part in Parts)
                part.AddTo(floating);
            floating.EndFluid(fluid);
            floating.TryApply(Body, FloatingResponse.DefaultMaxAcceleration);
        }
    }
}
