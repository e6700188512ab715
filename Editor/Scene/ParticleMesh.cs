using System;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill.Editor
{
    /// <summary>Particles as one mesh of octahedra, with which gizmos draw thousands in one call.</summary>
    static class ParticleMesh
    {
        /// <summary>Radius of an octahedron, spacings.</summary>
        public const float Radius = 0.5f;

        /// <summary>Vertices that each particle has.</summary>
        public const int Corners = 6;

        static readonly Vector3[] directions = { Vector3.right, Vector3.left, Vector3.up, Vector3.down, Vector3.forward, Vector3.back };

        static readonly int[] faces = { 0, 2, 5, 0, 4, 2, 1, 5, 2, 1, 2, 4, 0, 5, 3, 0, 3, 4, 1, 3, 5, 1, 4, 3 };

        /// <param name="positions">xyz, spacings.</param>
        /// <param name="step">Each step-th is drawn, from the first on.</param>
        public static Mesh Make(ReadOnlySpan<float4> positions, int step)
        {
            int count = (positions.Length + step - 1) / step;
            var corners = new Vector3[count * Corners];
            var normals = new Vector3[corners.Length];
            var indices = new int[count * faces.Length];
            for (int i = 0; i < count; i++)
            {
                Vector3 center = (Vector3)positions[i * step].xyz;
                for (int k = 0; k < Corners; k++)
                {
                    corners[i * Corners + k] = center + Radius * directions[k];
                    normals[i * Corners + k] = directions[k];
                }
                for (int k = 0; k < faces.Length; k++)
                    indices[i * faces.Length + k] = i * Corners + faces[k];
            }
            var mesh = new Mesh { name = "Rill.VolumePreview", hideFlags = HideFlags.HideAndDontSave, indexFormat = IndexFormat.UInt32 };
            mesh.vertices = corners;
            mesh.normals = normals;
            mesh.triangles = indices;
            return mesh;
        }
    }
}
