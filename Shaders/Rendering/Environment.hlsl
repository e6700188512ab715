// What the scene's surroundings look like in a direction: the reflection probe or sky that the pipeline gives, or a cube map of
// the user's own where RILL_OWN_REFLECTION is on. Includes nothing of Unity's; see View.hlsl.
//
//   _ReflectionCube      of the user's own; linear. In HDRP, whose light has units: nits
//   _ReflectionStrength  factor, see SurfaceView.hlsl
#ifndef RILL_ENVIRONMENT_INCLUDED
#define RILL_ENVIRONMENT_INCLUDED

#include "View.hlsl"

static const float kReflectionLevels = 6.0;     // mips over which a probe goes from a mirror to matt, in every pipeline

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
TextureCubeArray _SkyTexture;   // HDRP's sky, nits; the first is as a shiny surface reflects it
SamplerState rill_trilinear_clamp_sampler;
#endif

// HDRP's color buffer holds light times the camera's exposure, and so does the copy of the scene: what is added must be exposed too.
#if defined(RILL_HIGH_DEFINITION)
Texture2D _ExposureTexture;
#define RILL_EXPOSURE _ExposureTexture.Load(int3(0, 0, 0)).r
#else
#define RILL_EXPOSURE 1.0
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
    return _ReflectionStrength * RILL_EXPOSURE * _ReflectionCube.SampleLevel(sampler_ReflectionCube, direction, level).rgb;
#elif defined(RILL_UNIVERSAL)
    return _ReflectionStrength * DecodeProbe(_GlossyEnvironmentCubeMap.SampleLevel(sampler_GlossyEnvironmentCubeMap, direction, level),
        _GlossyEnvironmentCubeMap_HDR);
#elif defined(RILL_BUILT_IN)
    return _ReflectionStrength * DecodeProbe(unity_SpecCube0.SampleLevel(samplerunity_SpecCube0, direction, level), unity_SpecCube0_HDR);
#else
    return _ReflectionStrength * RILL_EXPOSURE * _SkyTexture.SampleLevel(rill_trilinear_clamp_sampler, float4(direction, 0.0), level).rgb;
#endif
}

#endif
