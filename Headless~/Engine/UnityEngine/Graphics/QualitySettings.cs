using System;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace UnityEngine
{
    public sealed class QualitySettings : Object
    {
        QualitySettings() { }

        public static ColorSpace activeColorSpace => Player.LinearColorSpace ? ColorSpace.Linear : ColorSpace.Gamma;
        public static ColorSpace desiredColorSpace => activeColorSpace;
        public static int vSyncCount { get; set; }
        public static int antiAliasing { get; set; }
        public static int pixelLightCount { get; set; } = 4;
        public static int maxQueuedFrames { get; set; } = 2;
        public static float lodBias { get; set; } = 2;
        public static int maximumLODLevel { get; set; }
        public static ShadowQuality shadows { get; set; } = ShadowQuality.All;
        public static ShadowResolution shadowResolution { get; set; } = ShadowResolution.High;
        public static float shadowDistance { get; set; } = 150;
        public static int shadowCascades { get; set; } = 4;
        public static ShadowProjection shadowProjection { get; set; } = ShadowProjection.StableFit;
        public static bool softParticles { get; set; }
        public static bool realtimeReflectionProbes { get; set; }
        public static bool billboardsFaceCameraPosition { get; set; }
        public static int particleRaycastBudget { get; set; } = 4096;
        public static int globalTextureMipmapLimit { get; set; }
        public static AnisotropicFiltering anisotropicFiltering { get => Texture.anisotropicFiltering; set => Texture.anisotropicFiltering = value; }
        public static RenderPipelineAsset renderPipeline { get; set; }

        static int level;
        public static string[] names => new[] { "Headless" };
        public static int count => 1;
        public static int GetQualityLevel() => level;
        public static void SetQualityLevel(int index) => SetQualityLevel(index, true);
        public static void SetQualityLevel(int index, bool applyExpensiveChanges) => level = Math.Max(0, Math.Min(index, count - 1));
    }
}
