using System;
using System.Collections.Generic;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace UnityEngine
{
    public class Renderer : Component
    {
        static readonly List<Renderer> active = new List<Renderer>();
        internal static IReadOnlyList<Renderer> Active => active;

        Material[] shared = Array.Empty<Material>();
        bool[] instanced = Array.Empty<bool>();
        bool isEnabled = true;
        readonly MaterialPropertyBlock block = new MaterialPropertyBlock();
        Bounds? explicitBounds, explicitLocalBounds;

        internal override bool WantsActive => isEnabled;
        internal override void OnActivated() => active.Add(this);
        internal override void OnDeactivated() => active.Remove(this);
        internal override void ReleaseNative() => active.Remove(this);

        internal override void OnCopied(Component source)
        {
            var other = (Renderer)source;
            shared = (Material[])other.shared.Clone();
            instanced = new bool[shared.Length];
            isEnabled = other.isEnabled;
        }

        public bool enabled
        {
            get => isEnabled;
            set
            {
                isEnabled = value;
                Lifecycle.Refresh(this);
            }
        }

        internal virtual Mesh MeshToDraw => null;
        internal PropertyTable Block => block.isEmpty ? null : block.Values;

        public bool isVisible => active.Contains(this);
        public bool forceRenderingOff { get; set; }
        public ShadowCastingMode shadowCastingMode { get; set; } = ShadowCastingMode.On;
        public bool receiveShadows { get; set; } = true;
        public LightProbeUsage lightProbeUsage { get; set; } = LightProbeUsage.BlendProbes;
        public ReflectionProbeUsage reflectionProbeUsage { get; set; } = ReflectionProbeUsage.BlendProbes;
        public MotionVectorGenerationMode motionVectorGenerationMode { get; set; } = MotionVectorGenerationMode.Object;
        public uint renderingLayerMask { get; set; } = 1;
        public int rendererPriority { get; set; }
        public int sortingOrder { get; set; }
        public int sortingLayerID { get; set; }
        public string sortingLayerName { get; set; } = "Default";
        public bool allowOcclusionWhenDynamic { get; set; } = true;
        public bool staticShadowCaster { get; set; }
        public int lightmapIndex { get; set; } = -1;
        public Vector4 lightmapScaleOffset { get; set; } = new Vector4(1, 1, 0, 0);
        public Transform probeAnchor { get; set; }

        internal virtual Matrix4x4 LocalToWorld => transform.localToWorldMatrix;
        internal virtual Bounds OwnBounds => MeshToDraw != null ? MeshToDraw.bounds : default;

        public Matrix4x4 localToWorldMatrix => LocalToWorld;
        public Matrix4x4 worldToLocalMatrix => LocalToWorld.inverse;
        public Bounds localBounds { get => explicitLocalBounds ?? OwnBounds;
            set => explicitLocalBounds = value; }
        public Bounds bounds { get => explicitBounds ?? Culling.Transform(localBounds, localToWorldMatrix); set => explicitBounds = value; }
        public void ResetBounds() => explicitBounds = null;
        public void ResetLocalBounds() => explicitLocalBounds = null;

        public Material sharedMaterial { get => shared.Length > 0 ? shared[0] : null;
            set { if (shared.Length == 0) sharedMaterials = new[] { value }; else SetShared(0, value); } }
        public Material[] sharedMaterials
        {
            get => (Material[])shared.Clone();
            set
            {
                shared = (Material[])(value ?? Array.Empty<Material>()).Clone();
                instanced = new bool[shared.Length];
            }
        }

        void SetShared(int index, Material material)
        {
            shared[index] = material;
            instanced[index] = false;
        }

        /// <summary>A copy of its own, made at the first access.</summary>
        Material Own(int index)
        {
            if (!instanced[index] && shared[index] != null)
            {
                string original = shared[index].name;
                shared[index] = new Material(shared[index]) { name = original + " (Instance)" };
                instanced[index] = true;
            }
            return shared[index];
        }

        public Material material
        {
            get => shared.Length > 0 ? Own(0) : null;
            set => sharedMaterial = value;
        }

        public Material[] materials
        {
            get
            {
                for (int i = 0; i < shared.Length; i++)
                    Own(i);
                return (Material[])shared.Clone();
            }
            set => sharedMaterials = value;
        }

        public void GetMaterials(List<Material> m) { m.Clear(); m.AddRange(materials); }
        public void GetSharedMaterials(List<Material> m) { m.Clear(); m.AddRange(shared); }
        public void SetMaterials(List<Material> materials) => sharedMaterials = materials.ToArray();
        public void SetSharedMaterials(List<Material> materials) => sharedMaterials = materials.ToArray();

        public bool HasPropertyBlock() => !block.isEmpty;

        public void SetPropertyBlock(MaterialPropertyBlock properties)
        {
            block.Clear();
            if (properties != null)
                block.Values.CopyFrom(properties.Values);
        }

        public void GetPropertyBlock(MaterialPropertyBlock properties)
        {
            properties.Clear();
            properties.Values.CopyFrom(block.Values);
        }

        internal Material MaterialFor(int submesh) => shared.Length == 0 ? null : shared[Math.Min(submesh, shared.Length - 1)];
        internal int MaterialCount => shared.Length;
    }
}
