// What the scene's surroundings look like in a direction: the reflection probe or sky that the pipeline gives, or a cube map of
// the user's own where RILL_OWN_REFLECTION is on. Includes nothing of Unity's; see View.hlsl.
//
//   _ReflectionCube      of the user's own; linear
//   _ReflectionStrength  factor
#ifndef RILL_ENVIRONMENT_INCLUDED
#define RILL_ENVIRONMENT_INCLUDED

#include "View.hlsl"

static const float kReflectionLevels = 6.0;     // mips over which a probe goes from a mirror to matt, in every pipeline

float _ReflectionStrength;

#if defined(RILL_OWN_REFLECTION)
TextureCube _ReflectionCube;
SamplerState sampler_ReflectionCube;
#elif defined(RILL_UNIVERSAL)
TextureCube _GlossyEnvironmentCubeMap;
SamplerState sampler_GlossyEnvironmentCubeMap;
float4 _GlossyEnvironmentCubeMap_HDR;
#elif defined(RILL_BUILT_IN)
TextureCube unity_SpecCube0;
SamplerState samplerunity_SpecCube0;
float4 unity_SpecCube0_HDR;
#else
float4 _SkyColor;           // HDRP's sky is not read: a colour above and one below
float4 _GroundColor;
#endif

// x times the alpha channel to the power of y, as far as w says that alpha holds a factor.
float3 DecodeProbe(float4 sampled, float4 hdr)
{
    float alpha = max(hdr.w * (sampled.a - 1.0) + 1.0, 0.0);
    return hdr.x * pow(max(alpha, 1e-6), hdr.y) * sampled.rgb;
}

// Linear. roughness: perceptual, 0 a mirror.
float3 Environment(float3 direction, float roughness)
{
    float level = roughness * (1.7 - 0.7 * roughness) * kReflectionLevels;
#if defined(RILL_OWN_REFLECTION)
    return _ReflectionStrength * _ReflectionCube.SampleLevel(sampler_ReflectionCube, direction, level).rgb;
#elif defined(RILL_UNIVERSAL)
    return _ReflectionStrength * DecodeProbe(_GlossyEnvironmentCubeMap.SampleLevel(sampler_GlossyEnvironmentCubeMap, direction, level), _GlossyEnvironmentCubeMap_HDR);
#elif defined(RILL_BUILT_IN)
    return _ReflectionStrength * DecodeProbe(unity_SpecCube0.SampleLevel(samplerunity_SpecCube0, direction, level), unity_SpecCube0_HDR);
#else
    return _ReflectionStrength * lerp(_GroundColor.rgb, _SkyColor.rgb, saturate(direction.y * 4.0 + 0.5));
#endif
}

#endif
