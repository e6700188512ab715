using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Rill.Universal
{
    /// <summary>
    /// Fluid surfaces, and what they have wetted, in the Universal Render Pipeline: as a camera begins, the draws that shade are submitted and its
    /// passes are enqueued. Nothing has to be added to a renderer.
    /// </summary>
    /// <remarks>
    /// Overlay cameras of a stack draw no surfaces: the base camera has drawn them.
    /// The cameras of a renderer use one queue, which URP empties when it has drawn one of them. A script that draws another in
    /// beginCameraRendering, as mirrors and portals do by UniversalRenderPipeline.RenderSingleCamera, thus removes this camera's pass
    /// (14.0 to 17.3: ScriptableRenderer.InternalFinishRenderingCommon). What listens last enqueues after that; and a camera that is drawn
    /// without an event, as RenderSingleCamera does it, is seen by <see cref="FluidSurfaceFeature"/> alone.
    /// </remarks>
    static class UniversalSurfaces
    {
        // URP takes a scale this near to 1 as 1.
        const float ScaleThreshold = 0.05f;

        static CameraParts<SurfacePass> passes = new CameraParts<SurfacePass>();
        static CameraParts<WetnessPass> wetPasses = new CameraParts<WetnessPass>();
        static Camera begun;        // the last that URP, or a feature, said it begins
        static bool isUnannouncedKnown;
        static PassPath lastPath;

        /// <summary>How URP runs passes.</summary>
        public enum PassPath { Unknown, Graph, Execute }

        /// <summary>How it last ran one of the package's.</summary>
        public static PassPath LastPath { get => lastPath; set => lastPath = value; }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
#if UNITY_EDITOR
        [UnityEditor.InitializeOnLoadMethod]
#endif
        static void Listen()
        {
            passes = new CameraParts<SurfacePass>();
            wetPasses = new CameraParts<WetnessPass>();
            begun = null;
            isUnannouncedKnown = false;
            lastPath = PassPath.Unknown;
            ListenLast();
            RenderPipelineManager.endCameraRendering -= End;
            RenderPipelineManager.endCameraRendering += End;
            RenderSetups.Add(new UniversalSetup());
        }

        static void ListenLast()
        {
            RenderPipelineManager.beginCameraRendering -= Begin;
            RenderPipelineManager.beginCameraRendering += Begin;
        }

        /// <summary>The camera's pass for the picture that it draws now; null where it sees no surface.</summary>
        public static SurfacePass PassOf(Camera camera) => ReadyOf(passes, camera);

        /// <summary>Has its renderer draw what is wet in the picture that the camera draws now, where anything is.</summary>
        public static void EnqueueWetness(Camera camera) => wetPasses.Find(camera)?.Enqueue();

        static T ReadyOf<T>(CameraParts<T> of, Camera camera) where T : CameraPass
        {
            T pass = of.Find(camera);
            return pass != null && pass.IsReady ? pass : null;
        }

        static void Begin(ScriptableRenderContext context, Camera camera)
        {
            passes.Find(camera)?.Invalidate();
            wetPasses.Find(camera)?.Invalidate();
            Announce(camera);
            PassOf(camera)?.Enqueue();
            EnqueueWetness(camera);
        }

        /// <summary>Before a camera culls: submits what it draws of the surfaces and makes its passes ready, where that was not done.</summary>
        public static void Announce(Camera camera)
        {
            begun = camera;
            if (PassOf(camera) == null && ReadyOf(wetPasses, camera) == null)
                Prepare(camera);
        }

        static void End(ScriptableRenderContext context, Camera camera)
        {
            End(PassOf(camera));
            End(ReadyOf(wetPasses, camera));
            // Passes of the cameras that this one was drawn inside of.
            for (int i = 0; i < passes.Count; i++)
                passes[i].Enqueue();
            for (int i = 0; i < wetPasses.Count; i++)
                wetPasses[i].Enqueue();
        }

        static void End(CameraPass own)
        {
            if (own == null)
                return;
            // Nothing ran it, and it is gone: a camera was drawn after it was enqueued.
            if (!own.IsEnqueued)
                ListenLast();
            own.Invalidate();
        }

        static void Prepare(Camera camera)
        {
            if (FluidSurface.Active.Count + FluidWetness.Active.Count == 0 || camera.cameraType == CameraType.Preview
                || !(UniversalRenderPipeline.asset is UniversalRenderPipelineAsset asset))
                return;
            camera.TryGetComponent(out UniversalAdditionalCameraData data);
            if (data != null && data.renderType == CameraRenderType.Overlay || !(RendererOf(camera, data, asset) is UniversalRenderer renderer))
                return;
            FluidViews views = ViewsOf(camera, data, asset);
            PrepareSurfaces(views, renderer);
            PrepareWetness(views, renderer);
        }

        static void PrepareSurfaces(in FluidViews views, UniversalRenderer renderer)
        {
            bool any = false;
            for (int i = 0; i < FluidSurface.Active.Count; i++)
            {
                FluidSurface surface = FluidSurface.Active[i];
                if (!surface.Prepare(views))
                    continue;
                surface.Submit(views, null);
                if (views.needsMotion && LastPath == PassPath.Execute)
                    surface.SubmitMotion(views);
                any = true;
            }
            if (!any)
                return;
            SurfacePass pass = passes.Find(views.camera);
            if (pass == null)
                passes.Add(pass = new SurfacePass(views.camera));
            pass.Prepare(views, renderer);
        }

        static void PrepareWetness(in FluidViews views, UniversalRenderer renderer)
        {
            bool isAnySeen = false;
            for (int i = 0; i < FluidWetness.Active.Count; i++)
                isAnySeen |= FluidWetness.Active[i].Prepare(views);
            if (!isAnySeen)
                return;
            WetnessPass pass = wetPasses.Find(views.camera);
            if (pass == null)
                wetPasses.Add(pass = new WetnessPass(views.camera));
            pass.Prepare(views, renderer);
        }

        /// <summary>A renderer draws this camera with another's pass in its queue.</summary>
        public static void Notice(Camera camera)
        {
            if (isUnannouncedKnown || ReferenceEquals(camera, begun) || !SeesLayerOfAny(camera))
                return;
            isUnannouncedKnown = true;
            Debug.LogWarning($"Rill: camera '{camera.name}' is drawn by UniversalRenderPipeline.RenderSingleCamera, which URP does not report: " +
                "it shows no fluid surfaces. Add the renderer feature 'Fluid Surface Feature' to its renderer.", camera);
        }

        static bool SeesLayerOfAny(Camera camera)
        {
            bool any = false;
            for (int i = 0; i < FluidSurface.Active.Count; i++)
                any |= (camera.cullingMask & 1 << FluidSurface.Active[i].gameObject.layer) != 0;
            for (int i = 0; i < FluidWetness.Active.Count; i++)
                any |= (camera.cullingMask & 1 << FluidWetness.Active[i].gameObject.layer) != 0;
            return any;
        }

        /// <summary>Returns the renderer that URP chooses: the scene view has the asset's. No component is added to a camera that has none.</summary>
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
            views.needsMotion = LastPath != PassPath.Unknown && (camera.depthTextureMode & DepthTextureMode.MotionVectors) != 0;
            return views;
        }
    }
}
