using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Rill.Universal
{
    /// <summary>
    /// Fluid surfaces in the Universal Render Pipeline: as a camera begins, its pass is enqueued and the draw that shades is submitted.
    /// Nothing has to be added to a renderer.
    /// </summary>
    /// <remarks>Overlay cameras of a stack draw no surfaces: the base camera has drawn them.</remarks>
    static class UniversalSurfaces
    {
        // As URP has it: a scale this near to 1 is 1.
        const float ScaleThreshold = 0.05f;

        static SurfacePass pass;

        /// <summary>The one pass, for a feature that moves it.</summary>
        public static SurfacePass Pass => pass;

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
#if UNITY_EDITOR
        [UnityEditor.InitializeOnLoadMethod]
#endif
        static void Listen()
        {
            pass = new SurfacePass();
            RenderPipelineManager.beginCameraRendering -= Begin;
            RenderPipelineManager.beginCameraRendering += Begin;
            RenderPipelineManager.endCameraRendering -= End;
            RenderPipelineManager.endCameraRendering += End;
            RenderSetups.Add(new UniversalSetup());
        }

        static void Begin(ScriptableRenderContext context, Camera camera)
        {
            if (FluidSurface.Active.Count == 0 || camera.cameraType == CameraType.Preview
                || !(UniversalRenderPipeline.asset is UniversalRenderPipelineAsset asset))
                return;
            camera.TryGetComponent(out UniversalAdditionalCameraData data);
            if (data != null && data.renderType == CameraRenderType.Overlay || !(RendererOf(camera, data, asset) is UniversalRenderer renderer))
                return;
            FluidViews views = ViewsOf(camera, data, asset);
            bool any = false;
            for (int i = 0; i < FluidSurface.Active.Count; i++)
            {
                FluidSurface surface = FluidSurface.Active[i];
                if (!surface.Prepare(views))
                    continue;
                surface.Submit(views, null);
                if (views.needsMotion && pass.IsInGraph == false)
                    surface.SubmitMotion(views);
                any = true;
            }
            if (!any)
                return;
            pass.Prepare(views);
            renderer.EnqueuePass(pass);
        }

        static void End(ScriptableRenderContext context, Camera camera) => pass.Invalidate();

        /// <summary>As URP chooses it: the scene view has the asset's. No component is added to a camera that has none.</summary>
        public static ScriptableRenderer RendererOf(Camera camera, UniversalAdditionalCameraData data, UniversalRenderPipelineAsset asset)
        {
            ScriptableRenderer own = data != null && camera.cameraType != CameraType.SceneView ? data.scriptableRenderer : null;
            return own ?? asset.scriptableRenderer;
        }

        static FluidViews ViewsOf(Camera camera, UniversalAdditionalCameraData data, UniversalRenderPipelineAsset asset)
        {
            FluidViews views = FluidViews.Of(camera, data == null || data.allowXRRendering);
            float scale = UniversalRenderPipeline.IsGameCamera(camera) && Mathf.Abs(1f - asset.renderScale) >= ScaleThreshold
                ? asset.renderScale : 1f;
            views.width = Mathf.Max((int)(views.width * scale), 1);
            views.height = Mathf.Max((int)(views.height * scale), 1);
            // URP sets it once it draws motion vectors for the camera, and leaves it.
            views.needsMotion = pass.IsInGraph.HasValue && (camera.depthTextureMode & DepthTextureMode.MotionVectors) != 0;
            return views;
        }
    }
}
