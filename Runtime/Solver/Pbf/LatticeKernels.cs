using System;

namespace Rill
{
    /// <summary>
    /// Sums of the SPH kernels (Müller et al. 2003: poly6 eq. 20, spiky eq. 21) on a cubic lattice of the particle
    /// spacing: the rest state from which every solver constant is derived, so that none is typed in.
    /// </summary>
    /// <remarks>Lengths in particle spacings d; the support radius h is 2 d. Evaluated once, in double precision.</remarks>
    static class LatticeKernels
    {
        /// <summary>support radius h, d</summary>
        [GenerateHlsl("Solver")] public const double Support = 2.0;

        /// <summary>poly6 normalization 315 / (64 π h⁹).</summary>
        public static readonly double Poly6Scale = 315.0 / (64.0 * Math.PI * Math.Pow(Support, 9));

        /// <summary>Normalization of the spiky kernel's gradient, −45 / (π h⁶).</summary>
        public static readonly double SpikyGradientScale = -45.0 / (Math.PI * Math.Pow(Support, 6));

        /// <summary>Rest density ρ0: poly6 summed over the lattice, a particle's own contribution included.</summary>
        public static readonly double RestDensity = SumLattice(Poly6, includeSelf: true);

        /// <summary>Σ|∇C|² of a particle inside the lattice, 1/d²: scale of the constraint's denominator.</summary>
        public static readonly double ReferenceSquares = SumLattice(r => SpikySlope(r) * SpikySlope(r), includeSelf: false)
            / (RestDensity * RestDensity);

        /// <summary>Σ W x² / ρ0 over the lattice, d²: how far along an axis a kernel's average reaches.</summary>
        public static readonly double Poly6Spread = SumLattice(r => Poly6(r) * r * r / 3.0, includeSelf: false) / RestDensity;

        /// <summary>Σ w over Σ w x² of the weights w of Viscoelasticity.compute on the lattice, 1/d².</summary>
        public static readonly double StressMultiplier = SumLattice(StressWeight, includeSelf: false)
            / SumLattice(r => StressWeight(r) * r * r / 3.0, includeSelf: false);

        /// <summary>Σ w_i x_i⁴ = 3 Σ w x²y² on the lattice with the weights of ImplicitViscosity.compute: what the fraction of t² has to be
        /// for it, d².</summary>
        /// <remarks>So that the lattice resists as fluid without order does, the same in every direction.</remarks>
        public static readonly double ViscosityBlend = SumAnisotropy(3) / -SumAnisotropy(2);

        /// <summary>Σ w r⁴ over the lattice, w being the pairs' weights in ImplicitViscosity.compute.</summary>
        public static readonly double ViscosityMoment = SumLattice(r => ViscosityWeight(r) * r * r * r * r, includeSelf: false);

        /// <summary>Σ w r² of the same.</summary>
        public static readonly double ViscositySquares = SumLattice(r => ViscosityWeight(r) * r * r, includeSelf: false);

        /// <summary>By which Σ w (v_ji · x_ji) x_ji / Σ w r⁴ is the Laplacian of a flow that keeps its volume: x²y² is r⁴/15 on average,
        /// and a curve is half its second derivative.</summary>
        public const double ViscosityScale = 30.0;

        /// <summary>An upper bound of the largest eigenvalue of that Laplacian on the lattice, 1/d²: twice what a particle's neighbors
        /// brake it by.</summary>
        public static readonly double ViscosityEigenvalue = 2.0 * ViscosityScale * ViscositySquares / (3.0 * ViscosityMoment);

        /// <summary>By which <see cref="ViscosityWallShape"/> over the distance is the hold of a wall without slip, so that the layers of
        /// the lattice are together held by ν times the shear; 1/d² of Δt ν.</summary>
        public static readonly double ViscosityWallHold = 1.0 / (ViscosityWallShape(0.5) + ViscosityWallShape(1.5));

        /// <summary>Factor that turns it into the part of Σ w r⁴ that a lattice particle half a spacing from a wall misses.</summary>
        public static readonly double ViscosityWallMoment = MissingBehindWall((y, r) => ViscosityWeight(r) * r * r * r * r) / ViscosityWallShape(0.5);

        /// <summary>Factor that turns it into the missing part of Σ w r².</summary>
        public static readonly double ViscosityWallSquares = MissingBehindWall((y, r) => ViscosityWeight(r) * r * r) / ViscosityWallShape(0.5);

        /// <summary>Factor that turns it into the missing part of |Σ w r² x|.</summary>
        public static readonly double ViscosityWallLean = MissingBehindWall((y, r) => -ViscosityWeight(r) * r * r * y) / ViscosityWallShape(0.5);

        /// <summary>
        /// Amount that a free surface adds to Σ w r⁴ of a particle, over |Σ w r² x|² / Σ w r² above that of disorder. It gives
        /// the outermost layer of the lattice the Σ w x²z² of flow along the surface that it has inside, half of the lattice's own
        /// and half of its plane's.
        /// </summary>
        public static readonly double ViscositySurface = SurfaceMoment();

        /// <summary>|Σ w r² x|² / Σ w r² over Σ w r⁴ that disorder inside the fluid may have without being a surface; the lattice's surface
        /// has 0.094.</summary>
        public const double ViscosityDisorder = 0.008;

        /// <summary>Makes a lattice particle half a spacing from a wall see the rest density.</summary>
        public static readonly double WallScale = MissingBehindWall((y, r) => Poly6(r)) / RestDensity / HalfSpaceDensity(0.5);

        /// <summary>poly6 W(r), 1/d³.</summary>
        public static double Poly6(double r) => r < Support ? Poly6Scale * Math.Pow(Support * Support - r * r, 3) : 0.0;

        /// <summary>dW/dr of the spiky kernel, 1/d⁴, ≤ 0.</summary>
        public static double SpikySlope(double r) => r < Support ? SpikyGradientScale * (Support - r) * (Support - r) : 0.0;

        /// <summary>Weight of a pair for the gradients of Viscoelasticity.compute, d⁴.</summary>
        public static double StressWeight(double r) => r < Support ? (Support * Support - r * r) * (Support * Support - r * r) : 0.0;

        /// <summary>Weight of a pair in ImplicitViscosity.compute, d⁶.</summary>
        public static double ViscosityWeight(double r)
        {
            double t = Math.Max(Support * Support - r * r, 0.0);
            return t * t * (t + ViscosityBlend);
        }

        /// <summary>Σ w x² y of the viscosity's pairs over the half space y &gt; <paramref name="s"/>, but for its factor π/480; see
        /// ViscosityWalls.hlsl.</summary>
        public static double ViscosityWallShape(double s)
        {
            double a = Math.Max(Support * Support - s * s, 0.0);
            return Math.Pow(a, 5) * (a + 2.0 * ViscosityBlend);
        }

        /// <summary>poly6 integrated over the half space beyond distance <paramref name="s"/>: 1/2 at s = 0, 0 at s ≥ h.</summary>
        public static double HalfSpaceDensity(double s)
        {
            double x = Math.Min(Math.Max(s / Support, 0.0), 1.0);
            double y = x * x;
            return 0.5 - 315.0 / 256.0 * x * (1.0 + y * (-4.0 / 3.0 + y * (6.0 / 5.0 + y * (-4.0 / 7.0 + y / 9.0))));
        }

        // Returns what the layers below a lattice particle contribute.
        static double MissingBehindWall(Func<double, double, double> value)
        {
            double missing = 0.0;
            ForLattice((x, y, z, r) =>
            {
                if (y < 0)
                    missing += value(y, r);
            });
            return missing;
        }

        static double SurfaceMoment()
        {
            double along = 0.0, alongInside = 0.0;
            ForLattice((x, y, z, r) =>
            {
                double shear = ViscosityWeight(r) * x * x * z * z;
                alongInside += shear;
                along += y >= 0 ? shear : 0.0;
            });
            double moment = ViscosityMoment - MissingBehindWall((y, r) => ViscosityWeight(r) * r * r * r * r);
            double squares = ViscositySquares - MissingBehindWall((y, r) => ViscosityWeight(r) * r * r);
            double lean = MissingBehindWall((y, r) => -ViscosityWeight(r) * r * r * y);
            return (along / alongInside * ViscosityMoment - moment) / (lean * lean / squares - ViscosityDisorder * moment);
        }

        // Σ w (x⁴ - 3 x²y²) with w = (h² - r²)^power.
        static double SumAnisotropy(int power)
        {
            double sum = 0.0;
            ForLattice((x, y, z, r) => sum += Math.Pow(Math.Max(Support * Support - r * r, 0.0), power) * (x * x * x * x - 3 * x * x * y * y));
            return sum;
        }

        static double SumLattice(Func<double, double> value, bool includeSelf)
        {
            double sum = 0.0;
            ForLattice((x, y, z, r) =>
            {
                if (includeSelf || r > 0.0)
                    sum += value(r);
            });
            return sum;
        }

        static void ForLattice(Action<int, int, int, double> visit)
        {
            int reach = (int)Math.Ceiling(Support);
            for (int z = -reach; z <= reach; z++)
                for (int y = -reach; y <= reach; y++)
                    for (int x = -reach; x <= reach; x++)
                        visit(x, y, z, Math.Sqrt(x * x + y * y + z * z));
        }
    }
}
