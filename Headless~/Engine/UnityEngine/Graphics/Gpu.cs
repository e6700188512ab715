using System;

namespace UnityEngine.Headless
{
    /// <summary>The device as the engine uses it: closes an open render pass before anything that cannot stand inside one.</summary>
    internal static class Gpu
    {
        static bool passOpen;

        public static bool Available => Player.Device != null && Player.Device.Info.SupportsCompute && !Player.PretendNoCompute;

        /// <summary>For everything but draws.</summary>
        public static IGraphicsDevice Device
        {
            get
            {
                ClosePass();
                return Player.Device ?? throw NoDevice("This call");
            }
        }

        /// <summary>For draws inside the pass opened by <see cref="OpenPass"/>.</summary>
        public static IGraphicsDevice DrawDevice => Player.Device;

        public static void OpenPass(in DeviceTargets targets)
        {
            Device.BeginPass(targets);
            passOpen = true;
        }

        public static bool IsPassOpen => passOpen;

        public static void ClosePass()
        {
            if (!passOpen)
                return;
            passOpen = false;
            Player.Device.EndPass();
        }

        public static InvalidOperationException NoDevice(string what) =>
            new InvalidOperationException($"{what} needs a graphics device, and this player has none (SystemInfo.supportsComputeShaders is false).");

        /// <summary>Throws where this machine has, or pretends to have, no compute shaders.</summary>
        public static void RequireCompute(string what)
        {
            if (!Available)
                throw NoDevice(what);
        }

        /// <summary>Throws without any graphics: textures and drawing need no compute shaders.</summary>
        public static void RequireDevice(string what)
        {
            if (Player.Device == null)
                throw NoDevice(what);
        }

        /// <summary>The largest resource Direct3D 11 allows.</summary>
        public const long MaxResourceBytes = 1L << 31;

        /// <summary>Before the device goes: gives back the engine's own objects on it, and forgets globals and queued draws.</summary>
        public static void Reset()
        {
            passOpen = false;
            GpuSamples.Reset();
            FrameTimes.Reset();
            GlobalKeywords.Set.Replace(Array.Empty<string>());
            Shader.Globals.Clear();
            DeviceObjects.Clear();
            GpuChecks.Reset();
            ReadbackQueue.Reset();
            DrawQueue.Clear();
            RenderState.Reset();
            RenderTexture.ForgetTemporaries();
            BuiltinTextures.Reset();
            ScreenTarget.Reset();
            QuadIndices.Reset();
            Blitter.Reset();
            DepthTexture.Reset();
            ScreenShadows.Reset();
            StereoView.Reset();
            EnvironmentLighting.Reset();
            BuiltinResources.Reset();
        }
    }
}
