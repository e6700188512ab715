using System;

namespace Rill
{
    /// <summary>Walls of a fluid's box, in the frame of the object.</summary>
    [Flags]
    public enum BoxWalls
    {
        /// <summary>None of the walls.</summary>
        None = 0,
        /// <summary>The wall at the low end of x.</summary>
        Left = 1,
        /// <summary>The wall at the high end of x.</summary>
        Right = 2,
        /// <summary>The wall at the low end of y.</summary>
        Bottom = 4,
        /// <summary>The wall at the high end of y.</summary>
        Top = 8,
        /// <summary>The wall at the low end of z.</summary>
        Back = 16,
        /// <summary>The wall at the high end of z.</summary>
        Front = 32,
        /// <summary>All six walls.</summary>
        All = 63,
    }
}
