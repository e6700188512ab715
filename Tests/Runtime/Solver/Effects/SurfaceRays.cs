using System;
using System.Collections.Generic;
using Rill.Tests.Reference;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>The first hits of parallel rays with ellipsoids, on a grid: what a camera without perspective sees of the surface. Lengths
    /// in d.</summary>
    sealed class SurfaceRays
    {
        readonly int along, right, up;
        readonly double direction;

        public readonly double Step;
        public readonly double2 First;
        public readonly int2 Count;

        /// <summary>Coordinate of the first hit along the axis; NaN where a ray meets nothing.</summary>
        public readonly double[] Hits;

        /// <summary>Normal at the hit, length 1.</summary>
        public readonly double3[] Normals;

        /// <param name="axis">0 to 2: the rays run along it.</param>
        /// <param name="direction">1: upwards, from below; -1: downwards.</param>
        /// <param name="low">Of the two other axes in their order after this one; the higher corner as well.</param>
        public SurfaceRays(IEnumerable<SurfaceShape> shapes, int axis, int direction, double2 low, double2 high, double step = 0.1)
        {
            (along, right, up) = (axis, (axis + 1) % 3, (axis + 2) % 3);
            this.direction = direction;
            Step = step;
            First = low + 0.5 * step;
            Count = (int2)math.floor((high - low) / step + 1e-9);
            Hits = new double[Count.x * Count.y];
            Normals = new double3[Hits.Length];
            Array.Fill(Hits, double.NaN);
            foreach (SurfaceShape shape in shapes)
                Cast(shape);
        }

        /// <summary>Position of a ray on the two other axes.</summary>
        public double2 At(int i) => First + Step * new double2(i % Count.x, i / Count.x);

        void Cast(in SurfaceShape shape)
        {
            Tensor inverse = shape.Squares.Inverse;
            double3 reach = shape.Reach;
            var center = new double2(shape.center[right], shape.center[up]);
            var extent = new double2(reach[right], reach[up]);
            int2 from = math.max((int2)math.floor((center - extent - First) / Step), 0),
                to = math.min((int2)math.ceil((center + extent - First) / Step), Count - 1);
            for (int y = from.y; y <= to.y; y++)
                for (int x = from.x; x <= to.x; x++)
                {
                    int i = y * Count.x + x;
                    double3 start = 0.0, ray = 0.0;
                    double2 offset = At(i) - center;
                    start[right] = offset.x;
                    start[up] = offset.y;
                    ray[along] = direction;
                    // (start + t ray) A (start + t ray) = 1
                    double a = math.dot(ray, inverse * ray), b = math.dot(ray, inverse * start), c = math.dot(start, inverse * start) - 1.0;
                    double root = b * b - a * c;
                    if (root < 0.0)
                        continue;
                    double t = (-b - Math.Sqrt(root)) / a, hit = shape.center[along] + direction * t;
                    if (!double.IsNaN(Hits[i]) && direction * hit >= direction * Hits[i])
                        continue;
                    Hits[i] = hit;
                    Normals[i] = math.normalize(inverse * (start + t * ray));
                }
        }
    }
}
