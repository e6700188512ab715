using System.Runtime.InteropServices;
using UnityEngine;

namespace Rill
{
    /// <summary>The part of a collider's surface that water touches. World space.</summary>
    [StructLayout(LayoutKind.Sequential, Pack = 4)]      // as it stands in snapshots
    readonly struct WettedArea
    {
        /// <summary>Length of the mean normal from which it is a direction: below it the water is all around.</summary>
        public const double MinFacing = 0.05;

        /// <summary>Wet area, m²; 0 if nothing is wet, or it is not measured.</summary>
        public readonly float Area;
        /// <summary>Center of the wet area, m.</summary>
        public readonly Vector3 Point;
        /// <summary>Mean of its normals, into the water, length 1; 0 where the water is all around.</summary>
        public readonly Vector3 Normal;

        public WettedArea(float area, Vector3 point, Vector3 normal)
        {
            Area = area;
            Point = point;
            Normal = normal;
        }

        /// <summary>Returns the same position and normal without water.</summary>
        public WettedArea Dry => new WettedArea(0f, Point, Normal);
    }
}
