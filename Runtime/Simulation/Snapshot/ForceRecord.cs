using System.Runtime.InteropServices;
using UnityEngine;

namespace Rill
{
    /// <summary>Force of the fluid on a collider, as far as it is known, and how the collider moves. World space.</summary>
    [StructLayout(LayoutKind.Sequential, Pack = 4)]
    struct ForceRecord
    {
        /// <summary>Flags: <see cref="Reacts"/> and so on.</summary>
        public uint flags;
        public ColliderTrack track;
        public Vector3 force, torque;
        public RelativeMotion motion;
        public float duration;
        public int step;
        /// <summary>How far the fluid was teleported since, m.</summary>
        public Vector3 shiftSince;
        public WettedArea wetted, lastWetted;
        /// <summary>s.</summary>
        public float quiet;

        public const uint Reacts = 1;
        /// <summary>There is a force.</summary>
        public const uint HasForce = 2;
        /// <summary>A first force is summed.</summary>
        public const uint Awaits = 4;
        /// <summary>State of a <see cref="ContactWatch"/>.</summary>
        public const uint Touches = 8, Hits = 16, WasWet = 32;
        public const uint All = 2 * WasWet - 1;

        public bool Has(uint flag) => (flags & flag) != 0;

        public void Set(in FluidForce from, in ContactWatch watch)
        {
            flags |= HasForce;
            force = from.Force;
            torque = from.Torque;
            motion = from.Motion;
            duration = from.Duration;
            step = from.Step;
            shiftSince = from.ShiftSince;
            wetted = from.Wetted;
            watch.Save(ref this);
        }

        /// <param name="moved">How far the fluid is from where it was in the snapshot, m.</param>
        public FluidForce ForceFrom(FluidSimulation fluid, Vector3 moved)
            => new FluidForce(fluid, force, torque, motion, duration, step, fluid.Box.WorldShift - shiftSince - moved, wetted);
    }
}
