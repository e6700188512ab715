using System;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Distance and winding number over all triangles, one after the other, in double precision.</summary>
    static class MeshDistance
    {
        public static double Unsigned(TriangleMesh mesh, double3 p)
        {
            double least = double.PositiveInfinity;
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                Corners(mesh, t, out double3 a, out double3 b, out double3 c);
                least = Math.Min(least, ToTriangle(p, a, b, c));
            }
            return least;
        }

        /// <summary>Generalized winding number, Jacobson et al. 2013, eq. 5.</summary>
        public static double Winding(TriangleMesh mesh, double3 p)
        {
            double sum = 0;
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                Corners(mesh, t, out double3 a, out double3 b, out double3 c);
                sum += SolidAngle(a - p, b - p, c - p);
            }
            return sum / (4 * Math.PI);
        }

        static void Corners(TriangleMesh mesh, int t, out double3 a, out double3 b, out double3 c)
        {
            a = (float3)mesh.Vertices[mesh.Triangles[3 * t]];
            b = (float3)mesh.Vertices[mesh.Triangles[3 * t + 1]];
            c = (float3)mesh.Vertices[mesh.Triangles[3 * t + 2]];
        }

        static double SolidAngle(double3 a, double3 b, double3 c)
        {
            double la = math.length(a), lb = math.length(b), lc = math.length(c);
            return 2 * Math.Atan2(math.dot(a, math.cross(b, c)), la * lb * lc + math.dot(a, b) * lc + math.dot(b, c) * la + math.dot(c, a) * lb);
        }

        /// <summary>To the plane where the foot lies inside of the triangle, else to the nearest edge.</summary>
        public static double ToTriangle(double3 p, double3 a, double3 b, double3 c)
        {
            double3 normal = math.cross(b - a, c - a);
            bool above = math.dot(math.cross(b - a, p - a), normal) >= 0 && math.dot(math.cross(c - b, p - b), normal) >= 0
                && math.dot(math.cross(a - c, p - c), normal) >= 0;
            if (above && math.lengthsq(normal) > 0)
                return Math.Abs(math.dot(math.normalize(normal), p - a));
            return Math.Min(ToSegment(p, a, b), Math.Min(ToSegment(p, b, c), ToSegment(p, c, a)));
        }

        static double ToSegment(double3 p, double3 a, double3 b)
        {
            double t = math.clamp(math.dot(p - a, b - a) / math.max(math.lengthsq(b - a), 1e-300), 0, 1);
            return math.length(p - a - t * (b - a));
        }
    }
}
