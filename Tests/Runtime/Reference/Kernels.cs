using System;
using Unity.Mathematics;

namespace Rill.Tests.Reference
{
    /// <summary>The SPH kernels as Müller et al. (2003) print them, and their sums over the lattice at rest. Lengths in d.</summary>
    static class Kernels
    {
        /// <summary>Support radius.</summary>
        public const double H = 2.0;

        static readonly double Poly6Scale = 315.0 / (64.0 * Math.PI * Math.Pow(H, 9));
        static readonly double SpikyScale = 15.0 / (Math.PI * Math.Pow(H, 6));

        /// <summary>Eq. 20.</summary>
        public static double Poly6(double r) => r > H ? 0.0 : Poly6Scale * (H * H - r * r) * (H * H - r * r) * (H * H - r * r);

        /// <summary>Eq. 21.</summary>
        public static double Spiky(double r) => r > H ? 0.0 : SpikyScale * (H - r) * (H - r) * (H - r);

        public static double SpikyDerivative(double r) => r > H ? 0.0 : -3.0 * SpikyScale * (H - r) * (H - r);

        /// <summary>Gradient of the spiky kernel by the end of <paramref name="difference"/>; 0 where it has no direction.</summary>
        public static double3 SpikyGradient(double3 difference)
        {
            double r = math.length(difference);
            return r == 0.0 ? new double3(0.0) : difference * (SpikyDerivative(r) / r);
        }

        /// <summary>ρ0: poly6 summed over a cubic lattice of spacing 1.</summary>
        public static readonly double RestDensity = SumLattice(Poly6);

        /// <summary>Σ|∇C|² of a particle inside that lattice.</summary>
        public static readonly double RestSquares = SumLattice(r => r == 0.0 ? 0.0 : SpikyDerivative(r) * SpikyDerivative(r))
            / (RestDensity * RestDensity);

        static double SumLattice(Func<double, double> value)
        {
            double sum = 0.0;
            for (int z = -3; z <= 3; z++)
                for (int y = -3; y <= 3; y++)
                    for (int x = -3; x <= 3; x++)
                        sum += value(Math.Sqrt(x * x + y * y + z * z));
            return sum;
        }
    }
}
