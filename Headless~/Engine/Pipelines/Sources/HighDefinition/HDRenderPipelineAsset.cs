namespace UnityEngine.Rendering.HighDefinition
{
    /// <summary>Features that a project supports (HDRP 14.0.8, Runtime/RenderPipeline/Settings/RenderPipelineSettings.cs).</summary>
    public struct RenderPipelineSettings
    {
        public bool supportCustomPass, supportMotionVectors;
    }

    public class HDRenderPipelineAsset : RenderPipelineAsset
    {
        public RenderPipelineSettings currentPlatformRenderPipelineSettings { get; set; } =
            new RenderPipelineSettings { supportCustomPass = true, supportMotionVectors = true };

        protected override RenderPipeline CreatePipeline() => new HDRenderPipeline(this);
    }
}
