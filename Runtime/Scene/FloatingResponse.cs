using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>
    /// Acceleration of a free body by forces of a fluid that are known late. Applied as they come they blow up where the water
    /// that moves with the body outweighs it (added-mass instability: Causin, Gerbeau and Nobile 2005), and pump up its
    /// heave. Three corrections, all of which vanish at rest: a virtual mass m_v on both sides of Newton's law,
    /// (m + m_v) a = F + m g + m_v a_F, where a_F is the acceleration that the body had while F was measured (stable
    /// while |m_a - m_v| &lt; m + m_v for an added mass m_a); the change of buoyancy and of righting moment since F was
    /// measured, by the shape's mean cross-section; and a limit of the acceleration.
    /// </summary>
    struct FloatingResponse
    {
        public const float DefaultVirtualMass = 1f;
        public const float DefaultMaxAcceleration = 100f;       // m/s²
        const float AddedMass = 0.5f;           // of the displaced water: a sphere's far from walls (Lamb 1932, art. 92)
        const float DryShare = 0.05f;           // submerged less than this the draft is not known well enough to correct
        const float WetShare = 0.1f;            // and dry less than this

        ColliderMotion shape;
        float volume, virtualShare, radius;
        Vector3 force, torque;                  // N, N m about the middle
        Vector3 virtualPush, virtualTurn;       // virtual mass times its accelerations, N; kg rad/s²
        float virtualMass;                      // kg

        /// <summary>Of the body under water, 0 to 1.</summary>
        public float Share { get; private set; }

        /// <summary>Whether a fluid told of its force.</summary>
        public bool IsKnown { get; private set; }

        /// <param name="bodyShape">World space, m; where the body is now.</param>
        /// <param name="bodyVolume">m³.</param>
        /// <param name="share">Virtual mass over that of the displaced water.</param>
        public void Begin(in ColliderMotion bodyShape, float bodyVolume, float share)
        {
            this = default;
            shape = bodyShape;
            volume = bodyVolume;
            virtualShare = share;
            radius = bodyShape.Radius;
        }

        /// <summary>Adds what one fluid did.</summary>
        /// <param name="density">Of the fluid, kg/m³.</param>
        /// <param name="gravity">Of the fluid, m/s².</param>
        public void Add(in FluidForce part, float density, Vector3 gravity)
        {
            IsKnown = true;
            force += part.Force;
            torque += part.Torque;
            float displaced = density * volume;
            float g = gravity.magnitude;
            float share = SubmergedShare(part, displaced, gravity, g);
            float now = g > 0f ? Correct(part, displaced, gravity / -g, g, share) : share;
            Share = math.min(Share + now, 1f);
            float carried = virtualShare * displaced * math.max(share, now);
            virtualMass += carried;
            virtualPush += carried * part.Motion.Acceleration;
            virtualTurn += carried * part.Motion.AngularAcceleration;
        }

        /// <summary>Torque of the fluid, N m.</summary>
        public Vector3 TorqueAbout(Vector3 center) => torque + Vector3.Cross((Vector3)shape.end.position - center, force);

        /// <param name="mass">Of the body, kg.</param>
        /// <param name="gravity">By which the body falls, m/s².</param>
        /// <param name="turn">Angular acceleration of the body alone by <see cref="TorqueAbout"/>, rad/s². Its virtual inertia is to its inertia as the virtual mass to its mass.</param>
        /// <param name="limit">Largest acceleration by the fluid, m/s².</param>
        public void Solve(float mass, Vector3 gravity, Vector3 turn, float limit, out Vector3 acceleration, out Vector3 angularAcceleration)
        {
            float inverse = 1f / (mass + virtualMass);
            acceleration = (force + mass * gravity + virtualPush) * inverse;
            acceleration = gravity + Limited(acceleration - gravity, limit);
            angularAcceleration = Limited((mass * turn + virtualTurn) * inverse, limit / math.max(radius, 1e-6f));
        }

        // Against the weight of the water in the body's place, less what its own acceleration took off.
        static float SubmergedShare(in FluidForce part, float displaced, Vector3 gravity, float g)
        {
            Vector3 whole = gravity + AddedMass * part.Motion.Acceleration;
            float square = math.max(whole.sqrMagnitude, 0.0625f * g * g);
            return square > 0f ? math.saturate(-Vector3.Dot(part.Force, whole) / (displaced * square)) : part.Force == Vector3.zero ? 0f : 1f;
        }

        // Buoyancy and righting moment since the force was measured, of a body that pierces the surface; the share under water now.
        float Correct(in FluidForce part, float displaced, Vector3 up, float g, float share)
        {
            float height = ColliderMeasures.Width(shape, up);
            float rise = Vector3.Dot((Vector3)shape.end.position - part.Motion.Position, up);
            float now = math.saturate(share - rise / height);
            float certainty = math.saturate(math.min(share / DryShare, (1f - share) / WetShare));
            force += up * (displaced * g * certainty * (now - share));

            Vector3 turn = ColliderTrack.RotationVector(part.Motion.Rotation, shape.end.rotation);
            turn -= up * Vector3.Dot(turn, up);
            float angle = turn.magnitude;
            if (shape.shape == ColliderShape.Sphere || angle < 1e-6f)
                return math.lerp(share, now, certainty);
            // Second moment of the waterline's area about the axis of the turn, as of a rectangle.
            float width = ColliderMeasures.Width(shape, Vector3.Cross(up, turn / angle));
            float stiffness = displaced * g / height * width * width / 12f;
            torque -= turn * (stiffness * certainty);
            return math.lerp(share, now, certainty);
        }

        static Vector3 Limited(Vector3 value, float limit)
        {
            float square = value.sqrMagnitude;
            return square <= limit * limit ? value : square < float.PositiveInfinity ? value * (limit / math.sqrt(square)) : Vector3.zero;
        }
    }
}
