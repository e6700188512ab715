// The lighting models Lambert and BlinnPhong. Written again for the headless host: one directional light, ambient light from
// harmonics, no lightmaps.
#ifndef LIGHTING_INCLUDED
#define LIGHTING_INCLUDED

#include "UnityCG.cginc"
#include "UnityLightingCommon.cginc"
#include "UnityGlobalIllumination.cginc"

struct SurfaceOutput
{
    fixed3 Albedo;
    fixed3 Normal;
    fixed3 Emission;
    half Specular;
    fixed Gloss;
    fixed Alpha;
};

inline fixed4 UnityLambertLight(SurfaceOutput s, UnityLight light)
{
    return fixed4(s.Albedo * light.color * max(0, dot(s.Normal, light.dir)), s.Alpha);
}

inline fixed4 LightingLambert(SurfaceOutput s, UnityGI gi)
{
    fixed4 c = UnityLambertLight(s, gi.light);
    c.rgb += s.Albedo * gi.indirect.diffuse;
    return c;
}

inline void LightingLambert_GI(SurfaceOutput s, UnityGIInput data, inout UnityGI gi) { gi = UnityGlobalIllumination(data, 1.0, s.Normal); }

inline fixed4 UnityBlinnPhongLight(SurfaceOutput s, half3 viewDir, UnityLight light)
{
    half3 between = normalize(light.dir + viewDir);
    fixed diffuse = max(0, dot(s.Normal, light.dir));
    float highlight = pow(max(0, dot(s.Normal, between)), s.Specular * 128.0) * s.Gloss;
    return fixed4(s.Albedo * light.color * diffuse + light.color * _SpecColor.rgb * highlight, s.Alpha);
}

inline fixed4 LightingBlinnPhong(SurfaceOutput s, half3 viewDir, UnityGI gi)
{
    fixed4 c = UnityBlinnPhongLight(s, viewDir, gi.light);
    c.rgb += s.Albedo * gi.indirect.diffuse;
    return c;
}

inline void LightingBlinnPhong_GI(SurfaceOutput s, UnityGIInput data, inout UnityGI gi) { gi = UnityGlobalIllumination(data, 1.0, s.Normal); }

#endif
