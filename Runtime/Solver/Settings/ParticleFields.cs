using System;

namespace Rill
{
    /// <summary>Fields of each particle that a readback brings.</summary>
    [Flags]
    public enum ParticleFields
    {
        /// <summary>Position, world space, m.</summary>
        Positions = 1,
        /// <summary>Velocity against the box, world space, m/s.</summary>
        Velocities = 2,
        /// <summary>Number that stays with the particle.</summary>
        Ids = 4,
        /// <summary>Phase, 0 to 255; 0 where there are none.</summary>
        Phases = 8,
        /// <summary>All of these: 32 bytes for each particle of the capacity.</summary>
        All = Positions | Velocities | Ids | Phases,
    }
}
