using System;
using System.Collections.Generic;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace UnityEngine
{
    /// <summary>Directional lights reach shaders (_WorldSpaceLightPos0, _LightColor0), the main one with its shadow; other kinds are stored
    /// only.</summary>
    public sealed class Light : Behaviour
    {
        static readonly List<Light> active = new List<Light>();

        internal override void OnActivated() => active.Add(this);
        internal override void OnDeactivated() => active.Remove(this);

        /// <summary>RenderSettings.sun, else the brightest directional light; null when there is none.</summary>
        internal static Light MainDirectional()
        {
            Light sun = RenderSettings.sun;
            if (sun != null && sun.Activated && sun.type == LightType.Directional)
                return sun;
            Light brightest = null;
            foreach (Light light in active)
                if (light.type == LightType.Directional && (brightest is null || light.Brightness > brightest.Brightness))
                    brightest = light;
            return brightest;
        }

        internal static Light Find(int id) => active.Find(light => light.GetInstanceID() == id);
        internal static IReadOnlyList<Light> Directional() => active.FindAll(light => light.type == LightType.Directional);

        /// <summary>Color that culling hands to a scriptable pipeline: with the intensity, linear if GraphicsSettings has it so.</summary>
        internal Color FinalColor
        {
            get
            {
                Color linear = GraphicsSettings.lightsUseLinearIntensity ? color.linear : color;
                return (GraphicsSettings.lightsUseColorTemperature && useColorTemperature
                    ? linear * Mathf.CorrelatedColorTemperatureToRGB(colorTemperature) : linear) * intensity;
            }
        }

        float Brightness => color.grayscale * intensity;

        public LightType type { get; set; } = LightType.Point;
        public Color color { get; set; } = Color.white;
        public float intensity { get; set; } = 1;
        public float bounceIntensity { get; set; } = 1;
        public float range { get; set; } = 10;
        public float spotAngle { get; set; } = 30;
        public float innerSpotAngle { get; set; } = 21.80208f;
        public bool useColorTemperature { get; set; }
        public float colorTemperature { get; set; } = 6570;
        public LightShadows shadows { get; set; }
        public float shadowStrength { get; set; } = 1;
        public float shadowBias { get; set; } = 0.05f;
        public float shadowNormalBias { get; set; } = 0.4f;
        public float shadowNearPlane { get; set; } = 0.2f;
        public int shadowCustomResolution { get; set; } = -1;
        public LightRenderMode renderMode { get; set; }
        public int cullingMask { get; set; } = ~0;
        public int renderingLayerMask { get; set; } = 1;
        public Texture cookie { get; set; }
        public float cookieSize { get; set; } = 10;
        readonly EventCommands<LightEvent> commandBuffers = new EventCommands<LightEvent>();

        /// <summary>Runs where the Built-in pipeline draws this light's shadow; of the events those after the map and before the mask on
        /// the screen.</summary>
        public void AddCommandBuffer(LightEvent evt, CommandBuffer buffer)
        {
            if (evt != LightEvent.AfterShadowMap && evt != LightEvent.BeforeScreenspaceMask)
                throw new NotSupportedException($"Light.AddCommandBuffer: the headless host runs none at LightEvent.{evt}.");
            commandBuffers.Add(evt, buffer);
        }

        public void RemoveCommandBuffer(LightEvent evt, CommandBuffer buffer) => commandBuffers.Remove(evt, buffer);
        public CommandBuffer[] GetCommandBuffers(LightEvent evt) => commandBuffers.Of(evt);
        public int commandBufferCount => commandBuffers.Count;
        internal void Execute(LightEvent evt) => commandBuffers.Execute(evt);
    }

    /// <summary>Light probes light nothing here; the type stands in signatures.</summary>
    public sealed class LightProbeProxyVolume : Behaviour { }
}
