using System;
using System.Linq;
using Unity.Mathematics;

namespace Rill.Tests.Reference
{
    /// <summary>ImplicitViscosity.compute pair by pair in double precision, solved until nothing is left to solve. Lengths in d.</summary>
    sealed class Viscosity
    {
        readonly double3[] positions;
        readonly int[][] neighbors;
        readonly double[] coefficients;

        /// <param name="positions">In any order.</param>
        /// <param name="neighbors">Within the support radius.</param>
        public Viscosity(double3[] positions, int[][] neighbors)
        {
            this.positions = positions;
            this.neighbors = neighbors;
            coefficients = positions.Select((_, i) => 1.0 / Math.Max(Math.Max(Sum(i, 4) + Surface(i), 0.25 * OnLattice(4)),
                0.5 * OnLattice(4) / OnLattice(2) * Sum(i, 2))).ToArray();
        }

        /// <summary>Velocities v' of v' − s L v' = v.</summary>
        /// <param name="strength">s = ν Δt / d².</param>
        public double3[] Solve(double3[] velocities, double strength)
        {
            double3[] solution = velocities.ToArray(), residual = Without(velocities, solution, strength), direction = residual.ToArray();
            double squares = Squares(residual), first = squares;
            for (int pass = 0; pass < 1000 && squares > 1e-24 * Squares(velocities); pass++)
            {
                double3[] image = Apply(direction, strength);
                double step = squares / direction.Zip(image, math.dot).Sum();
                for (int i = 0; i < solution.Length; i++)
                {
                    solution[i] += step * direction[i];
                    residual[i] -= step * image[i];
                }
                double last = squares;
                squares = Squares(residual);
                for (int i = 0; i < solution.Length; i++)
                    direction[i] = residual[i] + squares / last * direction[i];
            }
            return solution;
        }

        /// <summary>v − s L v.</summary>
        public double3[] Apply(double3[] velocities, double strength)
        {
            var image = velocities.ToArray();
            for (int i = 0; i < positions.Length; i++)
                foreach (int j in neighbors[i])
                {
                    double3 difference = positions[i] - positions[j];
                    double weight = 15.0 * strength * (coefficients[i] + coefficients[j]) * Weight(math.length(difference));
                    image[i] -= weight * math.dot(velocities[j] - velocities[i], difference) * difference;
                }
            return image;
        }

        double3[] Without(double3[] velocities, double3[] solution, double strength)
            => Apply(solution, strength).Zip(velocities, (image, v) => v - image).ToArray();

        double Sum(int i, int power) => neighbors[i]
            .Sum(j => Weight(math.distance(positions[i], positions[j])) * Math.Pow(math.distance(positions[i], positions[j]), power));

        // So the outermost layer of the cubic lattice shears as the layers inside: its Σ w x²z² is 39/44 of theirs.
        double Surface(int i)
        {
            var lean = new double3(0.0);
            foreach (int j in neighbors[i])
            {
                double3 difference = positions[i] - positions[j];
                lean += Weight(math.length(difference)) * math.dot(difference, difference) * difference;
            }
            return 3.4374304163883367 * Math.Max(math.dot(lean, lean) / Math.Max(Sum(i, 2), 1e-6) - 0.008 * Sum(i, 4), 0.0);
        }

        static double Squares(double3[] vectors) => vectors.Sum(v => math.dot(v, v));

        // (4 − r²)² (4 − r² + 3/7), for which the cubic lattice's Σ w x⁴ = 3 Σ w x²y².
        static double Weight(double r)
        {
            double t = Math.Max(4.0 - r * r, 0.0);
            return t * t * (t + 3.0 / 7.0);
        }

        static double OnLattice(int power) => 6.0 * Weight(1.0) + 12.0 * Weight(Math.Sqrt(2.0)) * Math.Pow(2.0, power / 2.0)
            + 8.0 * Weight(Math.Sqrt(3.0)) * Math.Pow(3.0, power / 2.0);
    }
}
