using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace Rill.Tests.Reference
{
    /// <summary>
    /// The coarse grid of the two-level correction in double precision: what lies in its cells, the equation for the
    /// potential on them and what its gradient does. Lengths in d.
    /// </summary>
    sealed class CoarseCells
    {
        public const double Screening = 1.0 / (300.0 * 300.0);

        public readonly int3 counts;
        public readonly double3 size;
        /// <summary>Particles per volume relative to rest; a cell that has less than two layers of them across it is not active.</summary>
        public readonly double[] fill;
        public readonly bool[] active;
        /// <summary>Fill at the free surface: of particles weighted by how near the cell's center is, once it was known there.</summary>
        public readonly double[] water;

        public CoarseCells(double3 box, int3 counts)
        {
            this.counts = counts;
            size = box / counts;
            fill = new double[Total];
            active = new bool[Total];
            water = new double[Total];
        }

        public int Total => counts.x * counts.y * counts.z;

        public double Volume => size.x * size.y * size.z;

        /// <summary>Particles of the outermost layer in an active cell: a d² of face towards a cell without a whole layer holds one, less
        /// what lies beyond.</summary>
        public double SurfaceLayer(int cell)
        {
            double particles = 0.0;
            for (int axis = 0; axis < 3; axis++)
                foreach (bool up in new[] { false, true })
                {
                    int beyond = Beside(cell, axis, up);
                    if (beyond >= 0 && !active[beyond])
                        particles += Volume / size[axis] * Math.Max(1.0 - fill[beyond] * size[axis], 0.0);
                }
            return particles;
        }

        public int3 Coordinates(int cell) => new int3(cell % counts.x, cell / counts.x % counts.y, cell / (counts.x * counts.y));

        public int Index(int3 coordinates) => (coordinates.z * counts.y + coordinates.y) * counts.x + coordinates.x;

        public int CellOf(double3 p)
        {
            int3 coordinates = default;
            for (int axis = 0; axis < 3; axis++)
                coordinates[axis] = Math.Min(Math.Max((int)Math.Floor(p[axis] / size[axis]), 0), counts[axis] - 1);
            return Index(coordinates);
        }

        /// <summary>The next cell along an axis, up or down; -1 at a wall.</summary>
        public int Beside(int cell, int axis, bool up)
        {
            int3 coordinates = Coordinates(cell);
            coordinates[axis] += up ? 1 : -1;
            return coordinates[axis] < 0 || coordinates[axis] >= counts[axis] ? -1 : Index(coordinates);
        }

        /// <summary>Fill and activity from where the particles are.</summary>
        public CoarseCells Fill(double3[] points)
        {
            Array.Clear(fill, 0, Total);
            double volume = size.x * size.y * size.z;
            foreach (double3 p in points)
                fill[CellOf(p)] += 1.0 / volume;
            for (int cell = 0; cell < Total; cell++)
                active[cell] = fill[cell] * volume >= 2.0 * Math.Pow(volume, 2.0 / 3.0) - 0.01;
            Array.Copy(fill, water, Total);
            return this;
        }

        /// <summary>Whether the cell or one of the six beside it is active, not both.</summary>
        public bool IsAtSurface(int cell) => Enumerable.Range(0, 3).SelectMany(axis => new[] { Beside(cell, axis, false), Beside(cell, axis, true) })
            .Any(beside => beside >= 0 && active[beside] != active[cell]);

        /// <summary>Weights at the surface: a particle's is 1 at a cell's center and falls to 0 a cell away on each axis, but not towards a
        /// wall.</summary>
        public CoarseCells Weigh(double3[] points)
        {
            for (int cell = 0; cell < Total; cell++)
                if (IsAtSurface(cell))
                    water[cell] = points.Sum(p => WeightOf(p, Coordinates(cell))) / Volume;
            double least = Math.Ceiling(2.0 * Math.Pow(Volume, 2.0 / 3.0) - 0.01) / Volume;
            bool[] weighted = Enumerable.Range(0, Total).Select(IsAtSurface).ToArray();
            for (int cell = 0; cell < Total; cell++)
                if (weighted[cell])
                    active[cell] = water[cell] >= least && 2.0 * fill[cell] > least;
            return this;
        }

        double WeightOf(double3 p, int3 coordinates)
        {
            double weight = 1.0;
            for (int axis = 0; axis < 3; axis++)
            {
                double from = p[axis] / size[axis] - 0.5 - coordinates[axis];
                bool towardsWall = from < 0.0 ? coordinates[axis] == 0 : coordinates[axis] == counts[axis] - 1;
                weight *= towardsWall ? 1.0 : Math.Max(1.0 - Math.Abs(from), 0.0);
            }
            return weight;
        }

        /// <summary>Mean of a value of the particles in each cell; 0 where there are none.</summary>
        public double3[] Mean(double3[] points, Func<int, double3> value)
        {
            var sums = new double3[Total];
            var numbers = new int[Total];
            for (int i = 0; i < points.Length; i++)
            {
                int cell = CellOf(points[i]);
                sums[cell] += value(i);
                numbers[cell]++;
            }
            return sums.Select((sum, cell) => sum / Math.Max(numbers[cell], 1)).ToArray();
        }

        /// <summary>
        /// Weight of a face between an active cell and its neighbor: 1, or what the free surface's distance of θ cells makes of it. With water on
        /// the other side the distance is from the cell's center, else from the center of the water.
        /// </summary>
        public double FaceWeight(int cell, int axis, bool up)
        {
            int beyond = Beside(cell, axis, up), opposite = Beside(cell, axis, !up);
            if (active[beyond])
                return 1.0;
            double height = water[cell] + water[beyond];
            double theta = opposite >= 0 && active[opposite] ? height - 0.5 : height - 0.5 * Math.Min(height, 1.0);
            return 1.0 / Math.Min(Math.Max(theta, 0.1), 1.5);
        }

        /// <summary>The equation's diagonal in an active cell: walls let nothing through.</summary>
        /// <param name="densities">ρ of each cell, of two active ones the mean at their face; null for 1 everywhere.</param>
        public double Diagonal(int cell, double[] densities = null)
        {
            double sum = Screening;
            for (int axis = 0; axis < 3; axis++)
                foreach (bool up in new[] { false, true })
                {
                    int beyond = Beside(cell, axis, up);
                    if (beyond < 0)
                        continue;
                    double density = densities == null ? 1.0 : active[beyond] ? 0.5 * (densities[cell] + densities[beyond]) : densities[cell];
                    sum += FaceWeight(cell, axis, up) / (size[axis] * size[axis] * density);
                }
            return sum;
        }

        /// <summary>Divergence of the flow in an active cell: two active cells have a common face, an inactive one leaves it to the other, a wall is
        /// 0.</summary>
        public double Divergence(int cell, double3[] flow)
        {
            double sum = 0.0;
            for (int axis = 0; axis < 3; axis++)
                sum += (Face(axis, true) - Face(axis, false)) / size[axis];
            return sum;

            double Face(int axis, bool up)
            {
                int beyond = Beside(cell, axis, up);
                if (beyond < 0)
                    return 0.0;
                return active[beyond] ? 0.5 * (flow[cell][axis] + flow[beyond][axis]) : flow[cell][axis];
            }
        }

        /// <summary>g Δt², d.</summary>
        public double3 gravityStep;

        /// <summary>−∇φ at the center of an active cell: half the sum of its faces on each axis.</summary>
        /// <param name="flow">What a wall has to cancel of it; null where walls only let nothing through.</param>
        public double3 Displacement(int cell, double[] potential, double3[] flow)
        {
            double3 result = default;
            for (int axis = 0; axis < 3; axis++)
            {
                double sum = 0.0;
                foreach (bool up in new[] { false, true })
                {
                    int beyond = Beside(cell, axis, up);
                    double outward = up ? 1.0 : -1.0;
                    if (beyond >= 0)
                        sum -= outward * (potential[beyond] - potential[cell]) / size[axis] * FaceWeight(cell, axis, up);
                    else if (flow != null)
                        sum -= outward * IntoWall(cell, Beside(cell, axis, !up), axis, outward, flow, potential[cell] > 0.0);
                }
                result[axis] = 0.5 * sum;
            }
            return result;
        }

        // Outward flow at a wall: on the line through the cell's flow and that of the cell before it, at most the cell's own. Gravity does not
        // pull off the wall what is under pressure.
        double IntoWall(int cell, int before, int axis, double outward, double3[] flow, bool isPressed)
        {
            double own = outward * flow[cell][axis];
            double slope = before >= 0 && active[before] ? own - outward * flow[before][axis] : 0.0;
            double atWall = Math.Min(Math.Max(own + 0.5 * slope, Math.Min(own, 0.0)), Math.Max(own, 0.0));
            return Math.Max(atWall, isPressed ? -Math.Max(-outward * gravityStep[axis], 0.0) : 0.0);
        }

        /// <summary>Displacements of all cells: active ones, and two layers around them as means of those before.</summary>
        public double3[] Displacements(double[] potential, double3[] flow)
        {
            var result = new double3[Total];
            var layer = new int[Total];
            for (int cell = 0; cell < Total; cell++)
                if (active[cell])
                    (result[cell], layer[cell]) = (Displacement(cell, potential, flow), 1);
            for (int next = 2; next <= 3; next++)
                for (int cell = 0; cell < Total; cell++)
                    if (layer[cell] == 0)
                        Extend(cell, next);
            return result;

            void Extend(int cell, int next)
            {
                double3 sum = default;
                int found = 0;
                for (int axis = 0; axis < 3; axis++)
                    foreach (bool up in new[] { false, true })
                    {
                        int beyond = Beside(cell, axis, up);
                        if (beyond < 0 || layer[beyond] != next - 1)
                            continue;
                        sum += result[beyond];
                        found++;
                    }
                if (found > 0)
                    (result[cell], layer[cell]) = (sum / found, next);
            }
        }

        /// <summary>Whether a cell is active and no surface is in one of the 27 around it.</summary>
        public bool IsDeep(int cell) => active[cell] && Around(cell).All(near => !IsAtSurface(near));

        IEnumerable<int> Around(int cell)
        {
            int3 low = math.max(Coordinates(cell) - 1, 0), high = math.min(Coordinates(cell) + 1, counts - 1);
            for (int z = low.z; z <= high.z; z++)
                for (int y = low.y; y <= high.y; y++)
                    for (int x = low.x; x <= high.x; x++)
                        yield return Index(new int3(x, y, z));
        }

        /// <summary>Flow at the center of an active cell from the means of cells: less an eighth of their second differences along each axis,
        /// with the flow mirrored at walls and taken as the cell's own in cells that are not active.</summary>
        public double3 SharpFlow(int cell, double3[] flow)
        {
            double3 differences = default;
            for (int axis = 0; axis < 3; axis++)
                foreach (bool up in new[] { false, true })
                {
                    int beside = Beside(cell, axis, up);
                    double3 other = beside >= 0 && active[beside] ? flow[beside] : flow[cell];
                    if (beside < 0)
                        other[axis] = -other[axis];
                    differences += other - flow[cell];
                }
            return flow[cell] - 0.125 * differences;
        }

        /// <summary>Returns how far a particle at p departs from the flow around it, d in a step; as much of it counts as is deep.</summary>
        /// <param name="sharp">Of each cell, d.</param>
        /// <param name="deep">Of each cell: 1 if it is deep, else 0.</param>
        /// <param name="own">The particle's displacement by its velocity, d.</param>
        public double3 Departure(double3[] sharp, double3[] deep, double3 p, double3 own)
        {
            double3 box = size * counts;
            double3 towardsWalls = math.min(math.min(2.0 * p / size, 2.0 * (box - p) / size), 1.0);
            return LookUp(deep, p, double.PositiveInfinity).x * (own - towardsWalls * LookUp(sharp, p, double.PositiveInfinity));
        }

        /// <summary>Trilinear between the centers, the outermost ones' values beyond them, at most so long.</summary>
        public double3 LookUp(double3[] displacements, double3 p, double longest)
        {
            double3 position = p / size - 0.5;
            double3 sum = default;
            for (int corner = 0; corner < 8; corner++)
            {
                double weight = 1.0;
                int3 at = default;
                for (int axis = 0; axis < 3; axis++)
                {
                    bool upper = (corner >> axis & 1) != 0;
                    double lower = Math.Floor(position[axis]);
                    weight *= upper ? position[axis] - lower : 1.0 - (position[axis] - lower);
                    at[axis] = (int)Math.Min(Math.Max(lower + (upper ? 1.0 : 0.0), 0.0), counts[axis] - 1.0);
                }
                sum += weight * displacements[Index(at)];
            }
            double length = math.length(sum);
            return length > longest ? sum * (longest / length) : sum;
        }
    }
}
