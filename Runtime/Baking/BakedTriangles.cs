using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>Which triangles of a mesh take part in a bake: those with an area and with vertices that are finite numbers.</summary>
    sealed class BakedTriangles
    {
        /// <summary>A triangle without area: thinner than this fraction of its longest edge.</summary>
        const double Thinnest = 1e-10;

        readonly bool[] takesPart;

        // Sums over a chunk.
        struct Sums
        {
            public int count, nonFinite, withoutArea;
            public double area;
            public float3 low, high;
        }

        public BakedTriangles(TriangleMesh mesh)
        {
            Mesh = mesh;
            takesPart = new bool[mesh.TriangleCount];
            var chunks = new Sums[Chunks.Of(takesPart.Length)];
            Chunks.Run(takesPart.Length, (chunk, first, end) => chunks[chunk] = Look(first, end));

            float3 low = float.PositiveInfinity, high = float.NegativeInfinity;
            foreach (Sums chunk in chunks)
            {
                Count += chunk.count;
                NonFinite += chunk.nonFinite;
                WithoutArea += chunk.withoutArea;
                Area += chunk.area;
                low = math.min(low, chunk.low);
                high = math.max(high, chunk.high);
            }
            var bounds = new Bounds();
            if (Count > 0)
                bounds.SetMinMax(low, high);
            Bounds = bounds;
        }

        Sums Look(int first, int end)
        {
            Vector3[] vertices = Mesh.Vertices;
            int[] corners = Mesh.Triangles;
            var sums = new Sums { low = float.PositiveInfinity, high = float.NegativeInfinity };
            for (int t = first; t < end; t++)
            {
                float3 a = vertices[corners[3 * t]], b = vertices[corners[3 * t + 1]], c = vertices[corners[3 * t + 2]];
                if (!math.all(math.isfinite(a) & math.isfinite(b) & math.isfinite(c)))
                {
                    sums.nonFinite++;
                    continue;
                }
                double3 ab = (double3)b - a, ac = (double3)c - a, bc = ac - ab, cross = math.cross(ab, ac);
                double squared = math.lengthsq(cross), longest = math.max(math.lengthsq(ab), math.max(math.lengthsq(bc), math.lengthsq(ac)));
                if (!(squared > Thinnest * Thinnest * longest * longest))
                {
                    sums.withoutArea++;
                    continue;
                }
                takesPart[t] = true;
                sums.count++;
                sums.area += 0.5 * math.sqrt(squared);
                sums.low = math.min(sums.low, math.min(a, math.min(b, c)));
                sums.high = math.max(sums.high, math.max(a, math.max(b, c)));
            }
            return sums;
        }

        public TriangleMesh Mesh { get; }

        /// <summary>Number of triangles that take part.</summary>
        public int Count { get; }

        public int NonFinite { get; }
        public int WithoutArea { get; }

        /// <summary>Area of the triangles that take part, m²; a sum in double precision.</summary>
        public double Area { get; }

        /// <summary>Bounds of the triangles that take part, m.</summary>
        public Bounds Bounds { get; }

        public bool TakesPart(int triangle) => takesPart[triangle];
    }
}
