using System;
using Unity.Mathematics;

namespace Rill.Tests.Reference
{
    /// <summary>Surface tension of one pass, particle by particle in double precision; of walls by numerical quadrature over the half space behind
    /// them. Lengths in d.</summary>
    static class Tension
    {
        const int Steps = 2000;

        // Attraction of a plane by distance, in Steps intervals from 0 to H.
        static readonly double[] plane = new double[Steps + 1];

        static Tension()
        {
            // Rings of a plane at distance u add f(r) u/r over 2 pi r dr; planes lie beyond one another.
            const double Width = Kernels.H / Steps;
            for (int i = Steps - 1; i >= 0; i--)
            {
                double u = (i + 0.5) * Width;
                plane[i] = plane[i + 1] + Width * 2.0 * Math.PI * Integrate(u, r => Pair(r) * u);
            }
        }

        /// <summary>f(r) = r³ (1 − r/h)².</summary>
        public static double Pair(double r) => r >= Kernels.H ? 0.0 : r * r * r * (1.0 - r / Kernels.H) * (1.0 - r / Kernels.H);

        /// <summary>Attraction of the half space behind a plane at distance s.</summary>
        public static double Plane(double s)
        {
            double at = math.clamp(s / Kernels.H * Steps, 0.0, Steps);
            int i = Math.Min((int)at, Steps - 1);
            return plane[i] + (plane[i + 1] - plane[i]) * (at - i);
        }

        /// <summary>Displacement by the neighbors.</summary>
        public static double3 OfPairs(int i, double3[] points, int[][] neighbors, double strength, out double size)
        {
            var sum = new VectorSum();
            foreach (int j in neighbors[i])
            {
                double3 difference = points[i] - points[j];
                double distance = math.length(difference);
                if (distance > 0.0)
                    sum.Add(difference * (-strength * Pair(distance) / distance));
            }
            size = sum.size;
            return sum.value;
        }

        /// <summary>Displacement by the walls of a box, each as far as it does not lie behind another.</summary>
        public static double3 OfWalls(double3 p, double3 box, double strength)
        {
            double3 pull = default;
            for (int axis = 0; axis < 3; axis++)
            {
                double free = 1.0;
                for (int other = 0; other < 3; other++)
                    if (other != axis)
                        free *= (1.0 - Walls.PlaneDensity(p[other])) * (1.0 - Walls.PlaneDensity(box[other] - p[other]));
                pull[axis] = strength * free * (Plane(box[axis] - p[axis]) - Plane(p[axis]));
            }
            return pull;
        }

        // Midpoint rule from u to H.
        static double Integrate(double u, Func<double, double> value)
        {
            const int Samples = 200;
            double width = (Kernels.H - u) / Samples;
            double sum = 0.0;
            for (int i = 0; i < Samples; i++)
                sum += value(u + (i + 0.5) * width);
            return sum * width;
        }
    }
}
