using System;

namespace Rill
{
    /// <summary>Fields of each particle that a recording holds besides its position.</summary>
    [Flags]
    public enum RecordingFields
    {
        /// <summary>Positions alone: 6 bytes a particle, 8 in a box of more than 1,024 spacings.</summary>
        None = 0,
        /// <summary>Velocities, 6 bytes a particle: playback then moves between frames, and colors show the speed.</summary>
        Velocities = 1,
        /// <summary>Phases, 1 byte a particle: what emitters give for a look of their own.</summary>
        Phases = 2,
        /// <summary>Ids, 4 bytes a particle: what follows single particles over frames needs them, as the surface does to move smoothly.</summary>
        Ids = 4,
        /// <summary>All of these: 17 bytes a particle, 19 in a box of more than 1,024 spacings.</summary>
        All = Velocities | Phases | Ids,
    }
}
