using System;
using System.Linq;
using Unity.Mathematics;

namespace Rill.Tests.Reference
{
    /// <summary>One Jacobi pass of the density constraint (Macklin and Müller 2013, eq. 1-14), particle by particle in double precision.</summary>
    sealed class Constraint
    {
        /// <summary>ε as a fraction of Σ|∇C|² at rest.</summary>
        public double softness = 1e-3;
        public double allowedTension;
        public double relaxation = 1.0;
        /// <summary>k of s_corr as a density error, and |Δq| / h.</summary>
        public double artificialPressure, artificialPressureDistance = 0.2;
        public double maxCorrection = 0.5;
        /// <summary>Displacement by a pair whose f is 1, and by a wall, d: see <see cref="Tension"/>.</summary>
        public double pairAttraction, wallAttraction;

        /// <summary>Distance, d, within which a pair is pushed apart, and the fraction of what it lacks to it that a pass adds.</summary>
        const double Close = 0.25, Separation = 0.1;

        readonly double3 box;
        readonly double3[] points;
        readonly int[][] neighbors;

        /// <param name="box">Inner size of the walls, d.</param>
        public Constraint(double3 box, double3[] points, int[][] neighbors)
        {
            this.box = box;
            this.points = points;
            this.neighbors = neighbors;
        }

        /// <summary>ρ/ρ0, walls included.</summary>
        public double Density(int i)
        {
            double sum = Kernels.Poly6(0.0) + neighbors[i].Sum(j => Kernels.Poly6(math.distance(points[i], points[j])));
            return sum / Kernels.RestDensity + Walls.Density(points[i], box);
        }

        /// <summary>Gradient of C_i by the particle's own position.</summary>
        public double3 Gradient(int i)
        {
            double3 gradient = Walls.Gradient(points[i], box);
            foreach (int j in neighbors[i])
                gradient += Kernels.SpikyGradient(points[i] - points[j]) / Kernels.RestDensity;
            return gradient;
        }

        /// <summary>Eq. 11.</summary>
        public double Multiplier(int i) => -Math.Max(Density(i) - 1.0, -allowedTension) / Denominator(i);

        /// <summary>Error of the multiplier in single precision: an error of the density, and of the rest.</summary>
        public double MultiplierTolerance(int i, double fraction)
        {
            double density = Density(i);
            return fraction * (density + Math.Abs(density - 1.0)) / Denominator(i);
        }

        /// <summary>Eq. 12-14, relaxed and clamped, from multipliers as given.</summary>
        public double3 Correction(int i, double[] multipliers, out double size)
        {
            var sum = new VectorSum();
            foreach (int j in neighbors[i])
            {
                double3 difference = points[i] - points[j];
                double multiplier = multipliers[i] + multipliers[j] + ArtificialPressure(math.length(difference));
                sum.Add(Kernels.SpikyGradient(difference) * (multiplier / Kernels.RestDensity));
                double distance = math.length(difference);
                if (distance > 0.0 && distance < Close)
                    sum.Add(difference * (Separation * (Close - distance) / distance));
            }
            sum.Add(Walls.Gradient(points[i], box) * multipliers[i]);

            size = relaxation * sum.size;
            double3 correction = relaxation * sum.value;
            if (pairAttraction > 0.0)
            {
                correction += Tension.OfPairs(i, points, neighbors, pairAttraction, out double attracted)
                    + Tension.OfWalls(points[i], box, wallAttraction);
                size += attracted;
            }
            double length = math.length(correction);
            return length > maxCorrection ? correction * (maxCorrection / length) : correction;
        }

        /// <summary>The particle's place after the pass: no closer to a wall than d/2.</summary>
        public double3 Corrected(int i, double[] multipliers, out double size)
        {
            double3 moved = points[i] + Correction(i, multipliers, out size);
            return math.clamp(moved, new double3(0.5), box - 0.5);
        }

        double Denominator(int i)
        {
            double3 own = Gradient(i);
            double squares = math.dot(own, own);
            foreach (int j in neighbors[i])
            {
                double3 other = Kernels.SpikyGradient(points[i] - points[j]) / Kernels.RestDensity;
                squares += math.dot(other, other);
            }
            return squares + softness * Kernels.RestSquares;
        }

        double ArtificialPressure(double r)
        {
            if (artificialPressure == 0.0)
                return 0.0;
            double ratio = Kernels.Poly6(r) / Kernels.Poly6(artificialPressureDistance * Kernels.H);
            return -artificialPressure / Kernels.RestSquares * Math.Pow(ratio, 4);
        }
    }
}
