using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>Which triangles of a mesh take part in a bake: those with an area and with vertices that are finite numbers.</summary>
    sealed class BakedTriangles
    {
        /// <summary>A triangle without area: thinner than this share of its longest edge.</summary>
        const double Thinnest = 1e-10;

        readonly bool[] takesPart;

        public BakedTriangles(TriangleMesh mesh)
        {
            Mesh = mesh;
            takesPart = new bool[mesh.TriangleCount];
            float3 low = float.PositiveInfinity, high = float.NegativeInfinity;
            for (int t = 0; t < takesPart.Length; t++)
            {
                float3 a = mesh.Corner(t, 0), b = mesh.Corner(t, 1), c = mesh.Corner(t, 2);
                if (!math.all(math.isfinite(a) & math.isfinite(b) & math.isfinite(c)))
                {
                    NonFinite++;
                    continue;
                }
                double3 ab = (double3)b - a, ac = (double3)c - a, bc = ac - ab, cross = math.cross(ab, ac);
                double squared = math.lengthsq(cross), longest = math.max(math.lengthsq(ab), math.max(math.lengthsq(bc), math.lengthsq(ac)));
                if (!(squared > Thinnest * Thinnest * longest * longest))
                {
                    WithoutArea++;
                    continue;
                }
                takesPart[t] = true;
                Count++;
                Area += 0.5 * math.sqrt(squared);
                low = math.min(low, math.min(a, math.min(b, c)));
                high = math.max(high, math.max(a, math.max(b, c)));
            }
            var bounds = new Bounds();
            if (Count > 0)
                bounds.SetMinMax(low, high);
            Bounds = bounds;
        }

        public TriangleMesh Mesh { get; }

        /// <summary>Of those that take part.</summary>
        public int Count { get; }

        public int NonFinite { get; }
        public int WithoutArea { get; }

        /// <summary>Of those that take part, m²; a sum in double precision.</summary>
        public double Area { get; }

        /// <summary>Of those that take part, m.</summary>
        public Bounds Bounds { get; }

        public bool TakesPart(int triangle) => takesPart[triangle];
    }
}
