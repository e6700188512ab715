using System;
#if SRP_17
using UnityEngine.Rendering.RenderGraphModule;
#endif

namespace UnityEngine.Rendering.Universal
{
#if SRP_17
    public abstract class ScriptableRenderPass : IRenderGraphRecorder
#else
    public abstract class ScriptableRenderPass
#endif
    {
        public RenderPassEvent renderPassEvent { get; set; } = RenderPassEvent.AfterRenderingOpaques;

        /// <summary>Inputs for which the renderer makes textures that it would not have made.</summary>
        public ScriptableRenderPassInput input { get; private set; }

        public void ConfigureInput(ScriptableRenderPassInput passInput) => input = passInput;

        public virtual void OnCameraCleanup(CommandBuffer cmd) { }

#if SRP_17
        internal const string Compatibility =
            "This rendering path is for compatibility mode only (when Render Graph is disabled). Use Render Graph API instead.";

        public bool requiresIntermediateTexture { get; set; }

        [Obsolete(Compatibility, false)]
        public virtual void OnCameraSetup(CommandBuffer cmd, ref RenderingData renderingData) { }

        [Obsolete(Compatibility, false)]
        public virtual void Execute(ScriptableRenderContext context, ref RenderingData renderingData) =>
            Debug.LogWarning("Execute is not implemented, the pass " + ToString() + " won't be executed in the current render loop.");

        public virtual void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData) =>
            Debug.LogWarning("The render pass " + ToString() + " does not have an implementation of the RecordRenderGraph method. " +
            "Please implement this method, or consider turning on Compatibility Mode (RenderGraph disabled) in the menu Edit > Project " +
            "Settings > Graphics > URP. Otherwise the render pass will have no effect.");
#else
        public virtual void OnCameraSetup(CommandBuffer cmd, ref RenderingData renderingData) { }
        public abstract void Execute(ScriptableRenderContext context, ref RenderingData renderingData);
#endif
    }
}
