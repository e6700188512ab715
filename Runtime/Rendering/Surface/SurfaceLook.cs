using System;
using UnityEngine;

namespace Rill
{
    /// <summary>Optical properties of the water: how it absorbs, scatters, refracts and reflects.</summary>
    [Serializable]
    public struct SurfaceLook
    {
        /// <summary>Color that white light has left after Color Depth of the fluid (Beer and Lambert). White: perfectly clear.</summary>
        [Tooltip("Color that white light has left after Color Depth of the fluid (Beer and Lambert). White: perfectly clear.")]
        public Color colorAtDepth;

        /// <summary>Path through the fluid after which white light has that color, m, above 0.</summary>
        [Tooltip("Path through the fluid after which white light has that color, m, above 0.")]
        public float colorDepth;

        /// <summary>Color of the light that the fluid scatters back: milk, mud, plankton.</summary>
        [Tooltip("Color of the light that the fluid scatters back: milk, mud, plankton.")]
        public Color scattering;

        /// <summary>Path after which 63 % of the light is scattered, m. 0: nothing scatters.</summary>
        [Tooltip("Path after which 63 % of the light is scattered, m. 0: nothing scatters.")]
        public float scatteringDepth;

        /// <summary>Index of refraction, 1 to 2. Water: 1.333.</summary>
        [Tooltip("Index of refraction, 1 to 2. Water: 1.333.")]
        [Range(1f, 2f)] public float refractionIndex;

        /// <summary>Roughness of the surface where it is calm, 0 to 1. 0: a mirror.</summary>
        [Tooltip("Roughness of the surface where it is calm, 0 to 1. 0: a mirror.")]
        [Range(0f, 1f)] public float roughness;

        /// <summary>Clear water.</summary>
        public static SurfaceLook Water => Of(SurfacePreset.Water);

        /// <summary>The look that goes by a name; that of water for <see cref="SurfacePreset.Custom"/>.</summary>
        public static SurfaceLook Of(SurfacePreset preset)
        {
            switch (preset)
            {
                case SurfacePreset.MurkyWater: return Make(new Color(0.35f, 0.42f, 0.22f), 0.5f, new Color(0.32f, 0.30f, 0.17f), 0.6f, 1.333f, 0.06f);
                case SurfacePreset.Wine: return Make(new Color(0.42f, 0.02f, 0.05f), 0.05f, new Color(0.25f, 0.01f, 0.02f), 0.5f, 1.345f, 0.03f);
                case SurfacePreset.Milk: return Make(new Color(0.95f, 0.92f, 0.85f), 0.05f, new Color(0.96f, 0.94f, 0.88f), 0.006f, 1.35f, 0.1f);
                case SurfacePreset.Oil: return Make(new Color(0.85f, 0.62f, 0.10f), 0.1f, new Color(0.5f, 0.35f, 0.05f), 2f, 1.47f, 0.02f);
                case SurfacePreset.Honey: return Make(new Color(0.80f, 0.38f, 0.03f), 0.03f, new Color(0.65f, 0.32f, 0.04f), 0.12f, 1.49f, 0.04f);
                default: return Make(new Color(0.45f, 0.78f, 0.83f), 1f, new Color(0.05f, 0.22f, 0.25f), 4f, 1.333f, 0.03f);
            }
        }

        /// <summary>1/m: what exp(-x L) takes out of light along a path of L.</summary>
        internal Vector3 Absorption
        {
            get
            {
                Color linear = QualitySettings.activeColorSpace == ColorSpace.Linear ? colorAtDepth.linear : colorAtDepth;
                return new Vector3(Absorbed(linear.r), Absorbed(linear.g), Absorbed(linear.b));
            }
        }

        /// <summary>1/m: 0 where nothing scatters.</summary>
        internal float ScatteringRate => scatteringDepth > 0f ? 1f / scatteringDepth : 0f;

        /// <summary>Reflectance of light that falls straight on the surface: 0.02 for water.</summary>
        internal float Reflectance
        {
            get
            {
                float ratio = (refractionIndex - 1f) / (refractionIndex + 1f);
                return ratio * ratio;
            }
        }

        /// <summary>Brings what is out of range back; problem is null where nothing was.</summary>
        public void Validate(out string problem)
        {
            problem = null;
            Limit.Clamp("color depth", ref colorDepth, 1e-4f, 1e4f, Water.colorDepth, ref problem);
            Limit.Clamp("scattering depth", ref scatteringDepth, 0f, 1e4f, Water.scatteringDepth, ref problem);
            Limit.Clamp("refraction index", ref refractionIndex, 1f, 2f, Water.refractionIndex, ref problem);
            Limit.Clamp("roughness", ref roughness, 0f, 1f, Water.roughness, ref problem);
        }

        static SurfaceLook Make(Color colorAtDepth, float colorDepth, Color scattering, float scatteringDepth, float refractionIndex, float roughness)
        {
            return new SurfaceLook
            {
                colorAtDepth = colorAtDepth, colorDepth = colorDepth, scattering = scattering, scatteringDepth = scatteringDepth,
                refractionIndex = refractionIndex, roughness = roughness,
            };
        }

        // A channel of 0 would take an endless rate.
        float Absorbed(float left) => -Mathf.Log(Mathf.Clamp(left, 1e-4f, 1f)) / colorDepth;
    }
}
