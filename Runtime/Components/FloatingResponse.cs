using System;
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
    /// Research~/floating-study.md.
    /// </summary>
    /// <remarks>
    /// A body is made of parts, each a collider. Forces, moments and volumes of the parts add up; slip, resistance, the water's level and
    /// the limits are the body's. Where parts touch, the water may push one of them by what all displace: only the sum tells the fraction
    /// that is under water.
    /// </remarks>
    sealed class FloatingResponse
    {
        public const float DefaultVirtualMass = 2.5f;
        public const float DefaultDamping = 0.8f;
        public const float DefaultMaxAcceleration = 100f;       // m/s²
        const float AddedMass = 0.5f;           // of the displaced water: a ball's far from walls (Lamb 1932, art. 92)
        const float TurnDamping = 3f;           // of turns over that of heave: moments on few cells are noisy
        const float MaxPropulsion = 1.1f;      // of the buoyancy
        const float Certain = 0.95f;            // a fraction under water above this is all, and below the rest of it none
        const float LevelRate = 0.1f;           // fraction of a newly found level that is taken at a step
        const float PlateMass = 0.35f;          // of water that a plate carries, over density times area to 3/2 (a disk's is 2/3 of that)
        const float StillDamping = 0.5f;        // of the critical, of water that only its level stands for; beside the setting's
        const float StillDrag = 0.1f;           // of that, along the surface
        const float MaxExcess = 0.1f;           // of a covered face's lift, that is taken off what was measured over the level's
        const int LevelSteps = 24;              // of the bisection for a level: to a 1e-7 of the body's height

        // Effect of one fluid on one part.
        struct Reading
        {
            public ColliderMotion shape;        // where the part is now
            public float volume;                // m³
            public FluidForce force;
            public float height;                // upwards, m
            public float center, centerThen;    // upwards, m; while the force was measured

            public bool IsBall => shape.shape == ColliderShape.Sphere;

            /// <summary>Fraction of the part under a level: of a ball's cap, or of a prism as high as the part.</summary>
            public float Wet(float level, bool then)
            {
                float depth = math.saturate((level - (then ? centerThen : center)) / height + 0.5f);
                return IsBall ? depth * depth * (3f - 2f * depth) : depth;
            }
        }

        Reading[] readings = new Reading[1];    // of the fluid that is being added
        int count;
        Vector3 push, moment;                   // of that fluid, N; about the center of mass, N m
        float mass, inertia, step, virtualFraction, damping;        // kg, the smallest moment in kg m², s
        Vector3 centerOfMass, velocity, angularVelocity;      // m, m/s, rad/s
        Vector3 force, torque;                  // N; about the center of mass, N m
        float reach;                            // from the center of mass to the farthest point of a part, m
        float volume, wetVolume;                // of all parts, m³
        float resistance, turnResistance;       // against slip, kg/s
        Vector3 slowed, turnSlowed;             // they times the slip in which the forces were measured, N; kg rad/s²
        SlipVelocity slip, angularSlip;
        float memory;                           // of the water, s
        VirtualMassEstimate estimate;
        float stiffness, drag, sideDrag, turnStiffness, turnDrag;      // of still water: N/m, kg/s; N m, N m s
        Vector3 waterVelocity, waterUp;         // of it
        float level;                            // of the water, upwards, m
        Vector3 levelShift;                     // of the fluid, when it was found
        bool levelIsKnown;

        /// <summary>Fraction of the body under water, 0 to 1.</summary>
        public float Fraction => volume > 0f ? math.min(wetVolume / volume, 1f) : 0f;

        /// <summary>Height of the water upwards, as far as what was measured tells it, m; else no number.</summary>
        public float Level => levelIsKnown ? level : float.NaN;

        /// <summary>Whether a fluid told of its force.</summary>
        public bool IsKnown { get; private set; }

        /// <summary>Torque of the fluids about the center of mass, N m.</summary>
        public Vector3 Torque => torque;

        /// <summary>All that is kept from step to step.</summary>
        /// <param name="fluid">The level is that of its water.</param>
        public ResponseRecord Save(FluidSimulation fluid) => new ResponseRecord
        {
            slip = slip,
            angularSlip = angularSlip,
            memory = memory,
            level = level,
            volume = volume,
            wetVolume = wetVolume,
            estimate = estimate,
            shiftSince = fluid.Box.WorldShift - levelShift,
            levelIsKnown = levelIsKnown ? 1u : 0u,
        };

        /// <summary>Restores a saved response.</summary>
        /// <param name="moved">How far the fluid is from where it was, m.</param>
        public static FloatingResponse Of(in ResponseRecord record, FluidSimulation fluid, Vector3 moved) => new FloatingResponse
        {
            slip = record.slip,
            angularSlip = record.angularSlip,
            memory = record.memory,
            level = record.level,
            volume = record.volume,
            wetVolume = record.wetVolume,
            estimate = record.estimate,
            levelShift = fluid.Box.WorldShift - record.shiftSince - moved,
            levelIsKnown = record.levelIsKnown != 0,
        };

        /// <summary>Begins a step; of those before, the water's level, the slip and the estimate of the virtual mass are kept.</summary>
        /// <param name="center">Center of mass, world space, m.</param>
        /// <param name="bodyVelocity">Velocity of the center of mass.</param>
        /// <param name="stepTime">Length of this step and of the last, s.</param>
        /// <param name="moments">Moments of inertia about the principal axes, kg m²; about one with 0 the body does not turn.</param>
        public void Begin(float bodyMass, Vector3 center, Vector3 bodyVelocity, Vector3 bodyAngularVelocity, float stepTime,
            Vector3 moments = default)
        {
            IsKnown = false;
            count = 0;
            force = torque = slowed = turnSlowed = Vector3.zero;
            reach = volume = wetVolume = resistance = turnResistance = 0f;
            stiffness = drag = sideDrag = turnStiffness = turnDrag = 0f;
            waterVelocity = waterUp = Vector3.zero;
            mass = bodyMass;
            inertia = MinAboveZero(moments);
            centerOfMass = center;
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

        /// <param name="virtualMassFraction">Virtual mass as a fraction of the displaced water; holds while the forces tell nothing of it.</param>
        /// <param name="dampingFraction">Damping as a fraction of the critical damping.</param>
        public void Tune(float virtualMassFraction, float dampingFraction)
        {
            virtualFraction = virtualMassFraction;
            damping = dampingFraction;
        }

        /// <summary>Adds a part of the body, whether or not a fluid tells of it.</summary>
        /// <param name="shape">World space, m; where the part is now.</param>
        /// <param name="partVolume">m³, above 0.</param>
        public void AddPart(in ColliderMotion shape, float partVolume)
        {
            volume += partVolume;
            reach = math.max(reach, math.distance(shape.end.position, centerOfMass) + shape.Radius);
        }

        /// <summary>Adds what a fluid did to one of the parts. Those of the same fluid follow one another, and
        /// <see cref="EndFluid"/>.</summary>
        public void Add(in ColliderMotion shape, float partVolume, in FluidForce partForce)
        {
            if (count == readings.Length)
                Array.Resize(ref readings, 2 * count);
            readings[count++] = new Reading { shape = shape, volume = partVolume, force = partForce };
        }

        /// <summary>Ends the parts of one fluid.</summary>
        /// <param name="density">Density of the fluid, kg/m³.</param>
        /// <param name="gravity">Gravity of the fluid, m/s².</param>
        /// <param name="still">What water at rest adds to what was measured, or stands for it.</param>
        public void EndFluid(float density, Vector3 gravity, in StillWater still = default)
        {
            if (count == 0)
                return;
            IsKnown = true;
            push = moment = Vector3.zero;
            memory = readings[0].force.Motion.Memory;
            SumForces(out float told, out Vector3 center, out Vector3 slipThen, out Vector3 angularSlipThen);
            float displaced = density * told;     // kg
            float g = gravity.magnitude;
            if (g > 0f)
                AddCovered(still, gravity / -g);
            float fraction = SubmergedFraction(slipThen, displaced, gravity, g);
            if (g > 0f)
            {
                Vector3 up = gravity / -g, measured = push;
                FollowShift(readings[0].force.From, up);
                float height = MeasureHeights(up);
                FindLevel(told, fraction);
                float fractionThen = levelIsKnown ? WetFraction(level, told, then: true) : fraction;
                fraction = levelIsKnown ? WetFraction(level, told, then: false) : fraction;
                for (int i = 0; i < count; i++)
                    BringUpToDate(readings[i], density * g, up, fraction);
                if (levelIsKnown)
                    estimate.Add(measured / displaced - up * (g * fractionThen), slipThen / memory, fractionThen, g, virtualFraction, step);
                LimitPropulsion(displaced * g * fraction, center);
                Damp(displaced, told, height, center, g, up, fraction);
                if (still.weight > 0f)
                    AddStillWater(still, density, told, height, g, up, ref fraction);
            }
            force += push;
            torque += moment;
            // kg/s, times the virtual mass; that of turns is not estimated
            float carried = (1f - still.weight) * displaced * fraction / memory;
            float resists = estimate.Or(virtualFraction) * carried, resistsTurns = virtualFraction * carried;
            resistance += resists;
            turnResistance += resistsTurns;
            slowed += resists * slipThen;
            turnSlowed += resistsTurns * angularSlipThen;
            wetVolume += fraction * told;
            count = 0;
        }

        /// <param name="gravity">By which the body falls, m/s².</param>
        /// <param name="turn">Angular acceleration of the body alone by <see cref="Torque"/>, rad/s². Turns are resisted in proportion
        /// to the inertia as motion is to the mass.</param>
        /// <param name="limit">Largest acceleration by the fluid, m/s².</param>
        public void Solve(Vector3 gravity, Vector3 turn, float limit, out Vector3 acceleration, out Vector3 angularAcceleration)
        {
            float mean = memory > 0f ? SlipVelocity.MeanFraction(step, memory) : 0f;
            Vector3 push = force + mass * gravity + slowed - resistance * mean * (Vector3)slip.Now;
            float carrying = mass + resistance * mean * step;
            // The effect of still water is current and implicit: it stops what is light within a step, and never turns it back.
            Vector3 against = velocity - waterVelocity;
            float rise = Vector3.Dot(against, waterUp), climb = Vector3.Dot(velocity, waterUp);
            push -= sideDrag * (against - rise * waterUp) + (drag * rise + stiffness * step * climb) * waterUp;
            float upward = Vector3.Dot(push, waterUp);
            acceleration = (push - upward * waterUp) / (carrying + sideDrag * step)
                + waterUp * (upward / (carrying + (drag + stiffness * step) * step));
            acceleration = gravity + Limited(acceleration - gravity, limit);
            float stops = inertia > 0f ? mass / inertia * (turnDrag + turnStiffness * step) : 0f;
            angularAcceleration = (mass * turn + turnSlowed - turnResistance * mean * (Vector3)angularSlip.Now - stops * angularVelocity)
                / (mass + (turnResistance * mean + stops) * step);
            angularAcceleration = Limited(angularAcceleration, limit / math.max(reach, 1e-6f));
        }

        // A fluid that is teleported takes its level along.
        void FollowShift(FluidSimulation fluid, Vector3 up)
        {
            if (ReferenceEquals(fluid, null))
                return;
            level += Vector3.Dot(fluid.Box.WorldShift - levelShift, up);
            levelShift = fluid.Box.WorldShift;
        }

        // Forces and moments of all parts as they were measured, their volume, and means over it.
        void SumForces(out float told, out Vector3 center, out Vector3 slipThen, out Vector3 angularSlipThen)
        {
            told = 0f;
            center = slipThen = angularSlipThen = Vector3.zero;
            for (int i = 0; i < count; i++)
            {
                ref Reading part = ref readings[i];
                Push(part.shape.end.position, part.force.Force);
                if (!part.IsBall || part.shape.friction > 0f)       // pressure cannot turn a ball
                    moment += part.force.Torque;
                told += part.volume;
                center += part.volume * (Vector3)part.shape.end.position;
                slipThen += part.volume * part.force.Motion.Slip;
                angularSlipThen += part.volume * part.force.Motion.AngularSlip;
            }
            center /= told;
            slipThen /= told;
            angularSlipThen /= told;
        }

        // The pressure on covered faces, as far as none was measured there: no more than lifts the body as all its lower faces would, and
        // sideways no more than presses it against what covers them.
        void AddCovered(in StillWater still, Vector3 up)
        {
            float lift = Vector3.Dot(still.coveredPush, up);
            Vector3 side = still.coveredPush - lift * up;
            float aside = side.magnitude;
            // If all is covered, nothing measured pulls it down but the water on top of it.
            float measured = Vector3.Dot(push, up);
            float pulled = still.maxLift > 0f ? lift / still.maxLift * math.max(-still.load - measured, 0f) : 0f;
            // Deep water presses harder through a narrow gap than its level does: a little of what is too much goes.
            float least = -MaxExcess * math.min(lift, still.maxLift);
            float missing = pulled + math.min(lift, math.max(still.maxLift - measured - pulled, least));
            float pressed = aside > 0f ? math.clamp(-Vector3.Dot(push, side) / aside, 0f, aside) : 0f;
            Vector3 added = missing * up + (aside > 0f ? side * (pressed / aside) : Vector3.zero);
            float whole = still.coveredPush.magnitude;
            push += added;
            if (whole > 0f)
                moment += still.coveredMoment * (added.magnitude / whole);
        }

        // The level alone stands for what was measured: pressure, and drag towards the water's velocity.
        void AddStillWater(in StillWater still, float density, float told, float height, float g, Vector3 up, ref float fraction)
        {
            float weight = still.weight;
            float wet = WetFraction(still.level, told, then: false);
            push = Vector3.Lerp(push, still.push, weight);
            moment = Vector3.Lerp(moment, still.moment, weight);
            fraction = math.lerp(fraction, wet, weight);
            level = math.lerp(level, still.level, weight);
            levelIsKnown = true;
            float area = told / height, squareWidth = area / 12f;
            float spring = wet < 1f ? density * g * area : 0f;
            float carrying = mass + math.max(AddedMass * density * told * wet, PlateMass * density * area * math.sqrt(area));
            float slows = 2f * (StillDamping + damping) * math.sqrt(density * g * area * carrying);
            float acts = weight * still.contact;
            stiffness += acts * spring;
            drag += acts * slows;
            sideDrag += acts * StillDrag * slows;
            turnStiffness += acts * squareWidth * spring;
            turnDrag += acts * squareWidth * slows;
            waterVelocity = still.velocity;
            waterUp = up;
        }

        // Measures the parts, upwards. Returns the height of the body, m.
        float MeasureHeights(Vector3 up)
        {
            float bottom = float.PositiveInfinity, top = float.NegativeInfinity;
            for (int i = 0; i < count; i++)
            {
                ref Reading part = ref readings[i];
                part.height = ColliderMeasures.Width(part.shape, up);
                part.center = Vector3.Dot(part.shape.end.position, up);
                part.centerThen = Vector3.Dot(part.force.Motion.Position + part.force.ShiftSince, up);
                bottom = math.min(bottom, part.center - 0.5f * part.height);
                top = math.max(top, part.center + 0.5f * part.height);
            }
            return top - bottom;
        }

        // Compares with the weight of the displaced water, less what the slip took off.
        float SubmergedFraction(Vector3 slipThen, float displaced, Vector3 gravity, float g)
        {
            Vector3 whole = gravity + estimate.Or(virtualFraction) / memory * slipThen;
            float square = math.max(whole.sqrMagnitude, 0.0625f * g * g);
            return square > 0f ? math.saturate(-Vector3.Dot(push, whole) / (displaced * square)) : push == Vector3.zero ? 0f : 1f;
        }

        // By the rise of the part since, and its tilt.
        void BringUpToDate(in Reading part, float weight, Vector3 up, float bodyFraction)
        {
            weight *= part.volume;
            float fraction = bodyFraction;
            if (levelIsKnown)
            {
                fraction = part.Wet(level, then: false);
                Push(part.shape.end.position, up * (weight * (fraction - part.Wet(level, then: true))));
            }
            Vector3 turn = RigidPose.RotationVector(part.force.Motion.Rotation, part.shape.end.rotation);
            turn -= up * Vector3.Dot(turn, up);
            float angle = turn.magnitude;
            if (part.IsBall || angle < 1e-6f)
                return;
            // Second moment of the waterline's area about the axis of the turn, as of a rectangle.
            float width = ColliderMeasures.Width(part.shape, Vector3.Cross(up, turn / angle));
            float pierces = math.saturate(8f * math.min(fraction, 1f - fraction));
            moment -= turn * (weight / part.height * width * width / 12f * pierces);
        }

        // The water's height, from a body that pierces it; what is all in or out of the water only bounds it. Filtered: the
        // force tells of more than the draft.
        void FindLevel(float told, float fraction)
        {
            bool pierces = fraction > 1f - Certain && fraction < Certain;
            if (!pierces && !levelIsKnown)
                return;
            float bottom = float.PositiveInfinity, top = float.NegativeInfinity;
            for (int i = 0; i < count; i++)
            {
                bottom = math.min(bottom, readings[i].centerThen - 0.5f * readings[i].height);
                top = math.max(top, readings[i].centerThen + 0.5f * readings[i].height);
            }
            float found = pierces ? LevelOf(fraction, told, bottom, top) : fraction >= Certain ? math.max(level, top) : math.min(level, bottom);
            level = levelIsKnown ? math.lerp(level, found, LevelRate) : found;
            levelIsKnown = true;
        }

        // At which a fraction of the body was under water.
        float LevelOf(float fraction, float told, float low, float high)
        {
            for (int i = 0; i < LevelSteps; i++)
            {
                float between = 0.5f * (low + high);
                if (WetFraction(between, told, then: true) < fraction)
                    low = between;
                else
                    high = between;
            }
            return 0.5f * (low + high);
        }

        float WetFraction(float at, float told, bool then)
        {
            float wet = 0f;
            for (int i = 0; i < count; i++)
                wet += readings[i].volume * readings[i].Wet(at, then);
            return wet / told;
        }

        // Water that is left behind pushes no more, which a late force does not know. Slow bodies are not concerned.
        void LimitPropulsion(float buoyancy, Vector3 center)
        {
            const float Slow = 0.1f;        // m/s
            float speed = velocity.magnitude;
            if (speed < Slow)
                return;
            Vector3 path = velocity / speed;
            Push(center, path * -math.max(Vector3.Dot(push, path) - MaxPropulsion * buoyancy, 0f));
        }

        // Heave and turns, by a fraction of the critical damping of a prism of the body's height and volume, as wide as its parts
        // lie apart.
        void Damp(float displaced, float told, float height, Vector3 center, float g, Vector3 up, float fraction)
        {
            float squareWidth = 0f;     // of one part the area of its prism
            for (int i = 0; i < count; i++)
            {
                ref Reading part = ref readings[i];
                Vector3 off = (Vector3)part.shape.end.position - center;
                off -= up * Vector3.Dot(off, up);
                squareWidth += part.volume / told * (part.volume / part.height + 6f * off.sqrMagnitude);
            }
            float carrying = mass + AddedMass * displaced * fraction;
            float stiffness = displaced * g / height;
            float strength = 2f * damping * math.saturate(4f * fraction);
            Push(center, up * (-strength * math.sqrt(stiffness * carrying) * Vector3.Dot(velocity, up)));
            moment -= angularVelocity * (strength * TurnDamping / 12f
                * math.sqrt(stiffness * squareWidth * carrying * (squareWidth + height * height)));
        }

        // 0 where all are.
        static float MinAboveZero(Vector3 values)
        {
            float min = float.PositiveInfinity;
            for (int i = 0; i < 3; i++)
                min = values[i] > 0f ? math.min(min, values[i]) : min;
            return min < float.PositiveInfinity ? min : 0f;
        }

        void Push(Vector3 at, Vector3 by)
        {
            push += by;
            moment += Vector3.Cross(at - centerOfMass, by);
        }

        static Vector3 Limited(Vector3 value, float limit)
        {
            float square = value.sqrMagnitude;
            return square <= limit * limit ? value : square < float.PositiveInfinity ? value * (limit / math.sqrt(square)) : Vector3.zero;
        }
    }
}
