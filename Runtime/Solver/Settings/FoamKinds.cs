using System;

namespace Rill
{
    /// <summary>Kinds of foam, one bit each.</summary>
    [Flags]
    public enum FoamKinds
    {
        /// <summary>Drops that fly through the air.</summary>
        Spray = 1,
        /// <summary>Foam that floats on the surface.</summary>
        Foam = 2,
        /// <summary>Bubbles that rise in the water.</summary>
        Bubbles = 4,
        /// <summary>All three.</summary>
        All = 7,
    }
}
