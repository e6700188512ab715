using System;
using System.Linq;
using Unity.Mathematics;

namespace Rill.Tests.Reference
{
    /// <summary>The measures of <see cref="FluidStatistics"/> by their definitions, from positions and velocities in d.</summary>
    sealed class Measures
    {
        readonly double[] errors;               // C of each particle
        readonly bool[] interior;
        readonly double3[] points, velocities, deviations;
        readonly int[][] neighbors;
        readonly double3 box;

        public Measures(double3 box, double3[] points, double3[] velocities)
        {
            this.box = box;
            this.points = points;
            this.velocities = velocities;
            neighbors = Neighbors.ByCells(points, Kernels.H);
            var constraint = new Constraint(box, points, neighbors);
            errors = Enumerable.Range(0, points.Length).Select(i => constraint.Density(i) - 1.0).ToArray();
            double steepest = Math.Abs(Walls.PlaneSlope(0.0));
            interior = Enumerable.Range(0, points.Length).Select(i => math.length(constraint.Gradient(i)) < 0.35 * steepest
                && errors[i] > -0.15).ToArray();
            deviations = Enumerable.Range(0, points.Length).Where(i => neighbors[i].Length >= 12).Select(Deviation).ToArray();
        }

        public double DensityError => errors.Average(c => Math.Max(c, 0.0));
        public double DensityErrorMax => errors.Max(c => Math.Max(c, 0.0));

        /// <summary>The largest value that more than one in a thousand reach.</summary>
        public double DensityError999 => errors.Select(c => Math.Max(c, 0.0)).OrderByDescending(c => c).ElementAt(points.Length / 1000);

        public int InteriorCount => interior.Count(inside => inside);
        public double InteriorError => errors.Where((c, i) => interior[i]).Select(Math.Abs).DefaultIfEmpty(0.0).Average();

        public double Jitter => Math.Sqrt(deviations.Select(v => math.dot(v, v)).DefaultIfEmpty(0.0).Average());
        public double Speed => Math.Sqrt(velocities.Average(v => math.dot(v, v)));
        public double SpeedMax => velocities.Max(v => math.length(v));
        public double NeighborsMean => neighbors.Average(near => (double)near.Length);
        public int NeighborsMax => neighbors.Max(near => near.Length);

        public int Escaped => points.Count(p => math.any(p < 0.4) || math.any(p > box - 0.4));
        public int Coincident => Enumerable.Range(0, points.Length).Count(i => neighbors[i].Any(j => math.distance(points[i], points[j]) < 0.05));

        public double3 Momentum => Total(velocities);
        public double3 CenterOfMass => Total(points) / points.Length;
        public double3 Furthest => points.Aggregate(math.max);
        public double VolumeRatio => 2.0 * CenterOfMass.y * box.x * box.z / points.Length;

        double3 Deviation(int i) => velocities[i] - Total(neighbors[i].Select(j => velocities[j]).ToArray()) / neighbors[i].Length;

        static double3 Total(double3[] values) => values.Aggregate(new double3(0.0), (sum, value) => sum + value);
    }
}
