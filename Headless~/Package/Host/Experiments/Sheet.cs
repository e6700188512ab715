using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace Host.Experiments
{
    /// <summary>
    /// Water that covers a floor in a few layers, column by column of about 4 spacings: a mean height over the whole floor counts
    /// waves as volume.
    /// </summary>
    sealed class Sheet
    {
        const float Side = 4f;              // of a column, d
        const float FewestLayers = 0.75f;   // of a column whose thickness means something
        const float Above = 0.75f;          // d above its column's layers where a particle is high

        /// <summary>Twice the mean height over the layers of each column, mean over the particles: 1 for a lattice at rest.</summary>
        public readonly double LocalVolume;
        /// <summary>Fraction of the particles that are more than 0.75 d above what the particles of their column would fill.</summary>
        public readonly double High;
        /// <summary>Standard deviation of the columns' layers.</summary>
        public readonly double Unevenness;

        /// <param name="positions">d.</param>
        /// <param name="floor">x and z, d.</param>
        public Sheet(IEnumerable<float3> positions, float2 floor)
        {
            int2 counts = math.max((int2)math.round(floor / Side), 1);
            float area = floor.x * floor.y / (counts.x * counts.y);
            var heights = new List<float>[counts.x * counts.y];
            for (int i = 0; i < heights.Length; i++)
                heights[i] = new List<float>();
            foreach (float3 p in positions)
            {
                int2 column = math.clamp((int2)(p.xz / floor * counts), 0, counts - 1);
                heights[column.y * counts.x + column.x].Add(p.y);
            }

            int particles = 0, measured = 0, high = 0;
            double volume = 0, mean = 0, squares = 0;
            foreach (List<float> column in heights)
            {
                float layers = column.Count / area;
                particles += column.Count;
                high += column.Count(y => y > Math.Max(layers, 1f) + Above);
                mean += layers / heights.Length;
                squares += layers * (double)layers / heights.Length;
                if (layers < FewestLayers)
                    continue;
                measured += column.Count;
                volume += 2.0 * column.Sum(y => (double)y) / layers;
            }
            LocalVolume = volume / Math.Max(measured, 1);
            High = high / (double)Math.Max(particles, 1);
            Unevenness = Math.Sqrt(Math.Max(squares - mean * mean, 0));
        }
    }
}
