using UnityEngine.Rendering;

namespace UnityEngine
{
    /// <summary>Common parameters of the Graphics.Render* calls. Without worldBounds a procedural draw is a point at the origin, and culled like
    /// one.</summary>
    public struct RenderParams
    {
        public RenderParams(Material mat)
        {
            this = default;
            material = mat;
            renderingLayerMask = 1;
            shadowCastingMode = ShadowCastingMode.Off;
            lightProbeUsage = LightProbeUsage.Off;
            reflectionProbeUsage = ReflectionProbeUsage.Off;
            motionVectorMode = MotionVectorGenerationMode.Camera;
        }

        public Material material { get; set; }
        public MaterialPropertyBlock matProps { get; set; }
        public Bounds worldBounds { get; set; }
        public Camera camera { get; set; }
        public int layer { get; set; }
        public int rendererPriority { get; set; }
        public uint renderingLayerMask { get; set; }
        public ShadowCastingMode shadowCastingMode { get; set; }
        public bool receiveShadows { get; set; }
        public LightProbeProxyVolume lightProbeProxyVolume { get; set; }
        public LightProbeUsage lightProbeUsage { get; set; }
        public ReflectionProbeUsage reflectionProbeUsage { get; set; }
        public MotionVectorGenerationMode motionVectorMode { get; set; }
    }
}
