using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>A mesh that deforms, as it is posed now: of a Skinned Mesh Renderer by its bones, of a Mesh Filter by one bone and by what
    /// scripts make of its vertices.</summary>
    /// <remarks>Which triangles there are, and which side they face, is looked at once. After that only bones, and of a Mesh Filter the
    /// vertices, are looked at. Lengths in m, in the frame of the root bone or the object, without its scale.</remarks>
    sealed class DeformedMesh
    {
        const float MinWeight = 0.01f;          // of what counts for the box around a bone's vertices
        const float SameTurn = 1e-5f;           // what a matrix may change by without a new bake

        readonly SkinnedMeshRenderer skin;
        readonly Transform own, frame;
        readonly Mesh source;
        readonly Transform[] bones;
        readonly Matrix4x4[] bindposes;
        readonly Bounds[] boxes;        // around the vertices of each bone, in the frame that its matrix starts from
        readonly bool[] carries;
        readonly uint[] order;
        readonly bool[] turned;
        readonly TriangleMesh triangles;
        readonly List<Vector3> vertices = new List<Vector3>(), seen = new List<Vector3>();
        readonly float4[] rows, baked;
        readonly bool turnAll;

        DeformedMesh(Component owner, SkinnedMeshRenderer skin, Mesh mesh, MeshSdfSign sign)
        {
            this.skin = skin;
            own = owner.transform;
            frame = skin != null && skin.rootBone != null ? skin.rootBone : own;
            source = mesh;
            triangles = TriangleMesh.Of(mesh);
            var taken = new BakedTriangles(triangles);
            if (MeshReport.ProblemOf(taken) is string problem)
                throw new ArgumentException(problem);
            var edges = new MeshEdges(taken);
            order = TriangleOrder.Of(taken);
            turned = edges.Turned;
            IsShell = (sign == MeshSdfSign.Automatic ? MeshReport.SignOf(edges) : sign) == MeshSdfSign.OpenShell;
            turnAll = edges.SignedVolume < 0;

            bones = skin != null ? skin.bones : new[] { own };
            bindposes = skin != null ? mesh.bindposes : new[] { Matrix4x4.identity };
            mesh.GetVertices(vertices);
            Rest = vertices;
            Bones = skin != null ? Array.ConvertAll(mesh.boneWeights, Weights) : AllOnFirst(vertices.Count);
            boxes = new Bounds[bones.Length];
            carries = new bool[bones.Length];
            for (int i = 0; i < vertices.Count; i++)
                for (int k = 0; k < 4; k++)
                    if (Bones[i].weights[k] >= MinWeight)
                        Include((int)Bones[i].bones[k], vertices[i]);
            rows = new float4[3 * bones.Length];
            baked = new float4[rows.Length];
            FollowBones();
        }

        /// <param name="problem">Why there is none; null where there is.</param>
        public static DeformedMesh Of(Component owner, MeshSdfSign sign, out string problem)
        {
            problem = ProblemOf(owner);
            if (problem != null)
                return null;
            Mesh mesh = owner.TryGetComponent(out SkinnedMeshRenderer skin) ? skin.sharedMesh : owner.GetComponent<MeshFilter>().sharedMesh;
            try
            {
                return new DeformedMesh(owner, skin, mesh, sign);
            }
            catch (ArgumentException refused)
            {
                problem = refused.Message;
                return null;
            }
        }

        /// <summary>Returns why no mesh can be read; null if one can.</summary>
        public static string ProblemOf(Component owner)
        {
            if (owner.TryGetComponent(out SkinnedMeshRenderer skin))
                return SkinProblems.Of(skin, skin.bones);
            if (!owner.TryGetComponent(out MeshFilter filter) || filter.sharedMesh == null)
                return "it has no Skinned Mesh Renderer and no Mesh Filter with a mesh. Add one of them.";
            return filter.sharedMesh.isReadable ? null : SkinProblems.NotReadable(filter.sharedMesh);
        }

        public bool IsShell { get; }

        public int VertexCount => Bones.Length;

        /// <summary>Number of triangles that take part.</summary>
        public int TriangleCount => order.Length;

        /// <summary>Before bones act on them, m.</summary>
        public List<Vector3> Rest { get; }

        /// <summary>Whether scripts change these.</summary>
        public bool RestChanges => skin == null;

        public DeformingField.VertexBones[] Bones { get; }

        /// <summary>Three rows of the matrix from the rest to the frame, for each bone.</summary>
        public float4[] Rows => rows;

        /// <summary>Whether the pose shows it in a mirror: by the first bone that carries anything.</summary>
        public bool IsMirrored { get; private set; }

        /// <summary>Around the mesh as it is posed now, m; somewhat more than it takes.</summary>
        public Bounds Bounds { get; private set; }

        /// <summary>Position and orientation of the frame now, world space, m.</summary>
        public RigidPose Pose => new RigidPose(frame.position, frame.rotation);

        /// <summary>Reason why this is not a valid mesh any more; null while it is.</summary>
        public string Problem
        {
            get
            {
                if (own == null || frame == null || source == null || skin != null && skin.sharedMesh != source)
                    return "its mesh or its root bone is another one now. Call Refresh.";
                return skin != null || source.vertexCount == VertexCount ? null : Invariant($"its mesh has {source.vertexCount} ") +
                    Invariant($"vertices now and had {VertexCount}. Call Refresh after a change of its triangles.");
            }
        }

        /// <summary>Looks where its bones and vertices are now.</summary>
        /// <param name="tolerance">By which a position may change without a new bake, m.</param>
        /// <returns>Whether they are elsewhere than when it was baked last.</returns>
        public bool Follow(float tolerance)
        {
            bool moved = skin == null && FollowVertices(tolerance);
            FollowBones();
            return moved || Differs(tolerance);
        }

        /// <summary>Bakes the current pose.</summary>
        public void Bake()
        {
            rows.CopyTo(baked, 0);
            if (skin != null)
                return;
            seen.Clear();
            seen.AddRange(vertices);
        }

        /// <summary>The triangles for a grid. None is large: what is small now may grow.</summary>
        public BakeGeometry GeometryFor(in SdfGrid grid)
            => new BakeGeometry(triangles, (uint[])order.Clone(), turned, grid, !IsShell && turnAll, splitsLarge: false);

        void FollowBones()
        {
            RigidPose pose = Pose;
            Matrix4x4 toFrame = Matrix4x4.TRS(pose.position, pose.rotation, Vector3.one).inverse;
            float3 low = float.PositiveInfinity, high = float.NegativeInfinity;
            bool isFirst = true;
            for (int i = 0; i < bones.Length; i++)
            {
                Matrix4x4 matrix = bones[i] == null ? toFrame * own.localToWorldMatrix
                    : toFrame * bones[i].localToWorldMatrix * (i < bindposes.Length ? bindposes[i] : Matrix4x4.identity);
                for (int row = 0; row < 3; row++)
                    rows[3 * i + row] = matrix.GetRow(row);
                if (!carries[i])
                    continue;
                Include(matrix, boxes[i], ref low, ref high);
                if (isFirst)
                    IsMirrored = math.dot(rows[3 * i].xyz, math.cross(rows[3 * i + 1].xyz, rows[3 * i + 2].xyz)) < 0f;
                isFirst = false;
            }
            var bounds = new Bounds();
            bounds.SetMinMax(low, high);
            Bounds = bounds;
        }

        bool Differs(float tolerance)
        {
            for (int i = 0; i < rows.Length; i++)
            {
                float4 change = math.abs(rows[i] - baked[i]);
                if (!(math.cmax(change.xyz) <= SameTurn && change.w <= tolerance))
                    return true;
            }
            return false;
        }

        // Their box, by which FollowBones then finds that of the mesh, is found in the same round.
        bool FollowVertices(float tolerance)
        {
            source.GetVertices(vertices);
            bool moved = seen.Count != vertices.Count;
            float3 low = float.PositiveInfinity, high = float.NegativeInfinity;
            for (int i = 0; i < vertices.Count; i++)
            {
                float3 vertex = vertices[i];
                bool isFinite = math.all(math.isfinite(vertex));
                if (!moved)
                    moved = isFinite ? !(math.cmax(math.abs(vertex - (float3)seen[i])) <= tolerance)
                        : math.all(math.isfinite((float3)seen[i]));
                if (!isFinite)
                    continue;
                low = math.min(low, vertex);
                high = math.max(high, vertex);
            }
            if (math.all(low <= high))
                boxes[0].SetMinMax(low, high);
            return moved;
        }

        static void Include(in Matrix4x4 matrix, in Bounds box, ref float3 low, ref float3 high)
        {
            float3 center = matrix.MultiplyPoint3x4(box.center), extents = box.extents;
            float3 reach = math.abs((float3)(Vector3)matrix.GetColumn(0)) * extents.x
                + math.abs((float3)(Vector3)matrix.GetColumn(1)) * extents.y + math.abs((float3)(Vector3)matrix.GetColumn(2)) * extents.z;
            if (!math.all(math.isfinite(center + reach)))
                return;
            low = math.min(low, center - reach);
            high = math.max(high, center + reach);
        }

        void Include(int bone, Vector3 vertex)
        {
            if (bone >= boxes.Length || !math.all(math.isfinite((float3)vertex)))
                return;
            if (carries[bone])
                boxes[bone].Encapsulate(vertex);
            else
                boxes[bone] = new Bounds(vertex, Vector3.zero);
            carries[bone] = true;
        }

        static DeformingField.VertexBones Weights(BoneWeight of)
        {
            var weights = new float4(of.weight0, of.weight1, of.weight2, of.weight3);
            return new DeformingField.VertexBones
            {
                bones = new uint4((uint)of.boneIndex0, (uint)of.boneIndex1, (uint)of.boneIndex2, (uint)of.boneIndex3),
                weights = weights / math.max(math.csum(weights), 1e-6f),
            };
        }

        static DeformingField.VertexBones[] AllOnFirst(int count)
        {
            var all = new DeformingField.VertexBones[count];
            for (int i = 0; i < count; i++)
                all[i].weights.x = 1f;
            return all;
        }
    }
}
