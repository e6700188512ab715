using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;
#if RILL_RENDER_GRAPH
using UnityEngine.Rendering.RenderGraphModule;
#endif

namespace Rill.Universal
{
    /// <summary>Fills the textures of the surfaces that one camera sees, between its opaque and its transparent draws.</summary>
    sealed class SurfacePass : CameraPass
    {
        /// <summary>Just before the transparent draws, among which the surface is shaded.</summary>
        public const RenderPassEvent DefaultEvent = RenderPassEvent.BeforeRenderingTransparents;

        public SurfacePass(Camera camera) : base(camera)
        {
            // Depth to measure water in front of the scene, color to see the scene through it: no project setting has to be on.
            ConfigureInput(ScriptableRenderPassInput.Depth | ScriptableRenderPassInput.Color);
        }

        /// <inheritdoc/>
        public override void Prepare(in FluidViews camera, ScriptableRenderer drawing)
        {
            base.Prepare(camera, drawing);
            renderPassEvent = LastEvent;
        }

        /// <summary>Moves it before other passes, for this picture.</summary>
        /// <param name="steps">Before <see cref="DefaultEvent"/>.</param>
        public void MoveBefore(int steps) => renderPassEvent = (RenderPassEvent)Mathf.Min((int)LastEvent, (int)DefaultEvent - steps);

#if RILL_RENDER_GRAPH
        // In Compatibility Mode URP 17 draws motion vectors one step after the sky, and the water's among them: its textures are there by then.
        RenderPassEvent LastEvent => views.needsMotion && UniversalSurfaces.LastPath == UniversalSurfaces.PassPath.Execute
            ? RenderPassEvent.AfterRenderingSkybox : DefaultEvent;
#else
        static RenderPassEvent LastEvent => DefaultEvent;
#endif

        void Record(CommandBuffer cmd)
        {
            for (int i = 0; i < FluidSurface.Active.Count; i++)
                FluidSurface.Active[i].Record(cmd, views);
        }

#if RILL_RENDER_GRAPH
        sealed class PassData
        {
            public SurfacePass pass;
            public TextureHandle motion, motionDepth;
        }

        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
        {
            UniversalCameraData camera = frameData.Get<UniversalCameraData>();
            if (!Begin(camera.camera))
                return;
            UniversalSurfaces.LastPath = UniversalSurfaces.PassPath.Graph;
            SetEyes(camera.xr);
            for (int eye = 0; eye < views.eyes; eye++)
                views.SetEye(eye, camera.GetViewMatrix(eye), camera.GetProjectionMatrix(eye));
            using (IUnsafeRenderGraphBuilder builder = renderGraph.AddUnsafePass("Rill.Surface", out PassData data))
            {
                data.pass = this;
                builder.UseTexture(frameData.Get<UniversalResourceData>().cameraDepthTexture);
                // It writes textures of its own, which the graph does not know.
                builder.AllowPassCulling(false);
                builder.SetRenderFunc((PassData recorded, UnsafeGraphContext context) =>
                    recorded.pass.Record(CommandBufferHelpers.GetNativeCommandBuffer(context.cmd)));
            }
            // URP has drawn its own motion vectors by now.
            TextureHandle motion = frameData.Get<UniversalResourceData>().motionVectorColor;
            if (views.needsMotion && motion.IsValid())
                RecordMotion(renderGraph, motion, frameData.Get<UniversalResourceData>().motionVectorDepth);
        }

        void RecordMotion(RenderGraph renderGraph, TextureHandle motion, TextureHandle motionDepth)
        {
            using (IUnsafeRenderGraphBuilder builder = renderGraph.AddUnsafePass("Rill.Surface.Motion", out PassData data))
            {
                (data.pass, data.motion, data.motionDepth) = (this, motion, motionDepth);
                builder.UseTexture(motion, AccessFlags.Write);
                builder.UseTexture(motionDepth, AccessFlags.Write);
                builder.SetRenderFunc((PassData recorded, UnsafeGraphContext context) =>
                    recorded.pass.DrawMotion(CommandBufferHelpers.GetNativeCommandBuffer(context.cmd), recorded.motion,
                    recorded.motionDepth));
            }
        }

        void DrawMotion(CommandBuffer cmd, RenderTargetIdentifier motion, RenderTargetIdentifier motionDepth)
        {
            cmd.SetRenderTarget(motion, motionDepth, 0, CubemapFace.Unknown, RenderTargetIdentifier.AllDepthSlices);
            for (int i = 0; i < FluidSurface.Active.Count; i++)
                FluidSurface.Active[i].RecordMotion(cmd, views);
        }
#endif

#if !RILL_GRAPH_BY_DEFAULT || URP_COMPATIBILITY_MODE && !RILL_GRAPH_ONLY
        // The path of 2022.3, and of later projects in Compatibility Mode, which URP calls obsolete from 17.0 on.
#pragma warning disable CS0618, CS0672
        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            if (!Begin(renderingData.cameraData.camera))
                return;
            UniversalSurfaces.LastPath = UniversalSurfaces.PassPath.Execute;
            SetEyes(renderingData.cameraData.xr);
            for (int eye = 0; eye < views.eyes; eye++)
                views.SetEye(eye, renderingData.cameraData.GetViewMatrix(eye), renderingData.cameraData.GetProjectionMatrix(eye));
            CommandBuffer cmd = CommandBufferPool.Get("Rill.Surface");
            Record(cmd);
            // URP binds a target only where it differs from the last that it bound itself: the next pass would draw into ours.
            ScriptableRenderer renderer = renderingData.cameraData.renderer;
            RenderTargetIdentifier color = renderer.cameraColorTargetHandle.nameID, depth = renderer.cameraDepthTargetHandle.nameID;
            cmd.SetRenderTarget(color, depth == BuiltinRenderTextureType.CameraTarget ? color : depth, 0, CubemapFace.Unknown,
                RenderTargetIdentifier.AllDepthSlices);
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }
#pragma warning restore CS0618, CS0672
#endif
    }
}
