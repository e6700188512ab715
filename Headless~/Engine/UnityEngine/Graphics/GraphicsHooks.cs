using System.Runtime.CompilerServices;

namespace UnityEngine.Headless
{
    /// <summary>Ties the graphics part into the player loop when the assembly loads.</summary>
    internal static class GraphicsHooks
    {
        [ModuleInitializer]
        internal static void Install()
        {
            PlayerLoop.BeginFrame += BeginFrame;
            PlayerLoop.Render += FrameRenderer.Render;
            PlayerLoop.ResetOthers += Reset;
            Resources.BuiltinResource = BuiltinResources.Find;
            GameObject.PrimitiveFactory = BuiltinResources.CreatePrimitive;
        }

        static void BeginFrame()
        {
            FrameTimes.BeginFrame();
            DrawQueue.BeginFrame();
            BufferStorage.CollectLeaks();
            ReadbackQueue.BeginFrame();
            // Last: a fault found in indirect arguments throws, and must not keep read-backs from arriving.
            GpuChecks.InspectArguments(wait: false);
        }

        static void Reset()
        {
            GpuSamples.Reset();
            FrameTimes.Reset();
            DrawQueue.Clear();
            ReadbackQueue.Reset();
            GpuChecks.Reset();
            Shader.Globals.Clear();
            GlobalKeywords.Set.Replace(System.Array.Empty<string>());
            RenderState.Reset();
            // Unity frees what no one asked for again after some frames: textures in the pool are not leaks.
            RenderTexture.ForgetTemporaries();
        }
    }
}

namespace System.Runtime.CompilerServices
{
    /// <summary>Known to the C# 9 compiler by name; .NET Standard 2.1 lacks it.</summary>
    [AttributeUsage(AttributeTargets.Method, Inherited = false)]
    internal sealed class ModuleInitializerAttribute : Attribute { }
}
