using System;
using Unity.Mathematics;
using static System.FormattableString;

namespace Rill
{
    /// <summary>The particles of a fluid at one moment, as arrays of the same length: what <see cref="ParticleFile"/> writes.</summary>
    public sealed class ParticleFrame
    {
        /// <summary>World space, m.</summary>
        public readonly float3[] Positions;

        /// <summary>World space, m/s.</summary>
        public readonly float3[] Velocities;

        /// <summary>kg/m³.</summary>
        public readonly float[] Densities;

        /// <summary>0 to 255; 0 for none.</summary>
        public readonly byte[] Phases;

        /// <summary>A particle keeps its id for as long as it lives.</summary>
        public readonly uint[] Ids;

        /// <summary>Fluid time, s.</summary>
        public readonly double Time;

        /// <param name="positions">World space, m.</param>
        /// <param name="velocities">World space, m/s.</param>
        /// <param name="densities">kg/m³.</param>
        /// <param name="phases">0 for none.</param>
        /// <param name="ids">Ids of the particles.</param>
        /// <param name="time">Fluid time, s.</param>
        /// <exception cref="ArgumentNullException">An array is missing.</exception>
        /// <exception cref="ArgumentException">They differ in length.</exception>
        public ParticleFrame(float3[] positions, float3[] velocities, float[] densities, byte[] phases, uint[] ids, double time)
        {
            Positions = positions ?? throw new ArgumentNullException(nameof(positions));
            Velocities = velocities ?? throw new ArgumentNullException(nameof(velocities));
            Densities = densities ?? throw new ArgumentNullException(nameof(densities));
            Phases = phases ?? throw new ArgumentNullException(nameof(phases));
            Ids = ids ?? throw new ArgumentNullException(nameof(ids));
            Time = time;
            int count = positions.Length;
            if (velocities.Length != count || densities.Length != count || phases.Length != count || ids.Length != count)
                throw new ArgumentException(Invariant($"{count:N0} positions with {velocities.Length:N0} velocities, ") +
                    Invariant($"{densities.Length:N0} densities, {phases.Length:N0} phases and {ids.Length:N0} ids: give each particle ") +
                    "all of them.");
        }

        /// <summary>Number of particles.</summary>
        public int Count => Positions.Length;
    }
}
