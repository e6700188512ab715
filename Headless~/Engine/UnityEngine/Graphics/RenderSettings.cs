using UnityEngine.Rendering;

namespace UnityEngine
{
    public sealed class RenderSettings : Object
    {
        sealed class Values
        {
            public AmbientMode ambientMode = AmbientMode.Flat;
            public Color ambientSkyColor = new Color(0.212f, 0.227f, 0.259f, 1);
            public Color ambientEquatorColor = new Color(0.114f, 0.125f, 0.133f, 1);
            public Color ambientGroundColor = new Color(0.047f, 0.043f, 0.035f, 1);
            public float ambientIntensity = 1;
            public bool fog;
            public FogMode fogMode = FogMode.ExponentialSquared;
            public Color fogColor = new Color(0.5f, 0.5f, 0.5f, 1);
            public float fogDensity = 0.01f;
            public float fogStartDistance;
            public float fogEndDistance = 300;
            public Light sun;
            public Material skybox;
            public float reflectionIntensity = 1;
            public DefaultReflectionMode defaultReflectionMode;
            public int defaultReflectionResolution = 128;
            public Texture customReflectionTexture;
            public int reflectionBounces = 1;
            public Color subtractiveShadowColor = new Color(0.42f, 0.478f, 0.627f, 1);
            public float haloStrength = 0.5f;
            public float flareStrength = 1;
            public float flareFadeSpeed = 3;
        }

        static Values scene = new Values();

        RenderSettings() { }

        public static AmbientMode ambientMode { get => scene.ambientMode; set => scene.ambientMode = value; }
        public static Color ambientSkyColor { get => scene.ambientSkyColor; set => scene.ambientSkyColor = value; }
        public static Color ambientEquatorColor { get => scene.ambientEquatorColor; set => scene.ambientEquatorColor = value; }
        public static Color ambientGroundColor { get => scene.ambientGroundColor; set => scene.ambientGroundColor = value; }
        public static float ambientIntensity { get => scene.ambientIntensity; set => scene.ambientIntensity = value; }
        public static bool fog { get => scene.fog; set => scene.fog = value; }
        public static FogMode fogMode { get => scene.fogMode; set => scene.fogMode = value; }
        public static Color fogColor { get => scene.fogColor; set => scene.fogColor = value; }
        public static float fogDensity { get => scene.fogDensity; set => scene.fogDensity = value; }
        public static float fogStartDistance { get => scene.fogStartDistance; set => scene.fogStartDistance = value; }
        public static float fogEndDistance { get => scene.fogEndDistance; set => scene.fogEndDistance = value; }
        public static Light sun { get => scene.sun; set => scene.sun = value; }
        public static Material skybox { get => scene.skybox; set => scene.skybox = value; }
        public static float reflectionIntensity { get => scene.reflectionIntensity; set => scene.reflectionIntensity = value; }
        public static DefaultReflectionMode defaultReflectionMode { get => scene.defaultReflectionMode; set => scene.defaultReflectionMode = value; }
        public static int defaultReflectionResolution { get => scene.defaultReflectionResolution; set => scene.defaultReflectionResolution = value; }
        public static Texture customReflectionTexture { get => scene.customReflectionTexture; set => scene.customReflectionTexture = value; }
        public static int reflectionBounces { get => scene.reflectionBounces; set => scene.reflectionBounces = value; }
        public static Color subtractiveShadowColor { get => scene.subtractiveShadowColor; set => scene.subtractiveShadowColor = value; }
        public static float haloStrength { get => scene.haloStrength; set => scene.haloStrength = value; }
        public static float flareStrength { get => scene.flareStrength; set => scene.flareStrength = value; }
        public static float flareFadeSpeed { get => scene.flareFadeSpeed; set => scene.flareFadeSpeed = value; }
        public static Color ambientLight { get => ambientSkyColor; set => ambientSkyColor = value; }

        /// <summary>Sets the values of a scene that has none: they are the scene's, and go with it.</summary>
        internal static void Reset() => scene = new Values();
    }
}
