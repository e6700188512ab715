using System;

namespace UnityEngine.Headless
{
    internal static class Culling
    {
        /// <summary>Whether a box lies wholly outside of one of the six planes of a clip matrix (z from -w to w).</summary>
        public static bool IsOutside(in Matrix4x4 clip, in Bounds bounds)
        {
            Vector3 c = bounds.center, e = bounds.extents;
            Vector4 w = clip.GetRow(3);
            for (int axis = 0; axis < 3; axis++)
            {
                Vector4 row = clip.GetRow(axis);
                if (Below(w + row, c, e) || Below(w - row, c, e))
                    return true;
            }
            return false;
        }

        static bool Below(Vector4 plane, Vector3 center, Vector3 extents)
        {
            float distance = plane.x * center.x + plane.y * center.y + plane.z * center.z + plane.w;
            float reach = Math.Abs(plane.x) * extents.x + Math.Abs(plane.y) * extents.y + Math.Abs(plane.z) * extents.z;
            return distance + reach < 0;
        }

        /// <summary>The box around a transformed box.</summary>
        public static Bounds Transform(in Bounds bounds, in Matrix4x4 matrix)
        {
            Vector3 e = bounds.extents;
            var extents = new Vector3(
                Math.Abs(matrix.m00) * e.x + Math.Abs(matrix.m01) * e.y + Math.Abs(matrix.m02) * e.z,
                Math.Abs(matrix.m10) * e.x + Math.Abs(matrix.m11) * e.y + Math.Abs(matrix.m12) * e.z,
                Math.Abs(matrix.m20) * e.x + Math.Abs(matrix.m21) * e.y + Math.Abs(matrix.m22) * e.z);
            return new Bounds(matrix.MultiplyPoint3x4(bounds.center), extents * 2);
        }
    }
}
