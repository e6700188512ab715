using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>A change in how a fluid touches a collider: it came, it left, or it hit hard.</summary>
    public readonly struct FluidContact
    {
        /// <summary>The <see cref="FluidCollider"/>, or the collider of Unity's physics that a Fluid Physics Colliders took.</summary>
        public readonly Component Collider;

        /// <summary>The fluid that touches it.</summary>
        public readonly FluidSimulation Fluid;

        /// <summary>Impulse that the fluid gave to the collider in the steps of this reading, N s, world space; zero where it left.</summary>
        public readonly Vector3 Impulse;

        /// <summary>Area of the collider's surface that water touches after the last step of the reading, m²; zero where it left, and where
        /// what hit has bounced off since.</summary>
        public readonly float Area;

        /// <summary>Center of that area, world space, m; without an area that of the last reading that had one, or the center of the
        /// collider.</summary>
        public readonly Vector3 Point;

        /// <summary>Mean direction in which that area faces, into the water, world space, length 1. Zero where water is all around the
        /// collider. Without an area that of the last reading that had one.</summary>
        public readonly Vector3 Normal;

        /// <summary>Last step of the reading, as <see cref="FluidSimulation.StepCount"/> counts; two or three frames ago.</summary>
        public readonly int Step;

        /// <summary>Returns what happened in one line, with units.</summary>
        public override string ToString() => Invariant($"'{NameOf(Collider)}' in '{NameOf(Fluid)}', impulse {Impulse:0.000} N s, ") +
            Invariant($"{Area:0.0000} m² wet around {Point:0.000} m, normal {Normal:0.00}, step {Step}");

        static string NameOf(Object named) => named != null ? named.name : "destroyed";

        internal FluidContact(Component collider, in FluidForce force, in WettedArea wetted)
        {
            Collider = collider;
            Fluid = force.From;
            Impulse = force.Impulse;
            Step = force.Step;
            Area = wetted.Area;
            Point = wetted.Point;
            Normal = wetted.Normal;
        }

        /// <summary>Contact of a collider that has left a fluid's box.</summary>
        internal static FluidContact Exit(Component collider, FluidSimulation fluid)
        {
            return new FluidContact(collider, new FluidForce(fluid, Vector3.zero, Vector3.zero, default, 0f, fluid.StepCount),
                new WettedArea(0f, collider.transform.position, Vector3.zero));
        }
    }
}
