using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>The vertices of a skinned mesh by the bone that carries them, in the bone's own frame.</summary>
    sealed class BonePoints
    {
        readonly List<int>[] vertices;
        readonly Vector3[] positions;
        readonly Matrix4x4[] bindposes;
        readonly float[] areas;

        /// <param name="mesh">Readable, with a weight for each vertex.</param>
        /// <param name="bones">How many the renderer has.</param>
        /// <param name="minWeight">Weight from which a vertex belongs to a bone; it can belong to several.</param>
        public BonePoints(Mesh mesh, int bones, float minWeight)
        {
            positions = mesh.vertices;
            bindposes = mesh.bindposes;
            areas = Areas(mesh.triangles, positions);
            vertices = new List<int>[math.min(bones, bindposes.Length)];
            BoneWeight[] weights = mesh.boneWeights;
            for (int i = 0; i < weights.Length; i++)
            {
                BoneWeight weight = weights[i];
                Add(i, weight.boneIndex0, weight.weight0, minWeight);
                Add(i, weight.boneIndex1, weight.weight1, minWeight);
                Add(i, weight.boneIndex2, weight.weight2, minWeight);
                Add(i, weight.boneIndex3, weight.weight3, minWeight);
            }
        }

        /// <summary>Vertices that a bone carries.</summary>
        public int Count(int bone) => bone < vertices.Length && vertices[bone] != null ? vertices[bone].Count : 0;

        /// <param name="bone">That carries some.</param>
        /// <param name="area">A third of the triangles around each, in any unit.</param>
        /// <returns>In the bone's frame.</returns>
        public float3[] Of(int bone, out float[] area)
        {
            List<int> own = vertices[bone];
            var points = new float3[own.Count];
            area = new float[own.Count];
            for (int i = 0; i < points.Length; i++)
            {
                points[i] = bindposes[bone].MultiplyPoint3x4(positions[own[i]]);
                area[i] = areas[own[i]];
            }
            return points;
        }

        void Add(int vertex, int bone, float weight, float minWeight)
        {
            if (weight < minWeight || weight <= 0f || bone >= vertices.Length || !math.all(math.isfinite((float3)positions[vertex])))
                return;
            (vertices[bone] ??= new List<int>()).Add(vertex);
        }

        // Dense parts of a mesh, such as fingernails, count for no more than their size.
        static float[] Areas(int[] triangles, Vector3[] positions)
        {
            var areas = new float[positions.Length];
            for (int i = 0; i + 2 < triangles.Length; i += 3)
            {
                float3 a = positions[triangles[i]], b = positions[triangles[i + 1]], c = positions[triangles[i + 2]];
                float third = math.length(math.cross(b - a, c - a)) / 6f;
                for (int k = 0; k < 3 && third < float.PositiveInfinity; k++)
                    areas[triangles[i + k]] += third;
            }
            for (int i = 0; i < areas.Length; i++)
                areas[i] = math.max(areas[i], 1e-12f);      // of no triangle, or of none with an area
            return areas;
        }
    }
}
