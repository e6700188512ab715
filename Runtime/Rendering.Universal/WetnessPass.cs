using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;
#if RILL_RENDER_GRAPH
using UnityEngine.Rendering.RenderGraphModule;
#endif

namespace Rill.Universal
{
    /// <summary>Draws wet surfaces for one camera, between its opaque draws and its sky.</summary>
    sealed class WetnessPass : CameraPass
    {
        public WetnessPass(Camera camera) : base(camera)
        {
            // In a graph the copy of depth comes after the passes of AfterRenderingOpaques (17.0, UniversalRendererRenderGraph.cs).
            renderPassEvent = RenderPassEvent.BeforeRenderingSkybox;
            ConfigureInput(ScriptableRenderPassInput.Depth);
        }

        void Record(CommandBuffer cmd)
        {
            for (int i = 0; i < FluidWetness.Active.Count; i++)
                FluidWetness.Active[i].Record(cmd, views);
        }

#if RILL_RENDER_GRAPH
        sealed class PassData
        {
            public WetnessPass pass;
            public TextureHandle color;
        }

        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
        {
            UniversalCameraData camera = frameData.Get<UniversalCameraData>();
            if (!Begin(camera.camera))
                return;
            SetEyes(camera.xr);
            for (int eye = 0; eye < views.eyes; eye++)
                views.SetEye(eye, camera.GetViewMatrix(eye), camera.GetProjectionMatrix(eye));
            UniversalResourceData resources = frameData.Get<UniversalResourceData>();
            using (IUnsafeRenderGraphBuilder builder = renderGraph.AddUnsafePass("Rill.Wetness", out PassData data))
            {
                (data.pass, data.color) = (this, resources.activeColorTexture);
                builder.UseTexture(resources.cameraDepthTexture);
                builder.UseTexture(data.color, AccessFlags.ReadWrite);
                builder.SetRenderFunc((PassData recorded, UnsafeGraphContext context) =>
                    recorded.pass.Draw(CommandBufferHelpers.GetNativeCommandBuffer(context.cmd), recorded.color));
            }
        }

        void Draw(CommandBuffer cmd, RenderTargetIdentifier color)
        {
            cmd.SetRenderTarget(color, 0, CubemapFace.Unknown, RenderTargetIdentifier.AllDepthSlices);
            Record(cmd);
        }
#endif

#if !RILL_GRAPH_BY_DEFAULT || URP_COMPATIBILITY_MODE && !RILL_GRAPH_ONLY
        // The path of 2022.3, and of later projects in Compatibility Mode, which URP calls obsolete from 17.0 on. URP has bound its targets.
#pragma warning disable CS0618, CS0672
        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            if (!Begin(renderingData.cameraData.camera))
                return;
            SetEyes(renderingData.cameraData.xr);
            for (int eye = 0; eye < views.eyes; eye++)
                views.SetEye(eye, renderingData.cameraData.GetViewMatrix(eye), renderingData.cameraData.GetProjectionMatrix(eye));
            CommandBuffer cmd = CommandBufferPool.Get("Rill.Wetness");
            Record(cmd);
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }
#pragma warning restore CS0618, CS0672
#endif
    }
}
