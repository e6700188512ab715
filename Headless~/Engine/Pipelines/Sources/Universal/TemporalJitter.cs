using UnityEngine.Headless;

namespace UnityEngine.Rendering.Universal
{
    /// <summary>Whether a frame's projection is moved for temporal antialiasing. Read in URP 17.1.0, Runtime/TemporalAA.cs.</summary>
    internal static class TemporalJitter
    {
        /// <summary>IsTemporalAAEnabled of the camera's data: no stack, no dynamic resolution, with post processing.</summary>
        public static bool IsOn(Camera camera, UniversalAdditionalCameraData data) =>
            data != null && data.antialiasing == AntialiasingMode.TemporalAntiAliasing && data.renderPostProcessing
            && data.renderType != CameraRenderType.Overlay && data.cameraStack.Count == 0 && !camera.allowDynamicResolution;
    }
}
