using UnityEngine.Rendering;

namespace UnityEngine
{
    public sealed class RenderSettings : Object
    {
        RenderSettings() { }

        public static AmbientMode ambientMode { get; set; } = AmbientMode.Flat;
        public static Color ambientSkyColor { get; set; } = new Color(0.212f, 0.227f, 0.259f, 1);
        public static Color ambientEquatorColor { get; set; } = new Color(0.114f, 0.125f, 0.133f, 1);
        public static Color ambientGroundColor { get; set; } = new Color(0.047f, 0.043f, 0.035f, 1);
        public static Color ambientLight { get => ambientSkyColor; set => ambientSkyColor = value; }
        public static float ambientIntensity { get; set; } = 1;
        public static bool fog { get; set; }
        public static FogMode fogMode { get; set; } = FogMode.ExponentialSquared;
        public static Color fogColor { get; set; } = new Color(0.5f, 0.5f, 0.5f, 1);
        public static float fogDensity { get; set; } = 0.01f;
        public static float fogStartDistance { get; set; }
        public static float fogEndDistance { get; set; } = 300;
        public static Light sun { get; set; }
        public static Material skybox { get; set; }
        public static float reflectionIntensity { get; set; } = 1;
        public static DefaultReflectionMode defaultReflectionMode { get; set; }
        public static int defaultReflectionResolution { get; set; } = 128;
        public static Texture customReflectionTexture { get; set; }
        public static int reflectionBounces { get; set; } = 1;
        public static Color subtractiveShadowColor { get; set; } = new Color(0.42f, 0.478f, 0.627f, 1);
        public static float haloStrength { get; set; } = 0.5f;
        public static float flareStrength { get; set; } = 1;
        public static float flareFadeSpeed { get; set; } = 3;
    }
}
