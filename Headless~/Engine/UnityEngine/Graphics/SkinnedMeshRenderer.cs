using System;

namespace UnityEngine
{
    public enum SkinQuality { Auto = 0, Bone1 = 1, Bone2 = 2, Bone4 = 4 }

    /// <summary>Draws a mesh whose vertices follow bones. They are posed on the CPU, when something draws or bakes them.</summary>
    public class SkinnedMeshRenderer : Renderer
    {
        Transform[] boneData = Array.Empty<Transform>();
        Mesh posed;
        int posedFrame = -1;

        public Mesh sharedMesh { get; set; }
        public Transform rootBone { get; set; }
        public SkinQuality quality { get; set; }
        public bool updateWhenOffscreen { get; set; }
        public bool forceMatrixRecalculationPerRender { get; set; }
        public bool skinnedMotionVectors { get; set; } = true;

        public Transform[] bones
        {
            get => (Transform[])boneData.Clone();
            set => boneData = (Transform[])(value ?? Array.Empty<Transform>()).Clone();
        }

        bool IsSkinned => sharedMesh != null && sharedMesh.IsSkinned && boneData.Length > 0;

        // Equals Unity's vertex buffer: relative to the root bone, without its scale.
        internal override Matrix4x4 LocalToWorld => Unscaled(rootBone != null ? rootBone : transform);

        internal override Mesh MeshToDraw
        {
            get
            {
                if (!IsSkinned)
                    return sharedMesh;
                if (posed == null)
                    posed = new Mesh { name = sharedMesh.name, hideFlags = HideFlags.HideAndDontSave, IsAsset = true };
                // Once a frame: what is recorded reads its buffers.
                if (posedFrame != Time.frameCount)
                    Pose(LocalToWorld.inverse, posed);
                posedFrame = Time.frameCount;
                return posed;
            }
        }

        internal override Bounds OwnBounds => sharedMesh != null ? sharedMesh.bounds : default;

        internal override void OnCopied(Component source)
        {
            base.OnCopied(source);
            var other = (SkinnedMeshRenderer)source;
            (sharedMesh, rootBone, boneData, quality) = (other.sharedMesh, other.rootBone, other.bones, other.quality);
        }

        internal override void ReleaseNative()
        {
            base.ReleaseNative();
            if (posed != null)
                DestroyImmediate(posed, true);
        }

        public void BakeMesh(Mesh mesh) => BakeMesh(mesh, false);

        /// <param name="useScale">Whether the vertices are in the object's own frame; else its scale is left in them.</param>
        public void BakeMesh(Mesh mesh, bool useScale)
        {
            if (mesh == null)
                throw new ArgumentNullException(nameof(mesh));
            if (IsSkinned)
                Pose(useScale ? transform.worldToLocalMatrix : Unscaled(transform).inverse, mesh);
        }

        void Pose(Matrix4x4 fromWorld, Mesh into)
        {
            Matrix4x4 own = fromWorld * transform.localToWorldMatrix;
            sharedMesh.Pose(Array.ConvertAll(boneData, bone => bone != null ? fromWorld * bone.localToWorldMatrix : own), into);
        }

        static Matrix4x4 Unscaled(Transform transform) => Matrix4x4.TRS(transform.position, transform.rotation, Vector3.one);
    }
}
