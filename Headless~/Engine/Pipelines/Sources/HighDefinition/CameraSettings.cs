using UnityEngine.Experimental.Rendering;

namespace UnityEngine.Rendering.HighDefinition
{
    public enum FrameSettingsField
    {
        None = -1,
        CustomPass = 6,
        MotionVectors = 10,
        Refraction = 13,
    }

    /// <summary>Parts that a camera draws (HDRP 14.0.8, Runtime/RenderPipeline/Settings/FrameSettings.cs): in a new project all these fields are
    /// on.</summary>
    public struct FrameSettings
    {
        uint enabled;

        internal static FrameSettings NewDefault()
        {
            var settings = new FrameSettings();
            settings.SetEnabled(FrameSettingsField.CustomPass, true);
            settings.SetEnabled(FrameSettingsField.MotionVectors, true);
            settings.SetEnabled(FrameSettingsField.Refraction, true);
            return settings;
        }

        public bool IsEnabled(FrameSettingsField field) => (enabled & Bit(field)) != 0;

        public void SetEnabled(FrameSettingsField field, bool value) => enabled = value ? enabled | Bit(field) : enabled & ~Bit(field);

        /// <summary>Turns off what the asset does not support, whatever the camera says (Sanitize).</summary>
        internal void Sanitize(in RenderPipelineSettings supported)
        {
            if (!supported.supportCustomPass)
                SetEnabled(FrameSettingsField.CustomPass, false);
            if (!supported.supportMotionVectors)
                SetEnabled(FrameSettingsField.MotionVectors, false);
        }

        static uint Bit(FrameSettingsField field) => field == FrameSettingsField.None ? 0u : 1u << (int)field;
    }

    /// <summary>Beside a camera that has settings of its own; HDRP draws one that lacks it all the same.</summary>
    public class HDAdditionalCameraData : MonoBehaviour
    {
        public enum AntialiasingMode { None, FastApproximateAntialiasing, TemporalAntialiasing, SubpixelMorphologicalAntiAliasing }

        FrameSettings own = FrameSettings.NewDefault();

        public bool customRenderingSettings;
        public bool xrRendering = true;
        public AntialiasingMode antialiasing;

        // Settings with every field: HDRP has a mask beside them that says which of them count.
        public ref FrameSettings renderingPathCustomFrameSettings => ref own;
    }

    /// <summary>Beside a light of HDRP's own units. One that lacks it is taken for the Built-in pipeline's: the pipeline's own shading
    /// makes π lux of its intensity (HDRP 14.0, Runtime/Lighting/LightLoop/GpuLightsBuilder.Jobs.cs).</summary>
    public class HDAdditionalLightData : MonoBehaviour { }

    /// <summary>A camera as the pipeline sees it. Sizes are those of this frame from before beginCameraRendering on.</summary>
    /// <remarks>HDRP 14.0.8, Runtime/RenderPipeline/Camera/HDCamera.cs (GetOrCreate, Update).</remarks>
    public class HDCamera
    {
        static readonly System.Collections.Generic.Dictionary<(Camera, int), HDCamera> all =
            new System.Collections.Generic.Dictionary<(Camera, int), HDCamera>();

        HDCamera(Camera camera) => this.camera = camera;

        /// <summary>Matrices of the camera; of each eye.</summary>
        internal readonly ViewMatrices main = new ViewMatrices();
        internal readonly ViewMatrices[] eyes = { new ViewMatrices(), new ViewMatrices() };
        internal XRPass xr = XRPass.Empty;
        internal int Slices => System.Math.Max(xr.viewCount, 1);

        public struct ViewConstants
        {
            public Matrix4x4 viewMatrix, projMatrix;
            public Vector3 worldSpaceCameraPos;
        }

        /// <summary>Relative to the camera's position; the projection as the device takes it, with this frame's jitter.</summary>
        public ViewConstants mainViewConstants;

        public Camera camera;
        public FrameSettings frameSettings { get; private set; }
        public int actualWidth { get; private set; }
        public int actualHeight { get; private set; }

        public static HDCamera GetOrCreate(Camera camera, int xrMultipassId = 0)
        {
            if (!all.TryGetValue((camera, xrMultipassId), out HDCamera found))
                all.Add((camera, xrMultipassId), found = new HDCamera(camera));
            return found;
        }

        internal static bool AllowsHeadset(Camera camera) => !camera.TryGetComponent(out HDAdditionalCameraData data) || data.xrRendering;

        internal void Update(in RenderPipelineSettings supported, XRPass pass)
        {
            camera.TryGetComponent(out HDAdditionalCameraData data);
            xr = pass;
            (actualWidth, actualHeight) = xr.enabled ? (xr.renderTargetDesc.width, xr.renderTargetDesc.height)
                : (camera.pixelWidth, camera.pixelHeight);
            // Not with a headset, unless the project asks for it (GetJitteredProjectionMatrix).
            bool isJittered = data != null && data.antialiasing == HDAdditionalCameraData.AntialiasingMode.TemporalAntialiasing && !xr.enabled;
            // Each of two passes is the camera's own view.
            if (xr.enabled && !xr.singlePassEnabled)
                main.Update(xr.GetViewMatrix(), xr.GetProjMatrix(), Matrix4x4.identity, xr.GetViewMatrix().inverse.GetColumn(3));
            else
                main.Update(camera.worldToCameraMatrix, camera.projectionMatrix, isJittered
                    ? Jitter.MatrixOf(Time.frameCount, actualWidth, actualHeight) : Matrix4x4.identity, camera.transform.position);
            mainViewConstants = new ViewConstants { viewMatrix = main.view, projMatrix = main.projection, worldSpaceCameraPos = main.position };
            for (int eye = 0; eye < xr.viewCount; eye++)
                eyes[eye].Update(xr.GetViewMatrix(eye), xr.GetProjMatrix(eye), Matrix4x4.identity, xr.GetViewMatrix(eye).inverse.GetColumn(3));
            FrameSettings settings = data != null && data.customRenderingSettings ? data.renderingPathCustomFrameSettings
                : FrameSettings.NewDefault();
            settings.Sanitize(supported);
            frameSettings = settings;
        }

        internal static void Reset() => all.Clear();
    }
}
