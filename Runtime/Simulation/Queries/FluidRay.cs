using System;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>In which direction a ray has to cross the water's surface to hit it.</summary>
    [Flags, GenerateHlsl("Queries", Prefix = "Crossing")]
    public enum FluidCrossing
    {
        /// <summary>Into the water. Water in which the ray starts is not hit, as by Physics.Raycast.</summary>
        Enter = 1,
        /// <summary>Out of the water.</summary>
        Leave = 2,
        /// <summary>Either.</summary>
        Any = Enter | Leave,
    }

    /// <summary>A ray that is cast against the water by a <see cref="FluidQueryBatch"/>, or a ball that is cast along it.</summary>
    public struct FluidRay
    {
        /// <summary>Largest radius of a ball, in particle spacings of the fluid.</summary>
        public const float MaxRadius = RayQuery.MaxRadius;

        /// <summary>Start of the ray, or the ball's center there, world space, m.</summary>
        public Vector3 origin;
        /// <summary>Direction, world space, of any length above 0.</summary>
        public Vector3 direction;
        /// <summary>How far it goes, m, above 0; infinity for no limit. Only the part in the fluid's box is searched.</summary>
        public float maxDistance;
        /// <summary>Radius of the ball, m; 0 for a ray. At most <see cref="MaxRadius"/> particle spacings.</summary>
        public float radius;
        /// <summary>Which crossings hit. A ball only enters.</summary>
        public FluidCrossing crossing;

        /// <summary>A ray.</summary>
        /// <param name="origin">World space, m.</param>
        /// <param name="direction">World space, of any length above 0.</param>
        /// <param name="maxDistance">m, above 0.</param>
        /// <param name="crossing">Which crossings hit.</param>
        public FluidRay(Vector3 origin, Vector3 direction, float maxDistance = float.PositiveInfinity, FluidCrossing crossing = FluidCrossing.Enter)
        {
            this.origin = origin;
            this.direction = direction;
            this.maxDistance = maxDistance;
            this.crossing = crossing;
            radius = 0f;
        }

        /// <summary>A ball that is cast along a ray: it hits where it first touches the water.</summary>
        /// <param name="origin">The ball's center at the start, world space, m.</param>
        /// <param name="radius">m, 0 to <see cref="MaxRadius"/> particle spacings.</param>
        /// <param name="direction">World space, of any length above 0.</param>
        /// <param name="maxDistance">Maximum distance that the center moves, m, above 0.</param>
        public static FluidRay Sphere(Vector3 origin, float radius, Vector3 direction, float maxDistance = float.PositiveInfinity)
            => new FluidRay(origin, direction, maxDistance) { radius = radius };

        /// <summary>Problem that keeps it from being cast; null for none.</summary>
        /// <param name="spacing">Spacing of the fluid's particles, m.</param>
        internal string Problem(float spacing)
        {
            if (!Limit.IsPose(origin, Quaternion.identity))
                return Invariant($"starts at {origin}, which is not a position: give finite numbers");
            float length = direction.magnitude;
            if (!(length > 0f) || float.IsInfinity(length))
                return Invariant($"has the direction {direction}, which points nowhere: give a finite one that is not 0");
            if (!(maxDistance > 0f))
                return Invariant($"goes {maxDistance} m far: give a distance above 0, or infinity");
            if (!(radius >= 0f) || radius > MaxRadius * spacing)
                return Invariant($"has a radius of {radius} m: give 0 to {MaxRadius * spacing} m, which is {MaxRadius} particle spacings");
            if ((crossing & FluidCrossing.Any) == 0)
                return Invariant($"has the crossing {crossing}, and hits nothing: give Enter, Leave or Any");
            return radius > 0f && crossing != FluidCrossing.Enter
                ? Invariant($"is a ball with the crossing {crossing}: a ball only enters, cast a ray to find where it leaves") : null;
        }
    }

    /// <summary>Result of a <see cref="FluidRay"/> at the end of one step. World space, SI units.</summary>
    public struct FluidRayHit
    {
        /// <summary>Whether all below was measured. False before the first result since a restart; a valid one without a hit has missed the
        /// water.</summary>
        public bool valid;
        /// <summary>Fixed step since the restart after which it was measured.</summary>
        public int step;
        /// <summary>Fluid time of that step, s.</summary>
        public double time;
        /// <summary>Fluid time from there to the current frame when this was asked for, s.</summary>
        public float age;
        /// <summary>The ray that was cast.</summary>
        public FluidRay ray;
        /// <summary>Whether the ray starts in water, or the ball touches some at its start: then the ball has no hit.</summary>
        public bool startsInWater;
        /// <summary>Whether the water was hit. Without a hit the values below are 0.</summary>
        public bool hit;
        /// <summary>From the ray's origin to the hit, for a ball to its center there, m.</summary>
        public float distance;
        /// <summary>Point where the water was hit, m.</summary>
        public Vector3 point;
        /// <summary>Normal of the surface there, out of the water, length 1; of the box's wall where the water ends at one.</summary>
        public Vector3 normal;
        /// <summary>Velocity of the water there relative to the box, m/s.</summary>
        public Vector3 velocity;
        /// <summary>Phase of most of the water there, 0 to 7.</summary>
        public int phase;

        /// <summary>Position to which <see cref="velocity"/> has carried <see cref="point"/> until the frame in which this was asked for, m: without
        /// the lag, and wrong by what changed its course since.</summary>
        public Vector3 ExtrapolatedPoint => point + velocity * age;

        /// <summary>Returns what was hit in one line, with units.</summary>
        public override string ToString() => !valid ? "not measured" : !hit ? startsInWater ? "no hit, starts in water" : "no hit"
            : Invariant($"hit at {point:0.000} m after {distance:0.000} m, step {step}, {age:0.000} s old");

        /// <param name="by">By which the box and its water were put elsewhere since, m.</param>
        internal void Shift(Vector3 by)
        {
            ray.origin += by;
            if (hit)
                point += by;
        }
    }
}
