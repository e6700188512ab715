using System;
using Unity.Mathematics;

namespace Rill.Tests.Reference
{
    /// <summary>
    /// The fluid behind the six walls of a box, by numerical quadrature of the kernels over a half space: knows nothing of
    /// the closed forms in the shaders. Lengths in d, density relative to rest.
    /// </summary>
    static class Walls
    {
        const int Steps = 4000;
        const double Width = Kernels.H / Steps;

        // By distance from the plane, in Steps intervals from 0 to H.
        static readonly double[] density = new double[Steps + 1];
        static readonly double[] slope = new double[Steps + 1];

        static Walls()
        {
            // Planes parallel to the wall at distance u, from the far end; a plane is rings, and rho d(rho) is r dr there.
            for (int plane = Steps - 1; plane >= 0; plane--)
            {
                double u = (plane + 0.5) * Width;
                density[plane] = density[plane + 1] + Width * 2.0 * Math.PI * Integrate(u, r => Kernels.Poly6(r) * r);
                slope[plane] = slope[plane + 1] + Width * 2.0 * Math.PI * Integrate(u, r => Kernels.SpikyDerivative(r) * (u / r) * r);
            }

            double scale = MissingBehindLattice() / At(density, 0.5);
            for (int i = 0; i <= Steps; i++)
            {
                density[i] *= scale;
                slope[i] *= scale;
            }
        }

        /// <summary>Fraction of the rest density that one wall at distance s adds.</summary>
        public static double PlaneDensity(double s) => At(density, s);

        /// <summary>Its spiky gradient along the wall's normal, 1/d: negative.</summary>
        public static double PlaneSlope(double s) => At(slope, s);

        /// <summary>Density that a box's walls add at p: 1 − Π(1 − F).</summary>
        public static double Density(double3 p, double3 box)
        {
            double free = 1.0;
            for (int axis = 0; axis < 3; axis++)
                free *= (1.0 - PlaneDensity(p[axis])) * (1.0 - PlaneDensity(box[axis] - p[axis]));
            return 1.0 - free;
        }

        /// <summary>Gradient of <see cref="Density"/> by the product rule.</summary>
        public static double3 Gradient(double3 p, double3 box)
        {
            double free = 1.0 - Density(p, box);
            double3 gradient = new double3(0.0);
            for (int axis = 0; axis < 3; axis++)
            {
                double above = box[axis] - p[axis];
                gradient[axis] += PlaneSlope(p[axis]) * free / (1.0 - PlaneDensity(p[axis]));
                gradient[axis] -= PlaneSlope(above) * free / (1.0 - PlaneDensity(above));
            }
            return gradient;
        }

        // Midpoint rule from u to H.
        static double Integrate(double u, Func<double, double> value)
        {
            const int samples = 200;
            double width = (Kernels.H - u) / samples;
            double sum = 0.0;
            for (int i = 0; i < samples; i++)
                sum += value(u + (i + 0.5) * width);
            return sum * width;
        }

        // Density that a lattice particle d/2 above a wall lacks.
        static double MissingBehindLattice()
        {
            double missing = 0.0;
            for (int z = -2; z <= 2; z++)
                for (int y = -2; y < 0; y++)
                    for (int x = -2; x <= 2; x++)
                        missing += Kernels.Poly6(Math.Sqrt(x * x + y * y + z * z));
            return missing / Kernels.RestDensity;
        }

        static double At(double[] table, double s)
        {
            double at = Math.Min(Math.Max(s / Width, 0.0), Steps);
            int i = Math.Min((int)at, Steps - 1);
            return table[i] + (table[i + 1] - table[i]) * (at - i);
        }
    }
}
