using System;
using System.Collections.Generic;
using System.Reflection;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace UnityEngine.Headless
{
    /// <summary>OnRenderImage of the scripts beside a camera, each fed with a copy of what the one before left.</summary>
    internal static class ImageEffects
    {
        static readonly Dictionary<Type, MethodInfo> methods = new Dictionary<Type, MethodInfo>();
        static readonly object[] arguments = new object[2];

        public static void Run(Camera camera, RenderTexture target)
        {
            foreach (Component component in camera.gameObject.Components)
            {
                if (!(component is MonoBehaviour script) || !script.isActiveAndEnabled || !(Method(script.GetType()) is MethodInfo method))
                    continue;
                RenderTexture destination = target is object ? target : ScreenTarget.Texture;
                var description = new RenderTextureDescriptor(destination.width, destination.height, destination.graphicsFormat, GraphicsFormat.None);
                RenderTexture source = RenderTexture.GetTemporary(description);
                GraphicsCopies.Texture(destination, source);
                (arguments[0], arguments[1]) = (source, destination);
                try
                {
                    method.Invoke(script, arguments);
                }
                catch (TargetInvocationException e)
                {
                    Debug.LogException(e.InnerException, script);
                }
                RenderTexture.ReleaseTemporary(source);
            }
        }

        static MethodInfo Method(Type type)
        {
            if (!methods.TryGetValue(type, out MethodInfo method))
                methods.Add(type, method = Messages.Find(type, "OnRenderImage", typeof(RenderTexture), typeof(RenderTexture)));
            return method;
        }
    }

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
            if (texture is object && (texture.width != source.width || texture.height != source.height))
                Forget();
            if (texture is null)
            {
                texture = new RenderTexture(source.width, source.height, GraphicsFormat.None, GraphicsFormat.D32_SFloat) { name = "Camera depth", filterMode = FilterMode.Point, hideFlags = HideFlags.HideAndDontSave };
                texture.Create();
                LiveObjects.Remove(texture);    // the engine's own, not a leak of anybody's
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
