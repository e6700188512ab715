using System.Collections.Generic;

namespace UnityEngine.Rendering.Universal
{
    /// <summary>URP 17.1.0, Runtime/UniversalAdditionalCameraData.cs.</summary>
    public class UniversalAdditionalCameraData : MonoBehaviour
    {
        readonly List<Camera> stack = new List<Camera>();
        int index = -1;

        public CameraRenderType renderType { get; set; }
        public AntialiasingMode antialiasing { get; set; }
        public bool renderPostProcessing { get; set; }
        public bool allowXRRendering { get; set; } = true;
        public bool requiresDepthTexture { get; set; }
        public bool requiresColorTexture { get; set; }
        public bool clearDepth { get; internal set; } = true;
        public List<Camera> cameraStack => renderType == CameraRenderType.Base ? stack : null;
        public void SetRenderer(int index) => this.index = index;
        internal readonly MotionMatrices motionVectorsPersistentData = new MotionMatrices();

        public ScriptableRenderer scriptableRenderer => UniversalRenderPipeline.asset?.GetRenderer(index);
    }

    public static class CameraExtensions
    {
        /// <summary>Adds the component where there is none.</summary>
        public static UniversalAdditionalCameraData GetUniversalAdditionalCameraData(this Camera camera) =>
            camera.gameObject.TryGetComponent(out UniversalAdditionalCameraData data) ? data
            : camera.gameObject.AddComponent<UniversalAdditionalCameraData>();
    }
}
