using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;
#if RILL_RENDER_GRAPH
using UnityEngine.Rendering.RenderGraphModule;
#endif

namespace Rill.Universal
{
    /// <summary>Fills the textures of the surfaces that one camera sees, between its opaque and its transparent draws.</summary>
    /// <remarks>
    /// Each camera has its own: one may be drawn from inside of another. URP leaves it in the queue of a renderer where a camera was not
    /// culled, and runs it there for whatever camera comes next, so it does its work once, and only for its own.
    /// </remarks>
    sealed class SurfacePass : ScriptableRenderPass, ICameraPart
    {
        /// <summary>Just before the transparent draws, among which the surface is shaded.</summary>
        public const RenderPassEvent DefaultEvent = RenderPassEvent.BeforeRenderingTransparents;

        FluidViews views;
        ScriptableRenderer renderer, queue;     // what draws the camera, and in whose queue it is

        public Camera Camera { get; }
        public bool IsGone => Camera == null;

        /// <summary>Whether the camera's picture is to be recorded yet.</summary>
        public bool IsReady { get; private set; }

        /// <summary>Whether the camera's renderer has it in its queue.</summary>
        public bool IsEnqueued => ReferenceEquals(queue, renderer);

        public SurfacePass(Camera camera)
        {
            Camera = camera;
            // Depth to measure water in front of the scene, color to see the scene through it: no project setting has to be on.
            ConfigureInput(ScriptableRenderPassInput.Depth | ScriptableRenderPassInput.Color);
        }

        /// <summary>For the picture that the camera draws now.</summary>
        public void Prepare(in FluidViews camera, ScriptableRenderer drawing)
        {
            views = camera;
            renderer = drawing;
            IsReady = true;
            renderPassEvent = LastEvent;
        }

        /// <summary>Where it is not in the queue yet.</summary>
        public void Enqueue()
        {
            if (IsEnqueued)
                return;
            queue = renderer;
            renderer.EnqueuePass(this);
        }

        /// <summary>URP empties the queue after this, whichever camera has been drawn.</summary>
        public override void OnCameraCleanup(CommandBuffer cmd) => queue = null;

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

        /// <summary>The camera has been drawn, or has not been culled.</summary>
        public void Invalidate() => IsReady = false;

        public void Dispose() => Invalidate();

        bool Begin(Camera drawn)
        {
            if (!ReferenceEquals(drawn, Camera))
            {
                UniversalSurfaces.Notice(drawn);
                return false;
            }
            bool isReady = IsReady;
            IsReady = false;
            return isReady;
        }

        // In two passes, one after the other, URP draws one eye in each.
        void SetEyes(XRPass xr)
        {
            views.eyes = xr.enabled ? Mathf.Min(xr.viewCount, views.eyes) : 1;
            views.sceneIsArray = xr.singlePassEnabled;
        }

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
