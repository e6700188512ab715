// Light that does not come from a lamp: ambient light and the reflection of the sky. Written again for the headless host.
#ifndef UNITY_GLOBAL_ILLUMINATION_INCLUDED
#define UNITY_GLOBAL_ILLUMINATION_INCLUDED

#include "UnityCG.cginc"
#include "UnityLightingCommon.cginc"

inline UnityGI UnityGlobalIllumination(UnityGIInput data, half occlusion, half3 normalWorld)
{
    UnityGI gi;
    gi.light = data.light;
    gi.light.color *= data.atten;
    gi.indirect.diffuse = max(0, data.ambient + ShadeSH9(half4(normalWorld, 1.0))) * occlusion;
    gi.indirect.specular = 0;
    return gi;
}

// The mips of a reflection are the rougher the smaller they are.
#define UNITY_SPECCUBE_LOD_STEPS (6)
inline half perceptualRoughnessToMipmapLevel(half perceptualRoughness) { return perceptualRoughness * (1.7 - 0.7 * perceptualRoughness) * UNITY_SPECCUBE_LOD_STEPS; }

inline half3 UnityReflectedSky(half smoothness, half3 worldViewDir, half3 normalWorld)
{
    half mip = perceptualRoughnessToMipmapLevel(1 - smoothness);
    return DecodeHDR(UNITY_SAMPLE_TEXCUBE_LOD(unity_SpecCube0, reflect(-worldViewDir, normalWorld), mip), unity_SpecCube0_HDR);
}

inline void ResetUnityLight(out UnityLight light)
{
    light.color = 0;
    light.dir = half3(0, 1, 0);
    light.ndotl = 0;
}

inline void ResetUnityGI(out UnityGI gi)
{
    ResetUnityLight(gi.light);
    gi.indirect.diffuse = 0;
    gi.indirect.specular = 0;
}

#endif
