using System;

namespace UnityEngine.Rendering.Universal
{
    /// <summary>Settings with the defaults of a new asset (URP 17.1.0, Runtime/Data/UniversalRenderPipelineAsset.cs): no depth and no
    /// opaque texture, the latter at half size.</summary>
    public class UniversalRenderPipelineAsset : RenderPipelineAsset
    {
        [SerializeField] internal ScriptableRendererData[] m_RendererDataList = Array.Empty<ScriptableRendererData>();

        ScriptableRenderer[] renderers = Array.Empty<ScriptableRenderer>();

        public bool supportsCameraDepthTexture { get; set; }
        public bool supportsCameraOpaqueTexture { get; set; }
        public bool supportsHDR { get; set; } = true;
        public float renderScale { get; set; } = 1;
        public float shadowDistance { get; set; } = 50;
        public Downsampling opaqueDownsampling { get; internal set; } = Downsampling._2xBilinear;
        public UpscalingFilterSelection upscalingFilter { get; set; }

        /// <summary>Renderer of cameras that name none.</summary>
        public ScriptableRenderer scriptableRenderer => GetRenderer(-1);

        /// <summary>Made when it is first asked for, while the pipeline is there.</summary>
        public ScriptableRenderer GetRenderer(int index)
        {
            if (index < 0 || index >= m_RendererDataList.Length)
                index = 0;
            if (renderers.Length != m_RendererDataList.Length)
                DestroyRenderers();
            return renderers[index] ?? (renderers[index] = m_RendererDataList[index].InternalCreate());
        }

        internal void DestroyRenderers()
        {
            foreach (ScriptableRenderer renderer in renderers)
                renderer?.Dispose();
            renderers = new ScriptableRenderer[m_RendererDataList.Length];
        }

        protected override RenderPipeline CreatePipeline()
        {
            if (m_RendererDataList.Length == 0)
                m_RendererDataList = new ScriptableRendererData[] { CreateInstance<UniversalRendererData>() };
            DestroyRenderers();
            return new UniversalRenderPipeline(this);
        }
    }
}
