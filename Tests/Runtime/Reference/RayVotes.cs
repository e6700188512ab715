using System;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Inside by counting what rays along the three axes cross, two votes of three: the method that was not taken.</summary>
    static class RayVotes
    {
        public static bool IsInside(TriangleMesh mesh, double3 p)
        {
            int votes = 0;
            for (int axis = 0; axis < 3; axis++)
            {
                bool odd = false;
                for (int t = 0; t < mesh.TriangleCount; t++)
                    odd ^= Crosses(At(mesh, t, 0, axis) - Turn(p, axis), At(mesh, t, 1, axis) - Turn(p, axis), At(mesh, t, 2, axis) - Turn(p, axis));
                votes += odd ? 1 : 0;
            }
            return votes >= 2;
        }

        // Whether the ray from the origin towards +x crosses a triangle.
        static bool Crosses(double3 a, double3 b, double3 c)
        {
            double ab = a.y * b.z - a.z * b.y, bc = b.y * c.z - b.z * c.y, ca = c.y * a.z - c.z * a.y;
            if (!(ab > 0 && bc > 0 && ca > 0 || ab < 0 && bc < 0 && ca < 0))
                return false;
            return (bc * a.x + ca * b.x + ab * c.x) / (ab + bc + ca) > 0;
        }

        static double3 At(TriangleMesh mesh, int t, int k, int axis) => Turn((float3)mesh.Vertices[mesh.Triangles[3 * t + k]], axis);
        static double3 Turn(double3 p, int axis) => axis == 0 ? p : axis == 1 ? p.yzx : p.zxy;
    }
}
