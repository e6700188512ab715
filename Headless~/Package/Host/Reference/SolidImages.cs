using System;
using System.Collections.Generic;
using System.Threading.Tasks;
using Unity.Mathematics;

namespace Host.Reference
{
    /// <summary>Mirrors particles in the solids that they touch, so that the water's mesh reaches into those: a gap of air between water and a floor
    /// would bend light back, and the water would look empty.</summary>
    sealed class SolidImages
    {
        readonly double reach;
        readonly List<(double3 Low, double3 High, double3[] Corners)> solids = new();

        /// <param name="reach">Of a particle's center from a solid that it touches.</param>
        public SolidImages(double reach) => this.reach = reach;

        /// <param name="corners">Three of each triangle.</param>
        public void Add(double3[] corners)
        {
            double3 low = double.PositiveInfinity, high = double.NegativeInfinity;
            foreach (double3 corner in corners)
                (low, high) = (math.min(low, corner), math.max(high, corner));
            solids.Add((low - reach, high + reach, corners));
        }

        public List<double3> Of(double3[] particles)
        {
            var found = new List<double3>[particles.Length];
            Parallel.For(0, particles.Length, i =>
            {
                double3 at = particles[i];
                foreach (var (low, high, corners) in solids)
                {
                    if (math.any(at < low) || math.any(at > high))
                        continue;
                    double best = reach * reach;
                    double3? nearest = null;
                    for (int corner = 0; corner < corners.Length; corner += 3)
                    {
                        double3 point = Nearest(at, corners[corner], corners[corner + 1], corners[corner + 2]);
                        double square = math.lengthsq(point - at);
                        if (square < best)
                            (best, nearest) = (square, point);
                    }
                    if (nearest is double3 contact)
                        (found[i] ??= new List<double3>()).Add(2.0 * contact - at);
                }
            });
            var images = new List<double3>();
            foreach (List<double3> of in found)
                if (of != null)
                    images.AddRange(of);
            return images;
        }

        /// <summary>The nearest point of a triangle (Ericson 2005, Real-Time Collision Detection, 5.1.5).</summary>
        internal static double3 Nearest(double3 p, double3 a, double3 b, double3 c)
        {
            double3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
            double d1 = math.dot(ab, ap), d2 = math.dot(ac, ap), d3 = math.dot(ab, bp), d4 = math.dot(ac, bp);
            double d5 = math.dot(ab, cp), d6 = math.dot(ac, cp);
            if (d1 <= 0 && d2 <= 0)
                return a;
            if (d3 >= 0 && d4 <= d3)
                return b;
            if (d6 >= 0 && d5 <= d6)
                return c;
            double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
            if (vc <= 0 && d1 >= 0 && d3 <= 0)
                return a + d1 / (d1 - d3) * ab;
            if (vb <= 0 && d2 >= 0 && d6 <= 0)
                return a + d2 / (d2 - d6) * ac;
            if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
                return b + (d4 - d3) / (d4 - d3 + d5 - d6) * (c - b);
            return a + (vb * ab + vc * ac) / (va + vb + vc);
        }
    }
}
