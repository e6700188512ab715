using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>
    /// Acceleration of a free body by forces of a fluid that are known late. Applied as they come they blow up where the water
    /// that resists outweighs the body (added-mass instability: Causin, Gerbeau and Nobile 2005), and pump up its heave. So
    /// what the water does against a slip s is brought up to date, implicitly: m a = F + m g - c (s - s_F), where s_F is the slip
    /// while F was measured (stable while the fluid's own c is below twice this one); so are buoyancy and righting moment, by the
    /// body's displacement since; what a late force can push is limited, heave and turns are damped. All of it vanishes at rest. See
    /// floating-study.md of the documentation.
    /// </summary>
    struct FloatingResponse
    {
        public const float DefaultVirtualMass = 2.5f;
        public const float DefaultDamping = 0.8f;
        public const float DefaultMaxAcceleration = 100f;       // m/s²
        const float AddedMass = 0.5f;           // of the displaced water: a ball's far from walls (Lamb 1932, art. 92)
        const float TurnDamping = 3f;           // of turns over that of heave: moments on few cells are noisy
        const float MaxPropulsion = 1.1f;      // of the buoyancy
        const float Certain = 0.95f;            // a fraction under water above this is all, and below the rest of it none
        const float LevelRate = 0.1f;           // fraction of a newly found level that is taken at a step

        ColliderMotion shape;                   // where the body is now
        float volume, mass, step, virtualFraction, damping;        // m³, kg, s
        Vector3 velocity, angularVelocity;      // m/s, rad/s
        Vector3 force, torque;                  // N; about the middle of the shape, N m
        float resistance, turnResistance;       // against slip, kg/s
        Vector3 slowed, turnSlowed;             // they times the slip in which the forces were measured, N; kg rad/s²
        SlipVelocity slip, angularSlip;
        float memory;                           // of the water, s
        VirtualMassEstimate estimate;
        float level;                            // of the water, upwards, m
        bool levelIsKnown;

        /// <summary>Of the body under water, 0 to 1.</summary>
        public float Fraction { get; private set; }

        /// <summary>Whether a fluid told of its force.</summary>
        public bool IsKnown { get; private set; }

        /// <summary>Begins a step; of those before, the water's level, the slip and the estimate of the virtual mass are kept.</summary>
        /// <param name="bodyShape">World space, m; where the body is now.</param>
        /// <param name="bodyVolume">m³.</param>
        /// <param name="stepTime">Of this step and the last, s.</param>
        public void Begin(in ColliderMotion bodyShape, float bodyVolume, float bodyMass, Vector3 bodyVelocity, Vector3 bodyAngularVelocity,
            float stepTime)
        {
            this = new FloatingResponse
            {
                level = level, levelIsKnown = levelIsKnown, slip = slip, angularSlip = angularSlip,
                memory = memory, estimate = estimate
            };
            shape = bodyShape;
            volume = bodyVolume;
            mass = bodyMass;
            step = stepTime;
            velocity = bodyVelocity;
            angularVelocity = bodyAngularVelocity;
            estimate.Age(step);
            if (memory > 0f)
            {
                slip.Follow(velocity, step, memory);
                angularSlip.Follow(angularVelocity, step, memory);
            }
            Tune(DefaultVirtualMass, DefaultDamping);
        }

        /// <param name="virtualMassFraction">Of the displaced water; holds while the forces tell nothing of it.</param>
        /// <param name="dampingFraction">Of the critical damping.</param>
        public void Tune(float virtualMassFraction, float dampingFraction)
        {
            virtualFraction = virtualMassFraction;
            damping = dampingFraction;
        }

        /// <summary>Adds what one fluid did.</summary>
        /// <param name="density">Of the fluid, kg/m³.</param>
        /// <param name="gravity">Of the fluid, m/s².</param>
        public void Add(in FluidForce part, float density, Vector3 gravity)
        {
            IsKnown = true;
            memory = part.Motion.Memory;
            float displaced = density * volume;     // kg
            float g = gravity.magnitude;
            float fraction = SubmergedFraction(part, displaced, gravity, g);
            Vector3 push = part.Force;
            // pressure cannot turn a ball
            Vector3 moment = shape.shape != ColliderShape.Sphere || shape.friction > 0f ? part.Torque : Vector3.zero;
            if (g > 0f)
            {
                Vector3 up = gravity / -g;
                fraction = BringUpToDate(part.Motion, displaced * g, up, fraction, out float fractionThen, ref push, ref moment);
                if (levelIsKnown)
                    estimate.Add(part.Force / displaced - up * (g * fractionThen), part.Motion.Slip / memory, fractionThen, g, virtualFraction, step);
                LimitPropulsion(displaced * g * fraction, ref push);
                Damp(displaced, g, up, fraction, ref push, ref moment);
            }
            force += push;
            torque += moment;
            float carried = displaced * fraction / memory;      // kg/s, times the virtual mass; that of turns is not estimated
            float resists = estimate.Or(virtualFraction) * carried, resistsTurns = virtualFraction * carried;
            resistance += resists;
            turnResistance += resistsTurns;
            slowed += resists * part.Motion.Slip;
            turnSlowed += resistsTurns * part.Motion.AngularSlip;
            Fraction = math.min(Fraction + fraction, 1f);
        }

        /// <summary>Torque of the fluid, N m.</summary>
        public Vector3 TorqueAbout(Vector3 center) => torque + Vector3.Cross((Vector3)shape.end.position - center, force);

        /// <param name="gravity">By which the body falls, m/s².</param>
        /// <param name="turn">Angular acceleration of the body alone by <see cref="TorqueAbout"/>, rad/s². Turns are resisted in proportion
        /// to the inertia as motion is to the mass.</param>
        /// <param name="limit">Largest acceleration by the fluid, m/s².</param>
        public void Solve(Vector3 gravity, Vector3 turn, float limit, out Vector3 acceleration, out Vector3 angularAcceleration)
        {
            float mean = memory > 0f ? SlipVelocity.MeanFraction(step, memory) : 0f;
            acceleration = (force + mass * gravity + slowed - resistance * mean * (Vector3)slip.Now) / (mass + resistance * mean * step);
            acceleration = gravity + Limited(acceleration - gravity, limit);
            angularAcceleration = (mass * turn + turnSlowed - turnResistance * mean * (Vector3)angularSlip.Now)
                / (mass + turnResistance * mean * step);
            angularAcceleration = Limited(angularAcceleration, limit / math.max(shape.Radius, 1e-6f));
        }

        // Against the weight of the water in the body's place, less what the slip took off.
        float SubmergedFraction(in FluidForce part, float displaced, Vector3 gravity, float g)
        {
            Vector3 whole = gravity + estimate.Or(virtualFraction) / memory * part.Motion.Slip;
            float square = math.max(whole.sqrMagnitude, 0.0625f * g * g);
            return square > 0f ? math.saturate(-Vector3.Dot(part.Force, whole) / (displaced * square)) : part.Force == Vector3.zero ? 0f : 1f;
        }

        // By the rise and the tilt since, of a ball, or of a prism as high and as large as the body. Returns the fraction under water now.
        float BringUpToDate(in RelativeMotion since, float weight, Vector3 up, float fraction, out float fractionThen, ref Vector3 push,
            ref Vector3 moment)
        {
            float height = ColliderMeasures.Width(shape, up);
            float then = Vector3.Dot(since.Position, up);
            FindLevel(then, height, fraction);
            fractionThen = fraction;
            if (levelIsKnown)
            {
                fractionThen = Wet(then, height);
                fraction = Wet(Vector3.Dot((Vector3)shape.end.position, up), height);
                push += up * (weight * (fraction - fractionThen));
            }

            Vector3 turn = ColliderTrack.RotationVector(since.Rotation, shape.end.rotation);
            turn -= up * Vector3.Dot(turn, up);
            float angle = turn.magnitude;
            if (shape.shape == ColliderShape.Sphere || angle < 1e-6f)
                return fraction;
            // Second moment of the waterline's area about the axis of the turn, as of a rectangle.
            float width = ColliderMeasures.Width(shape, Vector3.Cross(up, turn / angle));
            float pierces = math.saturate(8f * math.min(fraction, 1f - fraction));
            moment -= turn * (weight / height * width * width / 12f * pierces);
            return fraction;
        }

        // The water's height, from a body that pierces it; what is all in or out of the water only bounds it. Filtered: the
        // force tells of more than the draft.
        void FindLevel(float middle, float height, float fraction)
        {
            float bottom = middle - 0.5f * height, top = middle + 0.5f * height;
            bool pierces = fraction > 1f - Certain && fraction < Certain;
            if (!pierces && !levelIsKnown)
                return;
            float found = pierces ? bottom + Depth(fraction) * height : fraction >= Certain ? math.max(level, top) : math.min(level, bottom);
            level = levelIsKnown ? math.lerp(level, found, LevelRate) : found;
            levelIsKnown = true;
        }

        float Wet(float middle, float height)
        {
            float depth = math.saturate((level - middle) / height + 0.5f);
            return shape.shape == ColliderShape.Sphere ? depth * depth * (3f - 2f * depth) : depth;
        }

        // The inverse: under water, of the body's height. Of a ball's cap the cubic above is solved by its three angles.
        float Depth(float fraction) => shape.shape == ColliderShape.Sphere ? 0.5f - math.sin(math.asin(1f - 2f * fraction) / 3f) : fraction;

        // Water that is left behind pushes no more, which a late force does not know. Slow bodies are not concerned.
        void LimitPropulsion(float buoyancy, ref Vector3 push)
        {
            const float Slow = 0.1f;        // m/s
            float speed = velocity.magnitude;
            if (speed < Slow)
                return;
            Vector3 path = velocity / speed;
            push -= path * math.max(Vector3.Dot(push, path) - MaxPropulsion * buoyancy, 0f);
        }

        // Heave and turns, by a fraction of the critical damping of a prism of the body's height and volume.
        void Damp(float displaced, float g, Vector3 up, float fraction, ref Vector3 push, ref Vector3 moment)
        {
            float height = ColliderMeasures.Width(shape, up);
            float area = volume / height;
            float carrying = mass + AddedMass * displaced * fraction;
            float stiffness = displaced * g / height;
            float strength = 2f * damping * math.saturate(4f * fraction);
            push -= up * (strength * math.sqrt(stiffness * carrying) * Vector3.Dot(velocity, up));
            moment -= angularVelocity * (strength * TurnDamping / 12f * math.sqrt(stiffness * area * carrying * (area + height * height)));
        }

        static Vector3 Limited(Vector3 value, float limit)
        {
            float square = value.sqrMagnitude;
            return square <= limit * limit ? value : square < float.PositiveInfinity ? value * (limit / math.sqrt(square)) : Vector3.zero;
        }
    }
}
