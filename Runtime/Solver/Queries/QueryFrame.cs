using System.Runtime.InteropServices;
using UnityEngine;

namespace Rill
{
    /// <summary>State of the fluid to which the results of a frame belong.</summary>
    [StructLayout(LayoutKind.Sequential, Pack = 4)]      // as it stands in snapshots
    struct QueryFrame
    {
        public int step;
        /// <summary>s</summary>
        public double time;
        /// <summary>From the box to world space.</summary>
        public Quaternion rotation;
        /// <summary>m</summary>
        public float spacing;
        /// <summary>At rest, kg/m³.</summary>
        public float density;
        /// <summary>Against gravity in world space, length 1; 0 without gravity.</summary>
        public Vector3 up;
        /// <summary>How far the fluid had been teleported since it started, m.</summary>
        public Vector3 shift;
    }
}
