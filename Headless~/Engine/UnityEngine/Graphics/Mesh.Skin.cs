using System;
using System.Collections.Generic;

namespace UnityEngine
{
    /// <summary>The bones that a vertex follows, and how much.</summary>
    public struct BoneWeight : IEquatable<BoneWeight>
    {
        public float weight0 { get; set; }
        public float weight1 { get; set; }
        public float weight2 { get; set; }
        public float weight3 { get; set; }
        public int boneIndex0 { get; set; }
        public int boneIndex1 { get; set; }
        public int boneIndex2 { get; set; }
        public int boneIndex3 { get; set; }

        public bool Equals(BoneWeight other) => (weight0, weight1, weight2, weight3, boneIndex0, boneIndex1, boneIndex2, boneIndex3)
            == (other.weight0, other.weight1, other.weight2, other.weight3, other.boneIndex0, other.boneIndex1, other.boneIndex2, other.boneIndex3);
        public override bool Equals(object other) => other is BoneWeight weight && Equals(weight);
        public override int GetHashCode() => HashCode.Combine(weight0, weight1, weight2, weight3, boneIndex0, boneIndex1, boneIndex2, boneIndex3);
        public static bool operator ==(BoneWeight lhs, BoneWeight rhs) => lhs.Equals(rhs);
        public static bool operator !=(BoneWeight lhs, BoneWeight rhs) => !lhs.Equals(rhs);
    }

    // Data that a skinned mesh follows.
    public sealed partial class Mesh
    {
        BoneWeight[] weightData = Array.Empty<BoneWeight>();
        Matrix4x4[] bindData = Array.Empty<Matrix4x4>();

        public BoneWeight[] boneWeights
        {
            get => MayAccess("boneWeights") ? (BoneWeight[])weightData.Clone() : Array.Empty<BoneWeight>();
            set
            {
                if (MayAccess("boneWeights"))
                    weightData = Checked(value, "boneWeights");
            }
        }

        public Matrix4x4[] bindposes
        {
            get => MayAccess("bindposes") ? (Matrix4x4[])bindData.Clone() : Array.Empty<Matrix4x4>();
            set
            {
                if (MayAccess("bindposes"))
                    bindData = (Matrix4x4[])(value ?? Array.Empty<Matrix4x4>()).Clone();
            }
        }

        public void GetBoneWeights(List<BoneWeight> boneWeights)
            => Fill(boneWeights, MayAccess("boneWeights") ? weightData : Array.Empty<BoneWeight>(), w => w);
        public void GetBindposes(List<Matrix4x4> bindposes)
            => Fill(bindposes, MayAccess("bindposes") ? bindData : Array.Empty<Matrix4x4>(), m => m);
        public int bindposeCount => bindData.Length;

        /// <summary>Whether vertices follow bones at all.</summary>
        internal bool IsSkinned => weightData.Length == positions.Length && weightData.Length > 0;

        /// <summary>Puts the vertices, blended by their bones, into another mesh that is otherwise the same.</summary>
        /// <param name="bones">From the mesh to the frame of the other, by bone, without bind poses.</param>
        internal void Pose(Matrix4x4[] bones, Mesh into)
        {
            var matrices = new Matrix4x4[bones.Length];
            for (int i = 0; i < bones.Length; i++)
                matrices[i] = i < bindData.Length ? bones[i] * bindData[i] : bones[i];
            var posed = new Vector3[positions.Length];
            var turned = new Vector3[normalData.Length];
            for (int i = 0; i < posed.Length; i++)
            {
                BoneWeight w = weightData[i];
                AddBone(matrices, w.boneIndex0, w.weight0, i, posed, turned);
                AddBone(matrices, w.boneIndex1, w.weight1, i, posed, turned);
                AddBone(matrices, w.boneIndex2, w.weight2, i, posed, turned);
                AddBone(matrices, w.boneIndex3, w.weight3, i, posed, turned);
            }
            into.Adopt(this, posed, Array.ConvertAll(turned, n => n.normalized));
        }

        void AddBone(Matrix4x4[] matrices, int bone, float weight, int vertex, Vector3[] posed, Vector3[] turned)
        {
            if (weight == 0f || bone < 0 || bone >= matrices.Length)
                return;
            posed[vertex] += matrices[bone].MultiplyPoint3x4(positions[vertex]) * weight;
            if (turned.Length > 0)
                turned[vertex] += matrices[bone].MultiplyVector(normalData[vertex]) * weight;
        }

        void Adopt(Mesh of, Vector3[] posed, Vector3[] turned)
        {
            (positions, normalData, tangentData, colorData, indexFormat) = (posed, turned, of.tangentData, of.colorData, of.indexFormat);
            Array.Copy(of.uvData, uvData, 8);
            Array.Copy(of.uvSize, uvSize, 8);
            submeshes.Clear();
            submeshes.AddRange(of.submeshes);
            RecalculateBounds();
            Changed();
        }
    }
}
