using System.Collections.Generic;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace UnityEngine.Headless
{
    /// <summary>
    /// _CameraDepthTexture as the Built-in pipeline makes it: drawn before anything else of the camera, in its size in pixels, by the
    /// ShadowCaster pass of each opaque object in view. What has no such pass is not in it. For two eyes in one pass, an array.
    /// </summary>
    internal static class DepthTexture
    {
        static readonly int
            cameraDepth = Shader.PropertyToID("_CameraDepthTexture"), lastCameraDepth = Shader.PropertyToID("_LastCameraDepthTexture"),
            bias = Shader.PropertyToID("unity_LightShadowBias");
        static RenderTexture texture;

        public static bool IsWanted(Camera camera) => (camera.depthTextureMode & DepthTextureMode.Depth) != 0;

        /// <param name="seen">What the camera sees.</param>
        public static void Draw(Camera camera, IReadOnlyList<QueuedDraw> seen)
        {
            bool stereo = camera.stereoEnabled;
            Need(camera.pixelWidth, camera.pixelHeight, stereo ? 2 : 1);
            BuiltinVariables.SetCamera(camera, texture.width, texture.height);
            if (stereo)
                StereoView.SetSinglePass(true, texture);
            else
                RenderState.SetTarget(texture);
            Shader.Globals.SetVector(bias, Vector4.zero);
            RenderState.Clear(true, false, default, 1);
            foreach (QueuedDraw draw in seen)
                if (draw.Call.Material.renderQueue <= FrameRenderer.LastOpaqueQueue)
                    ShadowCasters.Draw(draw);
            if (stereo)
                StereoView.SetSinglePass(false);
            Shader.Globals.SetTexture(cameraDepth, texture, RenderTextureSubElement.Depth);
            Shader.Globals.SetTexture(lastCameraDepth, texture, RenderTextureSubElement.Depth);
        }

        static void Need(int width, int height, int slices)
        {
            if (texture is object && texture.width == width && texture.height == height && texture.volumeDepth == slices)
                return;
            Reset();
            texture = new RenderTexture(new RenderTextureDescriptor(width, height, GraphicsFormat.None, GraphicsFormat.D32_SFloat)
            {
                dimension = slices > 1 ? TextureDimension.Tex2DArray : TextureDimension.Tex2D, volumeDepth = slices,
            })
            {
                name = "Camera depth", filterMode = FilterMode.Point, IsBuiltIn = true, hideFlags = HideFlags.HideAndDontSave,
            };
            texture.Create();
        }

        public static void Reset()
        {
            if (texture is object)
                Object.DestroyImmediate(texture, true);
            texture = null;
        }
    }
}
