using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>A round arm along x on two bones, closed and with round ends: a skinned mesh made in code.</summary>
    sealed class SkinnedArm : IDisposable
    {
        public const float Length = 1f, Radius = 0.15f;
        const float Elbow = 0.5f, Blend = 0.12f;

        public readonly GameObject Object;
        public readonly SkinnedMeshRenderer Renderer;
        public readonly Transform Upper, Lower;
        public readonly Mesh Mesh;

        /// <param name="segments">Around the arm.</param>
        public SkinnedArm(int segments = 16, int rings = 24)
        {
            Object = new GameObject("Arm");
            Object.SetActive(false);
            Upper = Bone("Upper", Object.transform, Vector3.zero);
            Lower = Bone("Lower", Upper, new Vector3(Elbow, 0f, 0f));
            Mesh = Tube(segments, rings);
            Mesh.boneWeights = Array.ConvertAll(Mesh.vertices, Weight);
            Mesh.bindposes = new[] { Upper.worldToLocalMatrix, Lower.worldToLocalMatrix };
            Renderer = Object.AddComponent<SkinnedMeshRenderer>();
            Renderer.sharedMesh = Mesh;
            Renderer.bones = new[] { Upper, Lower };
            Renderer.rootBone = Upper;
        }

        /// <summary>Turns the lower arm about z, degrees.</summary>
        public void Bend(float angle) => Lower.localRotation = Quaternion.Euler(0f, 0f, angle);

        /// <summary>The vertices now, world space.</summary>
        public Vector3[] Posed()
        {
            var baked = new Mesh();
            Renderer.BakeMesh(baked, true);
            Vector3[] posed = Array.ConvertAll(baked.vertices, Object.transform.TransformPoint);
            UnityEngine.Object.DestroyImmediate(baked);
            return posed;
        }

        /// <summary>The mesh now, in the frame of the upper bone.</summary>
        public Mesh PosedMesh()
        {
            var posed = new Mesh { name = "Posed arm", vertices = Array.ConvertAll(Posed(), Upper.InverseTransformPoint) };
            posed.triangles = Mesh.triangles;
            return posed;
        }

        public void Dispose()
        {
            UnityEngine.Object.DestroyImmediate(Object);
            UnityEngine.Object.DestroyImmediate(Mesh);
        }

        static Transform Bone(string name, Transform parent, Vector3 position)
        {
            Transform bone = new GameObject(name).transform;
            bone.SetParent(parent, false);
            bone.localPosition = position;
            return bone;
        }

        static BoneWeight Weight(Vector3 vertex)
        {
            float lower = math.smoothstep(Elbow - Blend, Elbow + Blend, vertex.x);
            return new BoneWeight { boneIndex0 = 0, weight0 = 1f - lower, boneIndex1 = 1, weight1 = lower };
        }

        // A capsule from 0 to its length, of rings between two poles.
        static Mesh Tube(int segments, int rings)
        {
            var vertices = new List<Vector3> { Vector3.zero };
            for (int ring = 1; ring < rings; ring++)
            {
                float x = 0.5f * Length * (1f - math.cos(math.PI * ring / rings));
                float off = x - math.clamp(x, Radius, Length - Radius);
                float radius = math.sqrt(math.max(Radius * Radius - off * off, 0f));
                for (int i = 0; i < segments; i++)
                {
                    float angle = 2f * math.PI * i / segments;
                    vertices.Add(new Vector3(x, radius * math.cos(angle), radius * math.sin(angle)));
                }
            }
            vertices.Add(new Vector3(Length, 0f, 0f));
            var triangles = new List<int>();
            int last = vertices.Count - 1;
            for (int i = 0; i < segments; i++)
            {
                int next = (i + 1) % segments;
                triangles.AddRange(new[] { 0, 1 + next, 1 + i });
                for (int ring = 0; ring < rings - 2; ring++)
                {
                    int here = 1 + ring * segments, there = here + segments;
                    triangles.AddRange(new[] { here + i, here + next, there + i, here + next, there + next, there + i });
                }
                int end = last - segments;
                triangles.AddRange(new[] { last, end + i, end + next });
            }
            var mesh = new Mesh { name = "Arm", vertices = vertices.ToArray() };
            mesh.triangles = triangles.ToArray();
            mesh.RecalculateNormals();
            return mesh;
        }
    }
}
