using System;
using System.Collections.Generic;
using System.Linq;
using Rill;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Host.Report
{
    /// <summary>
    /// A dam breaks in a closed tank four times as long as the water is wide, and its wave runs to and fro: when the center of mass turns
    /// back at the far wall, at the near one and at the far one again.
    /// </summary>
    static class ReflectedWaves
    {
        /// <summary>Turns that are timed.</summary>
        public const int Turns = 3;
        /// <summary>Initial width of the water, m.</summary>
        public const double Width = 0.5;
        public const double Seconds = 5;
        const int Thickness = 8;            // d
        // A wave that breaks at a wall rocks the center of mass by less than that, its own turns are ten times as far apart.
        const double Ripple = 0.03, Window = 0.15;      // of its whole path; s
        const double Bar = 0.03;

        /// <summary>Returns the position of the water's center along the tank, m, over time, s.</summary>
        /// <param name="across">Particles across the water, which is twice as high.</param>
        /// <param name="seed">Of the offsets at the start; not 0.</param>
        public static List<(double Time, double Value)> Run(int across, uint seed, in StepInput input)
        {
            var random = new Random(seed);
            var positions = new List<float3>();
            FluidRun.AddBlock(positions, 0f, new int3(across, 2 * across, Thickness), ref random);
            using var run = new FluidRun("reflected waves", new float3(4 * across, 3 * across, Thickness), (float)(Width / across),
                positions, _ => 0f, input);
            var samples = new List<(double, double)>();
            while (run.Time < Seconds)
            {
                run.Step();
                samples.Add((run.Time, run.Measure().centerOfMass.x));
            }
            return samples;
        }

        /// <summary>Times of the turns, s; NaN for those that water which has come to rest no longer makes.</summary>
        public static double[] Arrivals(IReadOnlyList<(double Time, double Value)> samples) =>
            TurningPoints.Of(samples, Ripple, Window).Concat(Enumerable.Repeat(double.NaN, Turns)).Take(Turns).ToArray();

        /// <summary>How far times of a wave may be from those of the finest run, as a fraction of their mean: 3 %, or two standard
        /// deviations if that is more.</summary>
        public static double Allowed(IReadOnlyCollection<double> finest) => Math.Max(Bar, 2 * Deviation(finest) / finest.Average());

        /// <summary>Standard deviation of a sample; 0 of a single value.</summary>
        public static double Deviation(IReadOnlyCollection<double> values)
        {
            double mean = values.Average();
            return values.Count < 2 ? 0 : Math.Sqrt(values.Sum(v => (v - mean) * (v - mean)) / (values.Count - 1));
        }
    }
}
