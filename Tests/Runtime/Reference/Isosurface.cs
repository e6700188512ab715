using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace Rill.Tests.Reference
{
    /// <summary>
    /// Surface of the water of raw particles, in double precision: the color field of Müller et al. (2003), with their poly6, at half of
    /// what it is in water at rest. The walls of the box mirror the particles. Has nothing in common with the smoothing of the surface. Lengths in d.
    /// </summary>
    sealed class Isosurface
    {
        public const double Level = 0.5;
        const double Step = 0.25;       // along a ray; thinner water is not found

        readonly double3 box;
        readonly int3 counts;
        readonly int[] first;           // of each cell in points
        readonly double3[] points;      // particles and images, by cell
        readonly bool[] isNear;         // of each cell: whether it or one beside it holds a point

        public Isosurface(double3[] particles, double3 box)
        {
            this.box = box;
            counts = (int3)math.ceil(box / Kernels.H) + 2;
            double3[] all = WithImages(particles).ToArray();
            int[] cells = all.Select(p => Index(CellOf(p))).ToArray();
            first = new int[counts.x * counts.y * counts.z + 1];
            foreach (int cell in cells)
                first[cell + 1]++;
            for (int cell = 0; cell < first.Length - 1; cell++)
                first[cell + 1] += first[cell];
            Array.Sort(cells, all);
            points = all;
            isNear = new bool[first.Length - 1];
            foreach (int cell in cells.Distinct())
                foreach (int near in Around(new int3(cell % counts.x, cell / counts.x % counts.y, cell / (counts.x * counts.y))))
                    isNear[near] = true;
        }

        /// <summary>Σ W / ρ0: 1 in water at rest, 0 far from it.</summary>
        public double Color(double3 at)
        {
            double sum = 0.0;
            int3 cell = CellOf(at);
            int3 low = math.max(cell - 1, 0), high = math.min(cell + 1, counts - 1);
            for (int z = low.z; z <= high.z; z++)
                for (int y = low.y; y <= high.y; y++)
                {
                    int row = (z * counts.y + y) * counts.x;
                    for (int i = first[row + low.x]; i < first[row + high.x + 1]; i++)
                    {
                        double3 away = points[i] - at;
                        double square = away.x * away.x + away.y * away.y + away.z * away.z;
                        if (square < Kernels.H * Kernels.H)
                            sum += Kernels.Poly6(Math.Sqrt(square));
                    }
                }
            return sum / Kernels.RestDensity;
        }

        /// <summary>The first point on a ray at which there is water.</summary>
        /// <param name="direction">Of any length.</param>
        /// <param name="distance">In lengths of the direction.</param>
        /// <param name="isOnWall">The water is met at a wall of the box.</param>
        public bool Hit(double3 origin, double3 direction, out double distance, out bool isOnWall)
        {
            isOnWall = false;
            double3 a = -origin / direction, b = (box - origin) / direction;
            double enter = Math.Max(math.cmax(math.min(a, b)), 0.0), leave = math.cmin(math.max(a, b)), step = Step / math.length(direction);
            for (distance = enter; distance < leave; distance += step)
            {
                if (!IsWater(origin + distance * direction))
                    continue;
                if (distance == enter)
                {
                    isOnWall = true;
                    return true;
                }
                double outside = distance - step;
                for (int i = 0; i < 20; i++)
                {
                    double mid = 0.5 * (outside + distance);
                    (outside, distance) = IsWater(origin + mid * direction) ? (outside, mid) : (mid, distance);
                }
                return true;
            }
            return false;
        }

        bool IsWater(double3 at) => isNear[Index(CellOf(at))] && Color(at) >= Level;

        IEnumerable<double3> WithImages(double3[] particles)
        {
            foreach (double3 p in particles)
                for (int image = 0; image < 27; image++)
                {
                    var digits = new int3(image % 3, image / 3 % 3, image / 9);
                    double3 mirrored = math.select(math.select(p, -p, digits == 1), 2.0 * box - p, digits == 2);
                    if (math.all(mirrored > -Kernels.H) && math.all(mirrored < box + Kernels.H))
                        yield return mirrored;
                }
        }

        // One cell around the box holds the images.
        int3 CellOf(double3 at) => math.clamp((int3)math.floor(at / Kernels.H) + 1, 0, counts - 1);

        int Index(int3 cell) => (cell.z * counts.y + cell.y) * counts.x + cell.x;

        IEnumerable<int> Around(int3 cell)
        {
            int3 low = math.max(cell - 1, 0), high = math.min(cell + 1, counts - 1);
            for (int z = low.z; z <= high.z; z++)
                for (int y = low.y; y <= high.y; y++)
                    for (int x = low.x; x <= high.x; x++)
                        yield return Index(new int3(x, y, z));
        }
    }
}
