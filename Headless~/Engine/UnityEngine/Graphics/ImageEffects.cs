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

        /// <summary>Whether a script beside the camera has one.</summary>
        public static bool Has(Camera camera)
        {
            foreach (Component component in camera.gameObject.Components)
                if (component is MonoBehaviour script && script.isActiveAndEnabled && Method(script.GetType()) is object)
                    return true;
            return false;
        }

        static MethodInfo Method(Type type)
        {
            if (!methods.TryGetValue(type, out MethodInfo method))
                methods.Add(type, method = Messages.Find(type, "OnRenderImage", typeof(RenderTexture), typeof(RenderTexture)));
            return method;
        }
    }
}
