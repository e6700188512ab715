using System;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>A view of the mesh of a fluid's surface, found ray by ray in double precision: where each pixel first meets water, and how much
    /// is behind that.</summary>
    sealed class SurfacePicture
    {
        /// <summary>Cell of the mesh with <see cref="SurfaceQuality.Medium"/>, d.</summary>
        public const float Medium = 0.75f;

        Matrix4x4 worldToView, projection;

        public int Width { get; private set; }
        public int Height { get; private set; }

        /// <summary>Depth along the view, m; 0 without water. Row by row from the bottom.</summary>
        public double[] Depth { get; private set; }

        /// <summary>World, out of the water.</summary>
        public double3[] Normals { get; private set; }

        /// <summary>Water along each ray, m.</summary>
        public double[] Thickness { get; private set; }

        /// <param name="from">World, m.</param>
        /// <param name="size">Angle from the picture's bottom to its top, degrees; below 0: minus the height, m, without perspective.</param>
        public SurfacePicture Look(Vector3 from, Vector3 at, float size, int width, int height, float near = 0.1f, float far = 200f)
        {
            worldToView = Matrix4x4.TRS(from,
                Quaternion.LookRotation(at - from, Mathf.Abs((at - from).normalized.y) > 0.99f ? Vector3.forward : Vector3.up),
                new Vector3(1f, 1f, -1f)).inverse;
            float aspect = (float)width / height;
            projection = size > 0f ? Matrix4x4.Perspective(size, aspect, near, far)
                : Matrix4x4.Ortho(0.5f * size * aspect, -0.5f * size * aspect, 0.5f * size, -0.5f * size, near, far);
            (Width, Height) = (width, height);
            return this;
        }

        /// <summary>Draws the newest state of a solver whose domain's lowest corner is the world's origin.</summary>
        /// <param name="cell">Distance of the mesh's nodes, d.</param>
        public SurfacePicture Draw(TestFluid fluid, float cell = Medium)
        {
            DrawnMesh mesh = DrawnMesh.Of(fluid, cell);
            double spacing = fluid.Spacing;
            Depth = new double[Width * Height];
            Normals = new double3[Width * Height];
            Thickness = new double[Width * Height];
            var onPicture = new double2[mesh.positions.Length];
            for (int i = 0; i < onPicture.Length; i++)
            {
                float3 world = (float3)(mesh.positions[i] * spacing);
                Vector4 clip = projection * (worldToView * new Vector4(world.x, world.y, world.z, 1f));
                onPicture[i] = new double2((clip.x / clip.w * 0.5 + 0.5) * Width - 0.5, (clip.y / clip.w * 0.5 + 0.5) * Height - 0.5);
            }
            for (int i = 0; i < mesh.indices.Length; i += 3)
            {
                uint a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
                double2 low = math.min(math.min(onPicture[a], onPicture[b]), onPicture[c]),
                    high = math.max(math.max(onPicture[a], onPicture[b]), onPicture[c]);
                for (int y = Math.Max((int)math.ceil(low.y - 1e-3), 0); y <= Math.Min((int)math.floor(high.y + 1e-3), Height - 1); y++)
                    for (int x = Math.Max((int)math.ceil(low.x - 1e-3), 0); x <= Math.Min((int)math.floor(high.x + 1e-3), Width - 1); x++)
                        Cast(mesh, a, b, c, x, y, spacing);
            }
            return this;
        }

        /// <summary>The ray through the center of a pixel, of length 1 along the view.</summary>
        public void Ray(int x, int y, out float3 origin, out float3 direction)
        {
            var picture = new Vector2((x + 0.5f) / Width * 2f - 1f, (y + 0.5f) / Height * 2f - 1f);
            bool isOrthographic = projection.m32 == 0f;
            Matrix4x4 toWorld = worldToView.inverse;
            var across = new Vector3((picture.x + (isOrthographic ? -projection.m03 : projection.m02)) / projection.m00,
                (picture.y + (isOrthographic ? -projection.m13 : projection.m12)) / projection.m11, 0f);
            origin = toWorld.MultiplyPoint3x4(isOrthographic ? across : Vector3.zero);
            direction = toWorld.MultiplyVector(isOrthographic ? Vector3.back : across + Vector3.back);
        }

        /// <summary>Position of the surface at a pixel, world, m.</summary>
        public float3 Point(int x, int y)
        {
            Ray(x, y, out float3 origin, out float3 direction);
            return origin + direction * (float)Depth[y * Width + x];
        }

        // A triangle and a ray (Möller and Trumbore 1997).
        void Cast(DrawnMesh mesh, uint a, uint b, uint c, int x, int y, double spacing)
        {
            Ray(x, y, out float3 from, out float3 along);
            double3 origin = (double3)from / spacing, direction = along, corner = mesh.positions[a];
            double3 first = mesh.positions[b] - corner, second = mesh.positions[c] - corner, cross = math.cross(direction, second);
            double determinant = math.dot(first, cross);
            if (Math.Abs(determinant) < 1e-12)
                return;
            double3 offset = origin - corner, other = math.cross(offset, first);
            double u = math.dot(offset, cross) / determinant, v = math.dot(direction, other) / determinant;
            if (u < -1e-9 || v < -1e-9 || u + v > 1.0 + 1e-9)
                return;
            double depth = math.dot(second, other) / determinant * spacing;
            if (depth <= 0.0)
                return;
            int pixel = y * Width + x;
            bool leaves = math.dot(math.cross(first, second), direction) > 0.0;
            Thickness[pixel] += (leaves ? depth : -depth) * math.length(direction);
            if (Depth[pixel] > 0.0 && depth >= Depth[pixel])
                return;
            Depth[pixel] = depth;
            Normals[pixel] = math.normalize((1.0 - u - v) * mesh.normals[a] + u * mesh.normals[b] + v * mesh.normals[c]);
        }
    }
}
