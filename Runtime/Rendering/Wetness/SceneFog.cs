using System;
using UnityEngine;

namespace Rill
{
    /// <summary>The fog of the Built-in pipeline and URP as two vectors, for a draw that would otherwise need a variant for each mode.</summary>
    static class SceneFog
    {
        /// <summary>Returns x, y, z and w of _WetFog, see Wetness.hlsl: the visible fraction through the fog at a depth z along the view, m, is
        /// saturate(x z + y) exp2(-(z' + z'^2)).</summary>
        public static Vector4 Parameters
        {
            get
            {
                if (!RenderSettings.fog)
                    return new Vector4(0f, 1f, 0f, 0f);
                float density = RenderSettings.fogDensity, start = RenderSettings.fogStartDistance, end = RenderSettings.fogEndDistance;
                switch (RenderSettings.fogMode)
                {
                    case FogMode.Linear:
                        float range = Math.Abs(end - start) > 1e-6f ? end - start : 1e-6f;
                        return new Vector4(-1f / range, end / range, 0f, 0f);
                    case FogMode.Exponential: return new Vector4(0f, 1f, density / Mathf.Log(2f), 0f);
                    default: return new Vector4(0f, 1f, 0f, density / Mathf.Sqrt(Mathf.Log(2f)));
                }
            }
        }
    }
}
