using UnityEngine;

namespace Rill
{
    /// <summary>Gives a Rigidbody what fluids exert on its collider, at each fixed step: <see cref="Begin"/>, the forces,
    /// <see cref="Apply"/>.</summary>
    struct FloatingBody
    {
        FloatingResponse response;

        /// <summary>Of the body under water, 0 to 1.</summary>
        public float SubmergedFraction => response.Fraction;

        /// <summary>Whether a fluid told of its force in this step.</summary>
        public bool IsKnown => response.IsKnown;

        /// <param name="shape">World space, m; where the body is now.</param>
        /// <param name="volume">m³.</param>
        /// <param name="virtualMass">As a fraction of the displaced water; holds while the forces tell nothing of it.</param>
        /// <param name="damping">As a fraction of the critical damping.</param>
        public void Begin(Rigidbody body, in ColliderMotion shape, float volume, float virtualMass, float damping)
        {
            response.Begin(shape, volume, body.mass, body.GetPointVelocity(body.worldCenterOfMass), body.angularVelocity, Time.fixedDeltaTime);
            response.Tune(virtualMass, damping);
        }

        /// <summary>Adds the newest of a fluid, unless it has ended.</summary>
        public void Add(in FluidForce force)
        {
            if (force.From != null && force.From.isActiveAndEnabled)
                response.Add(force, force.From.Material.density, force.From.Gravity);
        }

        /// <summary>Lets the forces act on the body.</summary>
        /// <param name="maxAcceleration">That fluids give to it, m/s².</param>
        public void Apply(Rigidbody body, float maxAcceleration)
        {
            Vector3 gravity = body.useGravity ? UnityEngine.Physics.gravity : Vector3.zero;
            Vector3 torque = response.TorqueAbout(body.worldCenterOfMass);
            response.Solve(gravity, Turn(body, torque), maxAcceleration, out Vector3 acceleration, out Vector3 angularAcceleration);
            body.AddForce(acceleration - gravity, ForceMode.Acceleration);      // it falls by itself
            body.AddTorque(angularAcceleration, ForceMode.Acceleration);
        }

        /// <summary>The water looks at an object frame by frame: one that moves in fixed steps alone seems to stop and jump.</summary>
        public static void Smooth(Rigidbody body)
        {
            if (body.interpolation == RigidbodyInterpolation.None)
                body.interpolation = RigidbodyInterpolation.Interpolate;
        }

        /// <summary>Of a collider, m³; 0 where it has none.</summary>
        /// <param name="field">Of a mesh.</param>
        public static float VolumeOf(in ColliderMotion shape, SignedDistanceField field)
        {
            return shape.shape == ColliderShape.Mesh ? field.Volume * shape.fieldUnit * shape.fieldUnit * shape.fieldUnit
                : ColliderMeasures.Volume(shape);
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
