// Moves what a light sees away from it, as the pipeline's settings ask, so that surfaces do not shade themselves. Includes
// nothing of Unity's; see View.hlsl. The light's direction comes from the matrix, so that directional and other lights need no
// keyword. The Built-in pipeline's depth texture is drawn by the same pass, from the camera and with a bias of 0.
#ifndef RILL_SHADOW_BIAS_INCLUDED
#define RILL_SHADOW_BIAS_INCLUDED

#define RILL_SHADOW_VIEW
#include "View.hlsl"

#if defined(RILL_UNIVERSAL)

float4 _ShadowBias;             // x along the light, y along the normal, m, both 0 or less

float4 ShadowClip(float3 world, float3 normal)
{
    float3 toLight = ToEye(world);
    float grazing = 1.0 - saturate(dot(toLight, normal));
    float4 clip = WorldToClip(world + toLight * _ShadowBias.x + normal * (grazing * _ShadowBias.y));
#if RILL_OPENGL
    clip.z = max(clip.z, -clip.w);
#else
    clip.z = min(clip.z, clip.w);
#endif
    return clip;
}

#elif defined(RILL_BUILT_IN)

float4 unity_LightShadowBias;   // x of clip depth, y 1 to keep casters behind the near plane in the map, z along the normal, m

float4 ShadowClip(float3 world, float3 normal)
{
    if (unity_LightShadowBias.z != 0.0)
    {
        float facing = dot(normal, ToEye(world));
        world -= normal * (unity_LightShadowBias.z * sqrt(saturate(1.0 - facing * facing)));
    }
    float4 clip = WorldToClip(world);
#if RILL_OPENGL
    clip.z += saturate(unity_LightShadowBias.x / clip.w);
    clip.z = lerp(clip.z, max(clip.z, -clip.w), unity_LightShadowBias.y);
#else
    clip.z += clamp(unity_LightShadowBias.x / clip.w, -1.0, 0.0);
    clip.z = lerp(clip.z, min(clip.z, clip.w), unity_LightShadowBias.y);
#endif
    return clip;
}

#else

// HDRP biases where it reads a shadow.
float4 ShadowClip(float3 world, float3 normal)
{
    return WorldToClip(world);
}

#endif

#endif
