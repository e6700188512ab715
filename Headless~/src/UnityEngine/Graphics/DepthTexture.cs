using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace UnityEngine.Headless
{
    /// <summary>_CameraDepthTexture: the camera's depth after its opaque draws. (Unity draws it beforehand, from the same objects.)</summary>
    internal static class DepthTexture
    {
        static readonly int cameraDepth = Shader.PropertyToID("_CameraDepthTexture"), lastCameraDepth = Shader.PropertyToID("_LastCameraDepthTexture");
        static RenderTexture texture;

        public static void Capture(Camera camera, RenderTexture target)
        {
            RenderTexture source = target is object ? target : ScreenTarget.Texture;
            if ((camera.depthTextureMode & (DepthTextureMode.Depth | DepthTextureMode.DepthNormals)) == 0 || source.DepthTexture == null)
                return;
            if (texture is object && (texture.width != source.width || texture.height != source.height || texture.depthStencilFormat != source.depthStencilFormat))
                Forget();
            if (texture is null)
            {
                texture = new RenderTexture(source.width, source.height, GraphicsFormat.None, source.depthStencilFormat) { name = "Camera depth", filterMode = FilterMode.Point, IsBuiltIn = true, hideFlags = HideFlags.HideAndDontSave };
                texture.Create();
            }
            Gpu.Device.CopyTexture(source.DepthTexture, texture.DepthTexture);
            Shader.Globals.SetTexture(cameraDepth, texture, RenderTextureSubElement.Depth);
            Shader.Globals.SetTexture(lastCameraDepth, texture, RenderTextureSubElement.Depth);
        }

        public static void Forget()
        {
            if (texture is object)
                Object.DestroyImmediate(texture, true);
            texture = null;
        }
    }
}
