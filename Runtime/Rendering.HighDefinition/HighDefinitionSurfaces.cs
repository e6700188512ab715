using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.HighDefinition;

namespace Rill.HighDefinition
{
    /// <summary>
    /// Fluid surfaces, and what they have wetted, in the High Definition Render Pipeline: as a camera begins, its hidden volume is made ready and
    /// the draw that shades is submitted. Nothing has to be added to a scene.
    /// </summary>
    /// <remarks>HDRP begins all cameras of a frame before it draws the first: each has a pass of its own. Reflection probes show no
    /// surfaces.</remarks>
    static class HighDefinitionSurfaces
    {
        static CameraParts<SurfaceVolume> volumes = new CameraParts<SurfaceVolume>();

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
#if UNITY_EDITOR
        [UnityEditor.InitializeOnLoadMethod]
#endif
        static void Listen()
        {
            Reset();
            volumes = new CameraParts<SurfaceVolume>();
            RenderPipelineManager.beginCameraRendering -= Begin;
            RenderPipelineManager.beginCameraRendering += Begin;
            RenderPipelineManager.endCameraRendering -= End;
            RenderPipelineManager.endCameraRendering += End;
            RenderPipelineManager.activeRenderPipelineTypeChanged -= Reset;
            RenderPipelineManager.activeRenderPipelineTypeChanged += Reset;
            RenderSetups.Add(new HighDefinitionSetup());
        }

        /// <summary>Cameras are as they were.</summary>
        public static void Reset() => volumes.Clear();

        static void Begin(ScriptableRenderContext context, Camera camera)
        {
            if (FluidSurface.Active.Count + FluidWetness.Active.Count == 0)
            {
                Reset();
                return;
            }
            if (camera.cameraType == CameraType.Preview || camera.cameraType == CameraType.Reflection
                || !(GraphicsSettings.currentRenderPipeline is HDRenderPipelineAsset))
                return;
            HDCamera seen = HDCamera.GetOrCreate(camera);
            if (!seen.frameSettings.IsEnabled(FrameSettingsField.CustomPass))
                return;
            SurfaceVolume volume = volumes.Find(camera);
            FluidViews views = ViewsOf(seen);
            bool any = false;
            for (int i = 0; i < FluidSurface.Active.Count; i++)
            {
                FluidSurface surface = FluidSurface.Active[i];
                if (!surface.Prepare(views))
                    continue;
                surface.Submit(views, null);
                any = true;
            }
            for (int i = 0; i < FluidWetness.Active.Count; i++)
                any |= FluidWetness.Active[i].Prepare(views);
            if (any && volume == null)
                volumes.Add(volume = new SurfaceVolume(camera));
            if (volume == null)
                return;
            volume.IsOn = any;
            volume.Pass.Prepare(views);
        }

        static void End(ScriptableRenderContext context, Camera camera) => volumes.Find(camera)?.Pass.End();

        // HDRP's textures are as large as the largest camera needs; this camera uses the first texels.
        static FluidViews ViewsOf(HDCamera seen)
        {
            seen.camera.TryGetComponent(out HDAdditionalCameraData data);
            FluidViews views = FluidViews.Of(seen.camera, data == null || data.xrRendering);
            views.width = Mathf.Max(seen.actualWidth, 1);
            views.height = Mathf.Max(seen.actualHeight, 1);
            views.sceneSize = new Vector2(views.width, views.height);
            views.sceneIsArray = TextureXR.useTexArray;
            views.needsMotion = seen.frameSettings.IsEnabled(FrameSettingsField.MotionVectors);
            return views;
        }
    }
}
