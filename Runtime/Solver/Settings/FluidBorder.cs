using System;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>One side of a fluid's box: a wall, or a band of water that absorbs waves or lets water through.</summary>
    [Serializable]
    public struct FluidBorder
    {
        /// <summary>Fastest flow through a side, m/s.</summary>
        internal const float MaxVelocity = 100f;

        /// <summary>Longest length that a border can be given, m.</summary>
        internal const float MaxLength = 1e6f;

        /// <summary>Wall: waves come back. Absorbing: a band takes them. Open: water enters and leaves.</summary>
        [Tooltip("Wall: waves come back. Absorbing: a band takes them. Open: water enters and leaves.")]
        public BorderKind kind;

        /// <summary>Width of the band, m, at least four particle spacings. Absorbing: a third of the longest wave.</summary>
        [Tooltip("Width of the band, m, at least four particle spacings. Absorbing: a third of the longest wave.")]
        public float width;

        /// <summary>Velocity through an open side, m/s, above 0 into the box. -100 to 100.</summary>
        [Tooltip("Velocity through an open side, m/s, above 0 into the box. -100 to 100.")]
        public float velocity;

        /// <summary>Level at an open side, m above the floor of the box.</summary>
        [Tooltip("Level at an open side, m above the floor of the box.")]
        public float level;

        /// <summary>A wall; the values that another kind starts with.</summary>
        public static FluidBorder Default => new FluidBorder { width = 1f, level = 1f };

        /// <summary>Says what the side is, with its values.</summary>
        public override readonly string ToString() => kind == BorderKind.Wall ? "wall"
            : kind == BorderKind.Absorbing ? Invariant($"absorbing, {width} m wide")
            : Invariant($"open, {width} m wide, {velocity} m/s, level {level} m");

        /// <summary>Whether another border is set alike.</summary>
        internal readonly bool IsSame(in FluidBorder other)
            => kind == other.kind && width == other.width && velocity == other.velocity && level == other.level;

        /// <summary>Puts every value into its range.</summary>
        internal void Validate(string side, ref string problem)
        {
            Limit.Clamp($"width of the border {side}", ref width, 0f, MaxLength, Default.width, ref problem);
            Limit.Clamp($"velocity of the border {side}", ref velocity, -MaxVelocity, MaxVelocity, 0f, ref problem);
            Limit.Clamp($"level of the border {side}", ref level, 0f, MaxLength, Default.level, ref problem);
        }
    }
}
