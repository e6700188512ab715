using System;
using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>A box, sphere or capsule in world space, to <see cref="FluidSimulation.Fill(FluidShape, Vector3, int, float)"/> or to
    /// <see cref="FluidSimulation.RemoveInside"/>.</summary>
    public readonly struct FluidShape
    {
        internal readonly RoundedBox box;       // world space, m

        FluidShape(in RoundedBox box) => this.box = box;

        /// <summary>A box with sides along the world's axes.</summary>
        /// <param name="center">World space, m.</param>
        /// <param name="size">m, 0 or more.</param>
        /// <exception cref="ArgumentException">A side is negative, or an argument not finite.</exception>
        public static FluidShape Box(Vector3 center, Vector3 size) => Box(center, size, Quaternion.identity);

        /// <summary>A box with sides along the axes of a rotation.</summary>
        /// <param name="center">World space, m.</param>
        /// <param name="size">m, 0 or more.</param>
        /// <param name="rotation">Rotation of the box in world space.</param>
        /// <exception cref="ArgumentException">A side is negative, or an argument not finite.</exception>
        public static FluidShape Box(Vector3 center, Vector3 size, Quaternion rotation)
        {
            if (!Limit.IsPose(center, rotation) || !math.all(math.isfinite((float3)size)) || math.cmin((float3)size) < 0f)
                throw new ArgumentException(
                    Invariant($"A box around {center} of {size} m, turned by {rotation}, is none: give finite numbers, and sides of 0 ") +
                    "or more.");
            return new FluidShape(new RoundedBox { center = center, half = (float3)size * 0.5f, rotation = rotation });
        }

        /// <summary>A sphere.</summary>
        /// <param name="center">World space, m.</param>
        /// <param name="radius">m, 0 or more.</param>
        /// <exception cref="ArgumentException">The radius is negative, or an argument not finite.</exception>
        public static FluidShape Sphere(Vector3 center, float radius) => Capsule(center, center, radius);

        /// <summary>Returns a capsule: all points within the radius of the line between two points.</summary>
        /// <param name="start">Center of the sphere at one end, world space, m.</param>
        /// <param name="end">Center of the sphere at the other end, world space, m.</param>
        /// <param name="radius">m, 0 or more.</param>
        /// <exception cref="ArgumentException">The radius is negative, or an argument not finite.</exception>
        public static FluidShape Capsule(Vector3 start, Vector3 end, float radius)
        {
            if (!math.all(math.isfinite((float3)start)) || !math.all(math.isfinite((float3)end)) || !math.isfinite(radius) || radius < 0f)
                throw new ArgumentException(Invariant($"A sphere or capsule from {start} to {end} with radius {radius} m is none: give ") +
                    "finite numbers, and a radius of 0 or more.");
            Vector3 axis = end - start;
            return new FluidShape(new RoundedBox
            {
                center = (start + end) * 0.5f,
                half = new float3(0f, axis.magnitude * 0.5f, 0f),
                radius = radius,
                rotation = axis.sqrMagnitude > 0f ? Quaternion.FromToRotation(Vector3.up, axis) : Quaternion.identity,
            });
        }
    }
}
