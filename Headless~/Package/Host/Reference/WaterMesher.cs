using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace Host.Reference
{
    /// <summary>A closed mesh of quads around particles, for the reference alone: plain, slow, and with nothing of the surface that it
    /// judges.</summary>
    /// <remarks>
    /// The color field of Yu and Turk 2013, "Reconstructing Surfaces of Particle-Based Fluids Using Anisotropic Kernels", at 0.45 of what it is in
    /// water at rest, on a grid of half a spacing; surface nets (Gibson 1998) and Taubin's smoothing (1995) on that. It differs from the paper in two
    /// positions. Semi-axes are 2.5 d times a variance over that of full water, from 0.4 to 1, so that sheets of one particle keep their volume, and
    /// threads 3/4 of it; a lone particle keeps 1/3. The paper's smoothing of centers is left out: it draws the outermost layer inwards, and two
    /// layers into one.
    /// All lengths are in particle spacings.
    /// </remarks>
    sealed class WaterMesher
    {
        public const double Cell = 0.5;         // of the grid
        public const int SmoothingPairs = 10;
        const double Reach = 3.0;               // of what is a neighbor
        const double SemiAxis = 2.5, MinFactor = 0.4, Level = 0.45;
        const double FullVariance = 0.15 * Reach * Reach;       // along an axis, of water all around with the weights below
        const double Forward = 0.5, Back = -0.53;               // of a pair, Taubin 1995
        const int Border = 4;                                   // cells of the grid beyond the walls

        readonly double3 size;
        readonly double beyond;
        readonly List<double3> points;          // the particles, then the images in the walls
        readonly int[][] neighbors;             // each is one of its own

        public readonly List<double3> Vertices = new();
        /// <summary>Four vertices of each; the cross product of its diagonals points into the air.</summary>
        public readonly List<int4> Quads = new();

        /// <param name="particles">In the domain's frame, lowest corner at 0.</param>
        /// <param name="images">Points behind the solids that the water touches, so that it reaches into them.</param>
        /// <param name="size">Of the domain.</param>
        /// <param name="beyond">How far behind the domain's walls the water's faces lie, so that no gap of air is before a floor.</param>
        public WaterMesher(IEnumerable<double3> particles, IEnumerable<double3> images, double3 size, double beyond)
        {
            this.size = size;
            this.beyond = beyond;
            points = particles.Concat(images).ToList();
            AddWallImages();
            neighbors = Neighbors(points.ToArray());
            float[] field = Field(out int3 counts);
            Net(field, counts);
        }

        void AddWallImages()
        {
            for (int axis = 0; axis < 3; axis++)        // those of edges and corners by the images of the axes before
                for (int i = 0, count = points.Count; i < count; i++)
                {
                    double3 image = points[i];
                    if (image[axis] < Reach)
                        points.Add(With(image, axis, -image[axis]));
                    if (size[axis] - image[axis] < Reach)
                        points.Add(With(image, axis, 2.0 * size[axis] - image[axis]));
                }
        }

        static double3 With(double3 of, int axis, double value)
        {
            of[axis] = value;
            return of;
        }

        // neighbors

        // Equation 11 of the paper.
        static double Weight(double distance)
        {
            double q = distance / Reach;
            return Math.Max(1.0 - q * q * q, 0.0);
        }

        static int[][] Neighbors(double3[] points)
        {
            var cells = new Dictionary<int3, List<int>>();
            for (int i = 0; i < points.Length; i++)
            {
                int3 cell = (int3)math.floor(points[i] / Reach);
                if (!cells.TryGetValue(cell, out List<int> list))
                    cells[cell] = list = new List<int>();
                list.Add(i);
            }
            var found = new int[points.Length][];
            System.Threading.Tasks.Parallel.For(0, points.Length, i =>
            {
                var near = new List<int>();
                int3 cell = (int3)math.floor(points[i] / Reach);
                for (int n = 0; n < 27; n++)
                    if (cells.TryGetValue(cell + new int3(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1), out List<int> list))
                        foreach (int j in list)
                            if (math.lengthsq(points[j] - points[i]) < Reach * Reach)
                                near.Add(j);
                found[i] = near.ToArray();
            });
            return found;
        }

        // the field

        float[] Field(out int3 counts)
        {
            counts = (int3)math.ceil(size / Cell) + 2 * Border;
            var field = new float[checked(counts.x * counts.y * counts.z)];
            for (int i = 0; i < points.Count; i++)
            {
                Kernel(i, out double3[] axes, out double3 factors);
                Splat(field, counts, points[i], axes, SemiAxis * factors);
            }
            for (int i = 0; i < field.Length; i++)
                if (math.any(math.abs(Node(i, counts) - 0.5 * size) > 0.5 * size))
                    field[i] = 0f;
            return field;
        }

        static double3 Node(int i, int3 counts)
            => Cell * (new double3(i % counts.x, i / counts.x % counts.y, i / (counts.x * counts.y)) - Border + 0.5);

        /// <summary>Principal axes of the neighbors' covariance, equations 9 and 10, and their variances over that of full water.</summary>
        void Kernel(int i, out double3[] axes, out double3 factors)
        {
            double3 mean = default;
            double weights = 0.0;
            foreach (int j in neighbors[i])
            {
                double weight = Weight(math.length(points[j] - points[i]));
                mean += weight * points[j];
                weights += weight;
            }
            mean /= weights;
            var covariance = new double3[3];
            foreach (int j in neighbors[i])
            {
                double3 away = points[j] - mean;
                double weight = Weight(math.length(points[j] - points[i])) / weights;
                covariance[0] += weight * away.x * away;
                covariance[1] += weight * away.y * away;
                covariance[2] += weight * away.z * away;
            }
            axes = Eigenvectors(covariance);
            factors = math.clamp(new double3(covariance[0].x, covariance[1].y, covariance[2].z) / FullVariance, MinFactor, 1.0);
        }

        /// <summary>By Jacobi's rotations; the matrix becomes diagonal.</summary>
        static double3[] Eigenvectors(double3[] matrix)
        {
            var vectors = new[] { new double3(1, 0, 0), new double3(0, 1, 0), new double3(0, 0, 1) };
            for (int sweep = 0; sweep < 12; sweep++)
                for (int p = 0; p < 2; p++)
                    for (int q = p + 1; q < 3; q++)
                    {
                        double off = matrix[p][q];
                        if (Math.Abs(off) < 1e-14)
                            continue;
                        double theta = (matrix[q][q] - matrix[p][p]) / (2.0 * off);
                        double t = (theta < 0 ? -1.0 : 1.0) / (Math.Abs(theta) + Math.Sqrt(theta * theta + 1.0));
                        double cosine = 1.0 / Math.Sqrt(t * t + 1.0), sine = t * cosine;
                        for (int k = 0; k < 3; k++)
                        {
                            (double a, double b) = (matrix[k][p], matrix[k][q]);
                            (matrix[k][p], matrix[k][q]) = (cosine * a - sine * b, sine * a + cosine * b);
                        }
                        for (int k = 0; k < 3; k++)
                        {
                            (double a, double b) = (matrix[p][k], matrix[q][k]);
                            (matrix[p][k], matrix[q][k]) = (cosine * a - sine * b, sine * a + cosine * b);
                            (a, b) = (vectors[p][k], vectors[q][k]);
                            (vectors[p][k], vectors[q][k]) = (cosine * a - sine * b, sine * a + cosine * b);
                        }
                    }
            return vectors;
        }

        // (1 - q^2)^3, whose integral over the unit ball is 64 pi / 315: a particle's volume is 1.
        static void Splat(float[] field, int3 counts, double3 center, double3[] axes, double3 semiAxes)
        {
            double amplitude = 315.0 / (64.0 * Math.PI) / (semiAxes.x * semiAxes.y * semiAxes.z);
            double3 x = axes[0] / semiAxes.x, y = axes[1] / semiAxes.y, z = axes[2] / semiAxes.z, reach = default;
            for (int k = 0; k < 3; k++)
                reach[k] = Math.Sqrt(Square(axes[0][k] * semiAxes.x) + Square(axes[1][k] * semiAxes.y) + Square(axes[2][k] * semiAxes.z));
            int3 low = math.max((int3)math.ceil((center - reach) / Cell - 0.5) + Border, 0);
            int3 high = math.min((int3)math.floor((center + reach) / Cell - 0.5) + Border, counts - 1);
            for (int k = low.z; k <= high.z; k++)
                for (int j = low.y; j <= high.y; j++)
                    for (int i = low.x; i <= high.x; i++)
                    {
                        double3 away = Cell * (new double3(i, j, k) - Border + 0.5) - center;
                        double left = 1.0 - Square(math.dot(x, away)) - Square(math.dot(y, away)) - Square(math.dot(z, away));
                        if (left > 0.0)
                            field[(k * counts.y + j) * counts.x + i] += (float)(amplitude * left * left * left);
                    }
        }

        static double Square(double value) => value * value;

        // the net

        void Net(float[] field, int3 counts)
        {
            int[] strides = { 1, counts.x, counts.x * counts.y };
            var vertexOf = new int[field.Length];
            var fixedAxes = new List<bool3>();
            for (int z = 0; z + 1 < counts.z; z++)
                for (int y = 0; y + 1 < counts.y; y++)
                    for (int x = 0; x + 1 < counts.x; x++)
                    {
                        int node = (z * counts.y + y) * counts.x + x;
                        vertexOf[node] = -1;
                        if (!Crossing(field, node, strides, out double3 at))
                            continue;
                        vertexOf[node] = Vertices.Count;
                        double3 low = Node(node, counts), vertex = low + Cell * at;
                        bool3 atLow = low < 0.0, atHigh = low + Cell > size;
                        for (int axis = 0; axis < 3; axis++)
                            vertex[axis] = atLow[axis] ? -beyond : atHigh[axis] ? size[axis] + beyond : vertex[axis];
                        Vertices.Add(vertex);
                        fixedAxes.Add(atLow | atHigh);
                    }
            for (int axis = 0; axis < 3; axis++)
            {
                int u = strides[(axis + 1) % 3], v = strides[(axis + 2) % 3];
                for (int node = u + v; node + strides[axis] < field.Length; node++)
                {
                    bool here = field[node] > Level, there = field[node + strides[axis]] > Level;
                    if (here == there)
                        continue;
                    var quad = new int4(vertexOf[node - u - v], vertexOf[node - v], vertexOf[node], vertexOf[node - u]);
                    Quads.Add(here ? quad : quad.wzyx);
                }
            }
            Smooth(fixedAxes);
        }

        // The mean of where the cell's edges cross the level, from 0 to 1.
        static bool Crossing(float[] field, int node, int[] strides, out double3 at)
        {
            at = default;
            int count = 0;
            for (int corner = 0; corner < 8; corner++)
                for (int axis = 0; axis < 3; axis++)
                {
                    if ((corner >> axis & 1) != 0)
                        continue;
                    int from = node + (corner & 1) * strides[0] + (corner >> 1 & 1) * strides[1] + (corner >> 2) * strides[2];
                    double a = field[from] - Level, b = field[from + strides[axis]] - Level;
                    if (a > 0.0 == b > 0.0)
                        continue;
                    var point = new double3(corner & 1, corner >> 1 & 1, corner >> 2);
                    point[axis] = a / (a - b);
                    at += point;
                    count++;
                }
            at /= Math.Max(count, 1);
            return count > 0;
        }

        void Smooth(List<bool3> fixedAxes)
        {
            var sums = new double3[Vertices.Count];
            var counts = new int[Vertices.Count];
            for (int pair = 0; pair < SmoothingPairs; pair++)
                foreach (double step in new[] { Forward, Back })
                {
                    Array.Clear(sums);
                    Array.Clear(counts);
                    foreach (int4 quad in Quads)
                        for (int i = 0; i < 4; i++)         // both directions: each edge belongs to two quads
                        {
                            sums[quad[i]] += Vertices[quad[(i + 1) % 4]];
                            counts[quad[i]]++;
                        }
                    for (int i = 0; i < sums.Length; i++)
                        Vertices[i] = math.select(Vertices[i] + step * (sums[i] / counts[i] - Vertices[i]), Vertices[i], fixedAxes[i]);
                }
        }

        // measures

        /// <summary>Within the mesh.</summary>
        public double Volume()
        {
            double sum = 0.0;
            foreach (int4 quad in Quads)
                foreach (int3 triangle in new[] { quad.xyz, quad.xzw })
                    sum += math.dot(Vertices[triangle.x], math.cross(Vertices[triangle.y], Vertices[triangle.z])) / 6.0;
            return sum;
        }

        /// <summary>Edges that do not have as many quads on their one side as on their other: 0 where the mesh is closed.</summary>
        public int OpenEdges()
        {
            var balance = new Dictionary<(int, int), int>();
            foreach (int4 quad in Quads)
                for (int i = 0; i < 4; i++)
                {
                    (int a, int b) = (quad[i], quad[(i + 1) % 4]);
                    (int, int) key = (Math.Min(a, b), Math.Max(a, b));
                    balance[key] = balance.GetValueOrDefault(key) + (a < b ? 1 : -1);
                }
            return balance.Values.Count(value => value != 0);
        }
    }
}
