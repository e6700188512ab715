// The lighting models Standard and StandardSpecular: Lambert and one GGX highlight with Schlick's Fresnel term.
// Written again for the headless host; what is reflected is the sky, since there are no probes.
#ifndef UNITY_PBS_LIGHTING_INCLUDED
#define UNITY_PBS_LIGHTING_INCLUDED

#include "UnityCG.cginc"
#include "UnityLightingCommon.cginc"
#include "UnityGlobalIllumination.cginc"

struct SurfaceOutputStandard
{
    fixed3 Albedo;
    float3 Normal;
    half3 Emission;
    half Metallic;
    half Smoothness;
    half Occlusion;
    fixed Alpha;
};

struct SurfaceOutputStandardSpecular
{
    fixed3 Albedo;
    fixed3 Specular;
    float3 Normal;
    half3 Emission;
    half Smoothness;
    half Occlusion;
    fixed Alpha;
};

inline half SpecularStrength(half3 specular) { return max(max(specular.r, specular.g), specular.b); }

inline half OneMinusReflectivityFromMetallic(half metallic)
{
    half dielectric = unity_ColorSpaceDielectricSpec.a;
    return dielectric - metallic * dielectric;
}

inline half3 DiffuseAndSpecularFromMetallic(half3 albedo, half metallic, out half3 specColor, out half oneMinusReflectivity)
{
    specColor = lerp(unity_ColorSpaceDielectricSpec.rgb, albedo, metallic);
    oneMinusReflectivity = OneMinusReflectivityFromMetallic(metallic);
    return albedo * oneMinusReflectivity;
}

inline half3 EnergyConservationBetweenDiffuseAndSpecular(half3 albedo, half3 specColor, out half oneMinusReflectivity)
{
    oneMinusReflectivity = 1 - SpecularStrength(specColor);
    return albedo * oneMinusReflectivity;
}

inline half3 PreMultiplyAlpha(half3 diffColor, half alpha, half oneMinusReflectivity, out half outModifiedAlpha)
{
    outModifiedAlpha = 1 - oneMinusReflectivity + alpha * oneMinusReflectivity;
    return diffColor * alpha;
}

inline half4 UNITY_BRDF_PBS(half3 diffColor, half3 specColor, half oneMinusReflectivity, half smoothness, float3 normal, float3 viewDir, UnityLight light, UnityIndirect gi)
{
    float3 between = normalize(light.dir + viewDir);
    float nl = saturate(dot(normal, light.dir)), nv = abs(dot(normal, viewDir)), nh = saturate(dot(normal, between)), lh = saturate(dot(light.dir, between));
    float roughness = max((1 - smoothness) * (1 - smoothness), 0.002);
    float r2 = roughness * roughness;

    // Trowbridge-Reitz distribution with Smith's joint masking; light is measured so that white Lambert gives 1: both times pi.
    float d = nh * nh * (r2 - 1) + 1;
    float visibility = 0.5 / max(nl * (nv * (1 - roughness) + roughness) + nv * (nl * (1 - roughness) + roughness), 1e-5);
    float highlight = visibility * r2 / (d * d + 1e-7);
#ifdef UNITY_COLORSPACE_GAMMA
    highlight = sqrt(max(1e-4, highlight));
#endif
    float3 fresnel = specColor + (1 - specColor) * pow(1 - lh, 5);
    float grazing = saturate(smoothness + 1 - oneMinusReflectivity);
    float3 reflection = gi.specular / (r2 + 1) * lerp(specColor, grazing, pow(1 - nv, 5));
    return half4(diffColor * (gi.diffuse + light.color * nl) + max(0, highlight * nl) * light.color * fresnel + reflection, 1);
}

inline half4 LightingStandard(SurfaceOutputStandard s, float3 viewDir, UnityGI gi)
{
    s.Normal = normalize(s.Normal);
    half oneMinusReflectivity, outputAlpha;
    half3 specColor;
    s.Albedo = DiffuseAndSpecularFromMetallic(s.Albedo, s.Metallic, specColor, oneMinusReflectivity);
    outputAlpha = s.Alpha;
#ifdef _ALPHAPREMULTIPLY_ON
    s.Albedo = PreMultiplyAlpha(s.Albedo, s.Alpha, oneMinusReflectivity, outputAlpha);
#endif
    half4 c = UNITY_BRDF_PBS(s.Albedo, specColor, oneMinusReflectivity, s.Smoothness, s.Normal, viewDir, gi.light, gi.indirect);
    c.a = outputAlpha;
    return c;
}

inline half4 LightingStandardSpecular(SurfaceOutputStandardSpecular s, float3 viewDir, UnityGI gi)
{
    s.Normal = normalize(s.Normal);
    half oneMinusReflectivity, outputAlpha;
    s.Albedo = EnergyConservationBetweenDiffuseAndSpecular(s.Albedo, s.Specular, oneMinusReflectivity);
    outputAlpha = s.Alpha;
#ifdef _ALPHAPREMULTIPLY_ON
    s.Albedo = PreMultiplyAlpha(s.Albedo, s.Alpha, oneMinusReflectivity, outputAlpha);
#endif
    half4 c = UNITY_BRDF_PBS(s.Albedo, s.Specular, oneMinusReflectivity, s.Smoothness, s.Normal, viewDir, gi.light, gi.indirect);
    c.a = outputAlpha;
    return c;
}

inline void LightingStandard_GI(SurfaceOutputStandard s, UnityGIInput data, inout UnityGI gi)
{
    gi = UnityGlobalIllumination(data, s.Occlusion, s.Normal);
    gi.indirect.specular = UnityReflectedSky(s.Smoothness, data.worldViewDir, s.Normal) * s.Occlusion;
}

inline void LightingStandardSpecular_GI(SurfaceOutputStandardSpecular s, UnityGIInput data, inout UnityGI gi)
{
    gi = UnityGlobalIllumination(data, s.Occlusion, s.Normal);
    gi.indirect.specular = UnityReflectedSky(s.Smoothness, data.worldViewDir, s.Normal) * s.Occlusion;
}

#endif
