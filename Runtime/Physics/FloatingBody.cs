using System.Collections.Generic;
using UnityEngine;

namespace Rill
{
    /// <summary>Gives a Rigidbody what fluids exert on its colliders, at each step of the physics: <see cref="Begin"/>, all parts, the
    /// forces of each fluid, <see cref="TryApply"/>.</summary>
    sealed class FloatingBody
    {
        const float MaxAwaited = 0.08f;      // s

        readonly List<BodyPart> parts = new List<BodyPart>();
        readonly List<BodySurroundings> surroundings = new List<BodySurroundings>();    // one in each fluid
        FloatingResponse response = new FloatingResponse();
        PhysicsStep step;
        Vector3 center;         // of mass
        float mass;
        bool touches;           // the fluid whose parts are being added
        bool waits, awaits, hasActed;
        float awaitedTime;      // s
        int heldFrames, lastHeld;

        /// <summary>Fraction of the body under water, 0 to 1.</summary>
        public float SubmergedFraction => response.Fraction;

        /// <summary>Begins a step.</summary>
        /// <param name="step">Its time is above 0.</param>
        /// <param name="virtualMass">As a fraction of the displaced water; holds while the forces tell nothing of it.</param>
        /// <param name="damping">As a fraction of the critical damping.</param>
        public void Begin(Rigidbody body, in PhysicsStep step, float virtualMass, float damping)
        {
            this.step = step;
            parts.Clear();
            awaitedTime = awaits ? awaitedTime + step.Time : 0f;
            touches = waits = awaits = false;
            center = body.worldCenterOfMass;
            mass = body.mass;
            response.Begin(mass, center, body.GetPointVelocity(center), body.angularVelocity, step.Time, body.inertiaTensor);
            response.Tune(virtualMass, damping);
        }

        /// <summary>Adds a collider of the body, whether or not a fluid tells of it.</summary>
        public void AddPart(in BodyPart part)
        {
            parts.Add(part);
            response.AddPart(part.shape, part.volume);
        }

        /// <summary>Adds the newest of a fluid for one of the parts. Those of the same fluid follow one another, after all parts, and
        /// <see cref="EndFluid"/>.</summary>
        public void Add(in BodyPart part, in FluidForce force)
        {
            touches |= force.Force != Vector3.zero;
            response.Add(part.shape, part.volume, force);
        }

        /// <summary>Ends the parts of one fluid.</summary>
        public void EndFluid(FluidSimulation fluid)
        {
            if (parts.Count > 0)
            {
                BodySurroundings around = SurroundingsIn(fluid);
                StillWater still = around.Look(parts, mass, center, touches, step.Time, response.Level);
                waits |= still.isPending;
                response.EndFluid(around.Density, fluid.Gravity, still);
            }
            touches = false;
        }

        /// <summary>Tells of a fluid that sums a first force.</summary>
        /// <param name="fluid">Null for none.</param>
        public void Await(FluidSimulation fluid)
        {
            awaits |= fluid != null && fluid.IsRunning;
            waits |= awaits && awaitedTime > MaxAwaited;
        }

        /// <summary>Lets the forces act on the body. Where no fluid told of one, what was known of the water is forgotten.</summary>
        /// <param name="maxAcceleration">That fluids give to it, m/s².</param>
        /// <returns>Whether a fluid told of its force in this step.</returns>
        public bool TryApply(Rigidbody body, float maxAcceleration)
        {
            Vector3 gravity = body.useGravity ? UnityEngine.Physics.gravity : Vector3.zero;
            if (waits && TryHold(body, gravity))
                return true;
            if (!response.IsKnown)
            {
                Reset();
                return false;
            }
            response.Solve(gravity, Turn(body, response.Torque), maxAcceleration, out Vector3 acceleration, out Vector3 angularAcceleration);
            step.Accelerate(body, acceleration - gravity, angularAcceleration);     // it falls by itself
            hasActed = true;
            heldFrames = 0;
            return true;
        }

        // In long frames a body would fall for a second before the fluid first tells of itself.
        bool TryHold(Rigidbody body, Vector3 gravity)
        {
            const int MaxFrames = 8;
            const float Slowing = 0.05f;     // s
            if (lastHeld != UnityEngine.Time.frameCount)
                heldFrames++;
            lastHeld = UnityEngine.Time.frameCount;
            if (heldFrames > MaxFrames)
                return false;
            float rate = 1f / (Slowing + step.Time);
            step.Accelerate(body, -gravity - rate * body.GetPointVelocity(center), -rate * body.angularVelocity);
            hasActed = true;
            return true;
        }

        /// <summary>Puts body and what is known of the water into a snapshot of one fluid.</summary>
        public void Save(Rigidbody body, FluidSimulation fluid, SnapshotBody to, SnapshotCapture capture)
        {
            BodyPlacement.Save(body, ref to.record);
            to.record.flags |= (awaits ? BodyRecord.Awaits : 0) | (hasActed ? BodyRecord.HasActed : 0);
            to.record.awaitedTime = awaitedTime;
            to.record.heldFrames = heldFrames;
            to.record.response = response.Save(fluid);
            foreach (BodySurroundings around in surroundings)
                if (ReferenceEquals(around.Fluid, fluid))
                    to.water = around.Save(capture);
        }

        /// <summary>Goes on with what was known of the water.</summary>
        public void Load(FluidSimulation fluid, SnapshotBody from, in BoxMotion box)
        {
            foreach (BodySurroundings around in surroundings)
                if (ReferenceEquals(around.Fluid, fluid))
                    around.Dispose();
            hasActed = true;
            if (box.IsTurned)
            {
                Reset();
                return;
            }
            awaits = from.record.Has(BodyRecord.Awaits);
            hasActed = from.record.Has(BodyRecord.HasActed);
            awaitedTime = from.record.awaitedTime;
            heldFrames = from.record.heldFrames;
            response = FloatingResponse.Of(from.record.response, fluid, box.Shift);
            if (from.water != null)
                SurroundingsIn(fluid).Load(from.water, box.Shift);
        }

        /// <summary>Forgets the water's level and what it resisted with, where it has acted, and asks no more.</summary>
        public void Reset()
        {
            if (hasActed)
                response = new FloatingResponse();
            hasActed = false;
            foreach (BodySurroundings around in surroundings)
                around.Dispose();
            surroundings.Clear();
        }

        BodySurroundings SurroundingsIn(FluidSimulation fluid)
        {
            foreach (BodySurroundings around in surroundings)
                if (ReferenceEquals(around.Fluid, fluid))
                    return around;
            var added = new BodySurroundings(fluid);
            surroundings.Add(added);
            return added;
        }

        /// <summary>The water looks at an object frame by frame: one that moves in fixed steps alone seems to stop and jump.</summary>
        public static void Smooth(Rigidbody body)
        {
            if (body.interpolation == RigidbodyInterpolation.None)
                body.interpolation = RigidbodyInterpolation.Interpolate;
        }

        /// <summary>Volume of a collider, m³; 0 if it has none.</summary>
        /// <param name="field">Field of a mesh; null for a mesh without.</param>
        public static float VolumeOf(in ColliderMotion shape, SignedDistanceField field)
        {
            if (shape.shape != ColliderShape.Mesh)
                return ColliderMeasures.Volume(shape);
            return field != null ? field.Volume * shape.fieldUnit * shape.fieldUnit * shape.fieldUnit : 0f;
        }

        /// <summary>Angular acceleration of the body alone, rad/s².</summary>
        internal static Vector3 Turn(Rigidbody body, Vector3 torque)
        {
            Quaternion axes = body.rotation * body.inertiaTensorRotation;
            Vector3 local = Quaternion.Inverse(axes) * torque, inertia = body.inertiaTensor;
            for (int i = 0; i < 3; i++)
                local[i] = inertia[i] > 0f ? local[i] / inertia[i] : 0f;        // 0 does not turn
            return axes * local;
        }
    }
}
