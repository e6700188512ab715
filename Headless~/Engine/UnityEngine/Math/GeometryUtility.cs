using System;

namespace UnityEngine
{
    public sealed class GeometryUtility
    {
        public static Plane[] CalculateFrustumPlanes(Camera camera) => CalculateFrustumPlanes(camera.projectionMatrix * camera.worldToCameraMatrix);
        public static void CalculateFrustumPlanes(Camera camera, Plane[] planes)
            => CalculateFrustumPlanes(camera.projectionMatrix * camera.worldToCameraMatrix, planes);

        public static Plane[] CalculateFrustumPlanes(Matrix4x4 worldToProjectionMatrix)
        {
            var planes = new Plane[6];
            CalculateFrustumPlanes(worldToProjectionMatrix, planes);
            return planes;
        }

        /// <summary>Left, right, bottom, top, near, far; normals point inwards. The matrix is in OpenGL's convention, as a camera's
        /// projectionMatrix.</summary>
        public static void CalculateFrustumPlanes(Matrix4x4 worldToProjectionMatrix, Plane[] planes)
        {
            if (planes == null)
                throw new ArgumentNullException(nameof(planes));
            if (planes.Length != 6)
                throw new ArgumentException("Planes array must be of length 6.", nameof(planes));
            Vector4 w = worldToProjectionMatrix.GetRow(3);
            for (int axis = 0; axis < 3; axis++)
            {
                Vector4 row = worldToProjectionMatrix.GetRow(axis);
                planes[axis * 2] = ToPlane(w + row);
                planes[axis * 2 + 1] = ToPlane(w - row);
            }
        }

        static Plane ToPlane(Vector4 v)
        {
            float length = ((Vector3)v).magnitude;
            return new Plane { normal = (Vector3)v / length, distance = v.w / length };
        }

        /// <summary>False only when the box lies outside of one plane as a whole.</summary>
        public static bool TestPlanesAABB(Plane[] planes, Bounds bounds)
        {
            foreach (Plane plane in planes)
            {
                Vector3 n = plane.normal, e = bounds.extents;
                float reach = e.x * MathF.Abs(n.x) + e.y * MathF.Abs(n.y) + e.z * MathF.Abs(n.z);
                if (plane.GetDistanceToPoint(bounds.center) < -reach)
                    return false;
            }
            return true;
        }

        public static Bounds CalculateBounds(Vector3[] positions, Matrix4x4 transform)
        {
            if (positions == null)
                throw new ArgumentNullException(nameof(positions));
            if (positions.Length == 0)
                throw new ArgumentException("Zero-sized array is not allowed.", nameof(positions));
            var bounds = new Bounds(transform.MultiplyPoint3x4(positions[0]), Vector3.zero);
            foreach (Vector3 position in positions)
                bounds.Encapsulate(transform.MultiplyPoint3x4(position));
            return bounds;
        }

        public static bool TryCreatePlaneFromPolygon(Vector3[] vertices, out Plane plane)
        {
            plane = default;
            if (vertices == null || vertices.Length < 3)
                return false;
            Vector3 normal = Vector3.zero, center = Vector3.zero;
            for (int i = 0; i < vertices.Length; i++)
            {
                Vector3 a = vertices[i], b = vertices[(i + 1) % vertices.Length];
                normal += new Vector3((a.y - b.y) * (a.z + b.z), (a.z - b.z) * (a.x + b.x), (a.x - b.x) * (a.y + b.y));
                center += a;
            }
            if (normal.magnitude < Vector3.kEpsilon)
                return false;
            plane = new Plane(normal, center / vertices.Length);
            return true;
        }
    }
}
