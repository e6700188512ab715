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
        public const float DefaultVirtualMass = 0.5f;
        public const float DefaultDamping = 0.4f;
        public const float DefaultMaxAcceleration = 100f;       // m/s²
        const float AddedMass = 0.5f;           // of the displaced water: a sphere's far from walls (Lamb 1932, art. 92)
        const float MissingMass = 0.3f;         // of the added mass what deep water's coarse grid does not return, of the displaced water
        const float LevelRate = 0.1f;           // share of a new level that is taken at a step
        const float TurnDamping = 3f;           // of turns over that of heave: moments on few cells are noisy
        const float Certain = 0.95f;            // a share under water above this is all, and below the rest of it none

        ColliderMotion shape;
        float volume, virtualShare, radius;
        Vector3 force, torque;                  // N, N m about the middle
        Vector3 virtualPush, virtualTurn;       // virtual mass times its accelerations, N; kg rad/s²
        float virtualMass, missingMass;         // kg
        float mass, damping;
        Vector3 velocity, angularVelocity;      // m/s, rad/s
        float level;                            // of the water, upwards, m
        bool levelIsKnown;

        /// <summary>Of the body under water, 0 to 1.</summary>
        public float Share { get; private set; }

        /// <summary>Whether a fluid told of its force.</summary>
        public bool IsKnown { get; private set; }

        /// <param name="bodyShape">World space, m; where the body is now.</param>
        /// <param name="bodyVolume">m³.</param>
        /// <param name="share">Virtual mass over that of the displaced water.</param>
        public void Begin(in ColliderMotion bodyShape, float bodyVolume, float share, float bodyMass, Vector3 bodyVelocity, Vector3 bodyAngularVelocity, float dampingShare)
        {
            this = new FloatingResponse { level = level, levelIsKnown = levelIsKnown };
            shape = bodyShape;
            volume = bodyVolume;
            virtualShare = share;
            radius = bodyShape.Radius;
            velocity = bodyVelocity;
            angularVelocity = bodyAngularVelocity;
            mass = bodyMass;
            damping = dampingShare;
        }

        /// <summary>Adds what one fluid did.</summary>
        /// <param name="density">Of the fluid, kg/m³.</param>
        /// <param name="gravity">Of the fluid, m/s².</param>
        public void Add(in FluidForce part, float density, Vector3 gravity)
        {
            IsKnown = true;
            force += part.Force;
            if (shape.shape != ColliderShape.Sphere || shape.friction > 0f)     // pressure cannot turn a ball
                torque += part.Torque;
            float displaced = density * volume;
            float g = gravity.magnitude;
            float share = SubmergedShare(part, displaced, gravity, g);
            float now = g > 0f ? Correct(part, displaced, gravity / -g, g, share) : share;
            float carried = virtualShare * displaced * now;
            virtualMass += carried;
            virtualPush += carried * part.Motion.Acceleration;
            virtualTurn += carried * part.Motion.AngularAcceleration;
            missingMass += MissingMass * displaced * now;
            Share = math.min(Share + now, 1f);
            if (g <= 0f)
                return;
            LimitPropulsion(displaced * g * now);
            Damp(displaced, gravity / -g, g, now);
        }

        /// <summary>Torque of the fluid, N m.</summary>
        public Vector3 TorqueAbout(Vector3 center) => torque + Vector3.Cross((Vector3)shape.end.position - center, force);

        /// <param name="gravity">By which the body falls, m/s².</param>
        /// <param name="turn">Angular acceleration of the body alone by <see cref="TorqueAbout"/>, rad/s². Its virtual inertia is to its inertia as the virtual mass to its mass.</param>
        /// <param name="limit">Largest acceleration by the fluid, m/s².</param>
        public void Solve(Vector3 gravity, Vector3 turn, float limit, out Vector3 acceleration, out Vector3 angularAcceleration)
        {
            float inverse = 1f / (mass + missingMass + virtualMass);
            acceleration = (force + mass * gravity + virtualPush) * inverse;
            acceleration = gravity + Limited(acceleration - gravity, limit);
            angularAcceleration = Limited((mass * turn + virtualTurn) * inverse, limit / math.max(radius, 1e-6f));
        }

        void LimitPropulsion(float most)
        {
            float speed = velocity.magnitude;
            if (speed < 1e-3f)
                return;
            Vector3 way = velocity / speed;
            float along = Vector3.Dot(force, way);
            most = math.lerp(100f * most, 1.1f * most, math.saturate(speed / 0.1f));
            if (along > most)
                force -= way * (along - most);
        }

        // Of heave, and of turning, as a share of the critical damping of a prism of the body's height and volume.
        void Damp(float displaced, Vector3 up, float g, float now)
        {
            float height = ColliderMeasures.Width(shape, up);
            float area = volume / height;
            float carrying = mass + AddedMass * displaced * now;
            float stiffness = displaced * g / height;
            float strength = 2f * damping * math.saturate(4f * now);
            force -= up * (strength * math.sqrt(stiffness * carrying) * Vector3.Dot(velocity, up));
            torque -= angularVelocity * (strength * math.sqrt(stiffness * area * carrying * (area + height * height)) * (TurnDamping / 12f));
        }

        // Against the weight of the water in the body's place, less what its own acceleration took off.
        static float SubmergedShare(in FluidForce part, float displaced, Vector3 gravity, float g)
        {
            Vector3 whole = gravity + AddedMass * part.Motion.Acceleration;
            float square = math.max(whole.sqrMagnitude, 0.0625f * g * g);
            return square > 0f ? math.saturate(-Vector3.Dot(part.Force, whole) / (displaced * square)) : part.Force == Vector3.zero ? 0f : 1f;
        }

        // Buoyancy and righting moment since the force was measured, of a prism as high and as large as the body; the share under water now.
        float Correct(in FluidForce part, float displaced, Vector3 up, float g, float share)
        {
            float height = ColliderMeasures.Width(shape, up);
            float then = Vector3.Dot(part.Motion.Position, up);
            FindLevel(then, height, share);
            float now = share;
            if (levelIsKnown)
            {
                now = Wet(Vector3.Dot((Vector3)shape.end.position, up), height);
                force += up * (displaced * g * (now - Wet(then, height)));
            }

            Vector3 turn = ColliderTrack.RotationVector(part.Motion.Rotation, shape.end.rotation);
            turn -= up * Vector3.Dot(turn, up);
            float angle = turn.magnitude;
            if (shape.shape == ColliderShape.Sphere || angle < 1e-6f)
                return now;
            // Second moment of the waterline's area about the axis of the turn, as of a rectangle.
            float width = ColliderMeasures.Width(shape, Vector3.Cross(up, turn / angle));
            float pierces = math.saturate(8f * math.min(now, 1f - now));
            torque -= turn * (displaced * g / height * width * width / 12f * pierces);
            return now;
        }

        // The water's height, from a body that pierces it; what is all in or out of the water only bounds it. Filtered: the
        // force tells of more than the draft.
        void FindLevel(float middle, float height, float share)
        {
            float bottom = middle - 0.5f * height, top = middle + 0.5f * height;
            bool pierces = share > 1f - Certain && share < Certain;
            if (!pierces && !levelIsKnown)
                return;
            float found = pierces ? bottom + share * height : share >= Certain ? math.max(level, top) : math.min(level, bottom);
            level = levelIsKnown ? math.lerp(level, found, LevelRate) : found;
            levelIsKnown = true;
        }

        float Wet(float middle, float height) => math.saturate((level - middle) / height + 0.5f);

        static Vector3 Limited(Vector3 value, float limit)
        {
            float square = value.sqrMagnitude;
            return square <= limit * limit ? value : square < float.PositiveInfinity ? value * (limit / math.sqrt(square)) : Vector3.zero;
        }
    }
}
