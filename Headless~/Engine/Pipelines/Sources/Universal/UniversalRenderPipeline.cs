using System.Collections.Generic;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Headless;
#if SRP_17
using UnityEngine.Rendering.RenderGraphModule;
#endif

namespace UnityEngine.Rendering.Universal
{
    /// <summary>
    /// Cameras one after the other, overlay cameras with the base camera that stacks them; in each the steps of RenderSingleCamera.
    /// Read in URP 17.1.0, Runtime/UniversalRenderPipeline.cs (RenderCameraStack, RenderSingleCamera), the same in 14.
    /// </summary>
    public class UniversalRenderPipeline : RenderPipeline
    {
        readonly UniversalRenderPipelineAsset settings;

        public UniversalRenderPipeline(UniversalRenderPipelineAsset asset)
        {
            settings = asset;
            Shader.globalRenderPipeline = "UniversalPipeline";
        }

        public static UniversalRenderPipelineAsset asset => GraphicsSettings.currentRenderPipeline as UniversalRenderPipelineAsset;

        public static bool IsGameCamera(Camera camera) => camera.cameraType == CameraType.Game || camera.cameraType == CameraType.VR;

        /// <summary>Whether passes run by Execute, in version 17.</summary>
        internal static bool IsCompatibilityMode;

#if SRP_17
        [System.Obsolete("Of arrays")]
#endif
#if SRP_17_3
        protected override void Render(ScriptableRenderContext context, Camera[] cameras) => Render(context, new List<Camera>(cameras));
#else
        protected override void Render(ScriptableRenderContext renderContext, Camera[] cameras) => Render(renderContext, new List<Camera>(cameras));
#endif

        protected override void Render(ScriptableRenderContext renderContext, List<Camera> cameras)
        {
            BeginContextRendering(renderContext, cameras);
            foreach (Camera camera in cameras)
                if (IsGameCamera(camera))
                    RenderStack(renderContext, camera);
                else
                    RenderOne(renderContext, camera, camera, XRPass.Empty, true);
            EndContextRendering(renderContext, cameras);
        }

        void RenderStack(ScriptableRenderContext context, Camera baseCamera)
        {
            baseCamera.TryGetComponent(out UniversalAdditionalCameraData data);
            if (data != null && data.renderType == CameraRenderType.Overlay)
                return;
            var overlays = new List<Camera>();
            foreach (Camera camera in data != null ? data.cameraStack : new List<Camera>())
                if (camera != null && camera.isActiveAndEnabled && camera.TryGetComponent(out UniversalAdditionalCameraData own)
                    && own.renderType == CameraRenderType.Overlay)
                    overlays.Add(camera);
            // The eyes are known before a camera begins, and are those of the base camera in the whole stack.
            XRPass[] passes = XRPass.AllOf(baseCamera, data == null || data.allowXRRendering);
            foreach (XRPass xr in passes)
            {
                RenderOne(context, baseCamera, baseCamera, xr, overlays.Count == 0);
                for (int i = 0; i < overlays.Count; i++)
                    RenderOne(context, overlays[i], baseCamera, xr, i == overlays.Count - 1);
            }
            if (passes[0].enabled)
                StereoView.Show();
        }

        /// <summary>Draws also in another camera's callbacks, and without events for this one (14.0 and 17: RenderSingleCameraInternal).</summary>
#if SRP_17
        [System.Obsolete("RenderSingleCamera is obsolete, please use RenderPipeline.SubmitRenderRequest with " +
        "UniversalRenderer.SingleCameraRequest as RequestData type")]
#else
        [System.Obsolete("RenderSingleCamera is obsolete, please use RenderPipeline.SubmitRenderRequest with " +
        "UniversalRenderer.SingleCameraRequest as RequestData type", false)]
#endif
        public static void RenderSingleCamera(ScriptableRenderContext context, Camera camera) =>
            ((UniversalRenderPipeline)RenderPipelineManager.currentPipeline).RenderSingleCamera(context, camera, camera, XRPass.Empty, true);

        void RenderOne(ScriptableRenderContext context, Camera camera, Camera baseCamera, XRPass xr, bool isLast)
        {
            BeginCameraRendering(context, camera);
            RenderSingleCamera(context, camera, baseCamera, xr, isLast);
            EndCameraRendering(context, camera);
        }

        /// <summary>Those of scene views are the asset's.</summary>
        ScriptableRenderer RendererOf(Camera camera)
        {
            camera.TryGetComponent(out UniversalAdditionalCameraData data);
            ScriptableRenderer own = data != null ? data.scriptableRenderer : null;
            return own == null || camera.cameraType == CameraType.SceneView ? settings.scriptableRenderer : own;
        }

        void RenderSingleCamera(ScriptableRenderContext context, Camera camera, Camera baseCamera, XRPass xr, bool isLast)
        {
            if (!(RendererOf(camera) is UniversalRenderer renderer))
            {
                Debug.LogWarning($"Trying to render {camera.name} with an invalid renderer. Camera rendering will be skipped.");
                return;
            }
            // Not culled: what listeners enqueued stays in the renderer's queue.
            if (!TryCull(camera))
                return;
            try
            {
                renderer.OnPreCullRenderPasses(camera);
                FrameRenderer.Cull(camera);
                renderer.Render(context, settings, camera, baseCamera, baseCamera == camera ? renderer
                    : RendererOf(baseCamera) as UniversalRenderer, xr, isLast);
            }
            finally
            {
                xr.StopSinglePass();
                FrameRenderer.EndCulled();
                Gpu.ClosePass();
                RenderState.SetCameraTarget(null);
                RenderState.SetTarget(null);
            }
        }

        // Camera.TryGetCullingParameters refuses an empty viewport and planes that make no frustum.
        static bool TryCull(Camera camera) => camera.pixelWidth > 0 && camera.pixelHeight > 0 && camera.farClipPlane > camera.nearClipPlane;

        protected override void Dispose(bool disposing)
        {
            settings.DestroyRenderers();
            CommandBufferPool.Reset();
            Shader.globalRenderPipeline = "";
        }
    }
}
