using UnityEngine;

namespace Rill
{
    /// <summary>Gives a Rigidbody what fluids exert on its colliders, at each step of the physics: <see cref="Begin"/>, all parts, the
    /// forces of each fluid, <see cref="TryApply"/>.</summary>
    sealed class FloatingBody
    {
        FloatingResponse response = new FloatingResponse();
        PhysicsStep step;
        bool hasActed;

        /// <summary>Of the body under water, 0 to 1.</summary>
        public float SubmergedFraction => response.Fraction;

        /// <summary>Begins a step.</summary>
        /// <param name="step">Its time is above 0.</param>
        /// <param name="virtualMass">As a fraction of the displaced water; holds while the forces tell nothing of it.</param>
        /// <param name="damping">As a fraction of the critical damping.</param>
        public void Begin(Rigidbody body, in PhysicsStep step, float virtualMass, float damping)
        {
            this.step = step;
            Vector3 center = body.worldCenterOfMass;
            response.Begin(body.mass, center, body.GetPointVelocity(center), body.angularVelocity, step.Time);
            response.Tune(virtualMass, damping);
        }

        /// <summary>Adds a collider of the body, whether or not a fluid tells of it.</summary>
        /// <param name="shape">World space, m; where it is now.</param>
        /// <param name="volume">m³, above 0.</param>
        public void AddPart(in ColliderMotion shape, float volume) => response.AddPart(shape, volume);

        /// <summary>Adds the newest of a fluid for one of the parts. Those of the same fluid follow one another, and
        /// <see cref="EndFluid"/>.</summary>
        public void Add(in ColliderMotion shape, float volume, in FluidForce force) => response.Add(shape, volume, force);

        /// <summary>Ends the parts of one fluid.</summary>
        public void EndFluid(FluidSimulation fluid) => response.EndFluid(fluid.Material.density, fluid.Gravity);

        /// <summary>Lets the forces act on the body. Where no fluid told of one, what was known of the water is forgotten.</summary>
        /// <param name="maxAcceleration">That fluids give to it, m/s².</param>
        /// <returns>Whether a fluid told of its force in this step.</returns>
        public bool TryApply(Rigidbody body, float maxAcceleration)
        {
            if (!response.IsKnown)
            {
                Reset();
                return false;
            }
            Vector3 gravity = body.useGravity ? UnityEngine.Physics.gravity : Vector3.zero;
            response.Solve(gravity, Turn(body, response.Torque), maxAcceleration, out Vector3 acceleration, out Vector3 angularAcceleration);
            step.Accelerate(body, acceleration - gravity, angularAcceleration);     // it falls by itself
            hasActed = true;
            return true;
        }

        /// <summary>Forgets the water's level and what it resisted with, where it has acted.</summary>
        public void Reset()
        {
            if (hasActed)
                response = new FloatingResponse();
            hasActed = false;
        }

        /// <summary>The water looks at an object frame by frame: one that moves in fixed steps alone seems to stop and jump.</summary>
        public static void Smooth(Rigidbody body)
        {
            if (body.interpolation == RigidbodyInterpolation.None)
                body.interpolation = RigidbodyInterpolation.Interpolate;
        }

        /// <summary>Of a collider, m³; 0 where it has none.</summary>
        /// <param name="field">Of a mesh; null for a mesh without.</param>
        public static float VolumeOf(in ColliderMotion shape, SignedDistanceField field)
        {
            if (shape.shape != ColliderShape.Mesh)
                return ColliderMeasures.Volume(shape);
            return field != null ? field.Volume * shape.fieldUnit * shape.fieldUnit * shape.fieldUnit : 0f;
        }

        // Angular acceleration of the body alone, rad/s².
        static Vector3 Turn(Rigidbody body, Vector3 torque)
        {
            Quaternion axes = body.rotation * body.inertiaTensorRotation;
            Vector3 local = Quaternion.Inverse(axes) * torque, inertia = body.inertiaTensor;
            for (int i = 0; i < 3; i++)
                local[i] = inertia[i] > 0f ? local[i] / inertia[i] : 0f;        // 0 does not turn
            return axes * local;
        }
    }
}
