using System;
using Unity.Mathematics;

namespace Rill.Tests.Reference
{
    /// <summary>The potentials of foam (after Ihmsen et al. 2012) in double precision. Lengths in d.</summary>
    sealed class FoamPotentials
    {
        public const double SurfaceNormal = 0.1, Outwards = 0.6;

        // Sums over a cubic lattice with spacing 1.
        static readonly double LatticeWeights = LatticeSum(r => 1.0), LatticeStrain = LatticeSum(r => r);

        readonly double3 box;
        readonly double3[] points, velocities;
        readonly int[][] neighbors;

        public FoamPotentials(double3 box, double3[] points, double3[] velocities, int[][] neighbors)
        {
            this.box = box;
            this.points = points;
            this.velocities = velocities;
            this.neighbors = neighbors;
        }

        /// <summary>0 to 1, of the square of the speed between two limits.</summary>
        public double Kinetic(int i, double low, double high) => Ramp(math.lengthsq(velocities[i]), low * low, high * high);

        /// <summary>How fast the fluid around a particle is sheared and pressed together, 1/s.</summary>
        public double Strain(int i)
        {
            double sum = 0.0;
            foreach (int j in neighbors[i])
            {
                double3 difference = points[i] - points[j], relative = velocities[i] - velocities[j];
                double distance = math.length(difference), speed = math.length(relative);
                double cosine = distance > 0.0 && speed > 0.0 ? math.dot(relative, difference) / (speed * distance) : 0.0;
                sum += Weight(distance) * speed * (1.0 - cosine);
            }
            return sum / LatticeStrain;
        }

        /// <summary>Unit vector out of the fluid; 0 away from its surface.</summary>
        public double3 Normal(int i)
        {
            double3 sum = 0.0;
            foreach (int j in neighbors[i])
            {
                double3 difference = points[i] - points[j];
                double distance = math.length(difference);
                if (distance > 0.0)
                    sum += difference * (Weight(distance) / distance);
            }
            for (int axis = 0; axis < 3; axis++)
            {
                if (points[i][axis] < Kernels.H)
                    sum[axis] = Math.Max(sum[axis], 0.0);
                if (points[i][axis] > box[axis] - Kernels.H)
                    sum[axis] = Math.Min(sum[axis], 0.0);
            }
            Asymmetry = math.length(sum) / LatticeWeights;
            return Asymmetry > SurfaceNormal ? math.normalize(sum) : new double3(0.0);
        }

        /// <summary>Degree to which the particle of the last <see cref="Normal"/> lies at the surface.</summary>
        public double Asymmetry { get; private set; }

        public bool FliesOut(int i, double3 normal) => math.dot(normal, velocities[i]) > Outwards * math.length(velocities[i]);

        /// <summary>Mean of 1 - cosine between the normals of a particle and of those at the surface beyond it.</summary>
        public double Bend(int i, double3[] normals)
        {
            double sum = 0.0, weights = 0.0;
            foreach (int j in neighbors[i])
            {
                double3 difference = points[i] - points[j];
                if (math.lengthsq(normals[j]) == 0.0 || math.dot(difference, normals[i]) <= 0.0)
                    continue;
                sum += Weight(math.length(difference)) * (1.0 - math.dot(normals[i], normals[j]));
                weights += Weight(math.length(difference));
            }
            return weights > 0.0 ? sum / weights : 0.0;
        }

        public static double Ramp(double value, double low, double high) => Math.Min(Math.Max((value - low) / (high - low), 0.0), 1.0);

        static double Weight(double distance) => Math.Max(1.0 - distance / Kernels.H, 0.0);

        static double LatticeSum(Func<double, double> value)
        {
            double sum = 0.0;
            for (int z = -2; z <= 2; z++)
                for (int y = -2; y <= 2; y++)
                    for (int x = -2; x <= 2; x++)
                    {
                        double distance = Math.Sqrt(x * x + y * y + z * z);
                        if (distance > 0.0)
                            sum += value(distance) * Weight(distance);
                    }
            return sum;
        }
    }
}
