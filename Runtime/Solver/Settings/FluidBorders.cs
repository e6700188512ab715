using System;
using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>The four sides of a fluid's box. Floor and lid are walls.</summary>
    [Serializable]
    public struct FluidBorders
    {
        internal const int Sides = 4;

        /// <summary>Narrowest band, d: a cell of the coarse grid.</summary>
        internal const float MinWidth = 4f;

        /// <summary>The side at the lower end of the box along its x axis.</summary>
        [Tooltip("The side at the lower end of the box along its x axis.")]
        public FluidBorder minX;

        /// <summary>The side at the upper end along x.</summary>
        [Tooltip("The side at the upper end along x.")]
        public FluidBorder maxX;

        /// <summary>The side at the lower end along z.</summary>
        [Tooltip("The side at the lower end along z.")]
        public FluidBorder minZ;

        /// <summary>The side at the upper end along z.</summary>
        [Tooltip("The side at the upper end along z.")]
        public FluidBorder maxZ;

        /// <summary>Four walls.</summary>
        public static FluidBorders Default => new FluidBorders
        {
            minX = FluidBorder.Default, maxX = FluidBorder.Default, minZ = FluidBorder.Default, maxZ = FluidBorder.Default
        };

        /// <summary>The sides in the order of the solver: -X, +X, -Z, +Z.</summary>
        internal FluidBorder this[int side]
        {
            readonly get
            {
                switch (side)
                {
                    case 0: return minX;
                    case 1: return maxX;
                    case 2: return minZ;
                    default: return maxZ;
                }
            }
            set
            {
                switch (side)
                {
                    case 0: minX = value; break;
                    case 1: maxX = value; break;
                    case 2: minZ = value; break;
                    default: maxZ = value; break;
                }
            }
        }

        /// <summary>Whether a side is not a wall.</summary>
        internal readonly bool HasBands => HasAny(BorderKind.Absorbing) || HasOpen;

        /// <summary>Whether a side is open.</summary>
        internal readonly bool HasOpen => HasAny(BorderKind.Open);

        /// <summary>Puts every value into its range; what the box and the spacing ask for besides is left.</summary>
        /// <param name="problem">What was wrong and what it became; null if nothing was.</param>
        /// <returns>Whether the borders were valid as they stood.</returns>
        public bool Validate(out string problem)
        {
            problem = null;
            minX.Validate(NameOf(0), ref problem);
            maxX.Validate(NameOf(1), ref problem);
            minZ.Validate(NameOf(2), ref problem);
            maxZ.Validate(NameOf(3), ref problem);
            return problem == null;
        }

        /// <summary>Returns the borders with bands and levels that a box has room for.</summary>
        /// <param name="box">m.</param>
        /// <param name="spacing">m.</param>
        internal readonly FluidBorders In(float3 box, float spacing)
        {
            FluidBorders fitted = this;
            for (int side = 0; side < Sides; side++)
            {
                FluidBorder border = this[side];
                border.width = math.max(border.width, MinWidth * spacing) * Shrink(side, box, spacing);
                border.level = math.min(border.level, box.y);
                fitted[side] = border;
            }
            return fitted;
        }

        /// <summary>Whether a band or a level has to be another in a box.</summary>
        /// <param name="box">m.</param>
        /// <param name="spacing">m.</param>
        internal readonly bool DifferIn(float3 box, float spacing)
        {
            FluidBorders fitted = In(box, spacing);
            for (int side = 0; side < Sides; side++)
                if (this[side].kind != BorderKind.Wall && (fitted[side].width != this[side].width || LevelDiffers(side, fitted)))
                    return true;
            return false;
        }

        readonly bool LevelDiffers(int side, in FluidBorders fitted)
            => this[side].kind == BorderKind.Open && fitted[side].level != this[side].level;

        /// <summary>Why the borders act otherwise than they are set; null where they do not.</summary>
        /// <param name="box">m.</param>
        /// <param name="spacing">m.</param>
        internal readonly string ProblemIn(float3 box, float spacing)
        {
            string problem = null;
            FluidBorders fitted = In(box, spacing);
            for (int side = 0; side < Sides; side++)
            {
                FluidBorder border = this[side];
                if (border.kind == BorderKind.Wall)
                    continue;
                string name = NameOf(side);
                if (border.width < MinWidth * spacing)
                    Limit.Append(ref problem, Invariant($"its border {name} has a band {border.width:0.###} m wide, and it takes {MinWidth} ") +
                        Invariant($"particle spacings: {MinWidth * spacing:0.###} m are used. Widen it or lower the spacing."));
                else if (fitted[side].width < border.width)
                    Limit.Append(ref problem, Invariant($"its border {name} has a band {border.width:0.###} m wide, and the bands on this axis ") +
                        Invariant($"have {box[AxisOf(side)]:0.###} m of the box together: {fitted[side].width:0.###} m are used. Narrow it or ") +
                        "enlarge the box.");
                if (border.kind == BorderKind.Open && border.level > box.y)
                    Limit.Append(ref problem, Invariant($"its border {name} holds a level of {border.level:0.###} m, and the box is ") +
                        Invariant($"{box.y:0.###} m high: that is used. Lower the level or enlarge the box."));
            }
            return problem;
        }

        /// <summary>Velocity through a side along its axis, m/s.</summary>
        internal readonly float VelocityAt(int side) => IsUpper(side) ? -this[side].velocity : this[side].velocity;

        internal static int AxisOf(int side) => side < 2 ? 0 : 2;

        internal static bool IsUpper(int side) => (side & 1) != 0;

        internal static string NameOf(int side) => (IsUpper(side) ? "+" : "-") + (AxisOf(side) == 0 ? "X" : "Z");

        readonly bool HasAny(BorderKind kind) => minX.kind == kind || maxX.kind == kind || minZ.kind == kind || maxZ.kind == kind;

        // Factor by which the two bands of an axis are narrowed to fit the box.
        readonly float Shrink(int side, float3 box, float spacing)
            => math.min(1f, box[AxisOf(side)] / math.max(WidthOf(side, spacing) + WidthOf(side ^ 1, spacing), spacing));

        readonly float WidthOf(int side, float spacing)
            => this[side].kind == BorderKind.Wall ? 0f : math.max(this[side].width, MinWidth * spacing);
    }
}
