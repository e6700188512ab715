// The main light of the scene and its shadow, as the pipeline gives them. Includes nothing of Unity's; see View.hlsl.
//
//   _SunDirection    world, towards the light; w 1 where a light was chosen on the component, 0 to take the pipeline's
//   _SunColor        linear, intensity applied; of the chosen light, and of HDRP, whose lights are not read
//   _ReceiveShadows  1 or 0
#ifndef RILL_MAIN_LIGHT_INCLUDED
#define RILL_MAIN_LIGHT_INCLUDED

#include "View.hlsl"

#ifndef RILL_SURFACE_VIEW_INCLUDED      // whose constants hold them
float4 _SunDirection;
float4 _SunColor;
float _ReceiveShadows;
#endif

struct MainLight
{
    float3 direction;       // world, unit, towards the light
    float3 color;           // linear
};

#if defined(RILL_UNIVERSAL)
float4 _MainLightPosition;      // xyz towards the light
float4 _MainLightColor;
#define RILL_LIGHT_DIRECTION _MainLightPosition.xyz
#define RILL_LIGHT_COLOR _MainLightColor.rgb
#elif defined(RILL_BUILT_IN)
float4 _WorldSpaceLightPos0;    // xyz towards the light
float4 _LightColor0;
#define RILL_LIGHT_DIRECTION _WorldSpaceLightPos0.xyz
#define RILL_LIGHT_COLOR _LightColor0.rgb
#else
#define RILL_LIGHT_DIRECTION _SunDirection.xyz
#define RILL_LIGHT_COLOR _SunColor.rgb
#endif

MainLight GetMainLight()
{
    MainLight light;
    light.direction = _SunDirection.w > 0.5 ? _SunDirection.xyz : RILL_LIGHT_DIRECTION;
    light.color = _SunDirection.w > 0.5 ? _SunColor.rgb : RILL_LIGHT_COLOR;
    light.direction *= rsqrt(max(dot(light.direction, light.direction), 1e-20));
    return light;
}

// ---- shadow: 1 in the light, 0 in full shadow

#if defined(RILL_BUILT_IN) && defined(RILL_SHADOW_COPY)

// A transparent draw: of copies that were made before the opaque ones, see ShadowCopy.hlsl. The surface's constants say which.
#include "../Generated/ShadowValues.hlsl"

Texture2D<float> _ShadowCopy;
SamplerState rill_point_clamp_sampler;
Texture2D<float4> _ShadowValues;

float4 ShadowValue(uint i)
{
    return _ShadowValues.Load(int3(i, 0, 0));
}

// 1 for each that is not in the shadow.
float4 AreLit(float4 nearest, float depth)
{
#if RILL_OPENGL
    return depth <= nearest ? 1.0 : 0.0;
#else
    return depth >= nearest ? 1.0 : 0.0;
#endif
}

float LightShadow(float3 world, float4 clip)
{
    // Another stamp: no shadow was drawn for this camera and frame.
    if (ShadowValue(kShadowStamp).x != _ShadowReceived.x || dot(_ShadowLight.xyz, RILL_LIGHT_DIRECTION) < 0.999)
        return 1.0;
    float z = dot(RILL_EYE - world, RILL_VIEW_MATRIX[2].xyz);
    uint cascade = 0, cascades = (uint)_ShadowReceived.y;
    if (cascades > 1)
    {
        float4 far = ShadowValue(kSplitsFar), radii = ShadowValue(kSplitSquaredRadii);
        for (uint i = 0; i < cascades; i++)
        {
            float3 offset = world - ShadowValue(kSplitSpheres + i).xyz;
            bool isIn = _ShadowReceived.z > 0.5 ? dot(offset, offset) < radii[i] : z < far[i];
            if (isIn)
                break;
            cascade++;
        }
        if (cascade == cascades)
            return 1.0;
    }
    float4 point4 = float4(world, 1.0);
    uint row = kWorldToShadow + 4 * cascade;
    float3 at = float3(dot(ShadowValue(row), point4), dot(ShadowValue(row + 1), point4), dot(ShadowValue(row + 2), point4));
    if (any(at <= 0.0) || any(at >= 1.0))
        return 1.0;

    uint width, height;
    _ShadowCopy.GetDimensions(width, height);
    // The mean of a square of 4 texels: the pattern of holes in the water's own shadow repeats after so many. A gather reads 2 x 2 of them.
    float2 size = float2(width, height), texels = at.xy * size, part = frac(texels), first = floor(texels) - 2.0;
    float lit = 0.0;
    for (uint y = 0; y < 3; y++)
        for (uint x = 0; x < 3; x++)
        {
            float4 four = AreLit(_ShadowCopy.Gather(rill_point_clamp_sampler, (first + 2.0 * float2(x, y) + 1.0) / size), at.z);
            float2 across = x == 0 ? float2(1.0 - part.x, 1.0) : x == 2 ? float2(part.x, 0.0) : 1.0;
            float2 up = y == 0 ? float2(1.0 - part.y, 1.0) : y == 2 ? float2(part.y, 0.0) : 1.0;
            lit += up.x * dot(four.wz, across) + up.y * dot(four.xy, across);
        }
    lit /= 16.0;
    float4 data = ShadowValue(kShadowData), fade = ShadowValue(kShadowFade);
    float away = fade.w > 0.5 ? distance(world, fade.xyz) : z;
    return saturate(lerp(data.x, 1.0, lit) + saturate(away * data.z + data.w));
}

#elif defined(RILL_BUILT_IN) && defined(SHADOWS_SCREEN)

#if defined(UNITY_NO_SCREENSPACE_SHADOWS)
Texture2D _ShadowMapTexture;
SamplerComparisonState sampler_ShadowMapTexture;
float4x4 unity_WorldToShadow[4];
float4 _LightShadowData;        // x 1 - strength, z and w of the fade with distance
float4 unity_ShadowFadeCenterAndType;

float LightShadow(float3 world, float4 clip)
{
    float3 at = mul(unity_WorldToShadow[0], float4(world, 1.0)).xyz;
    float lit = lerp(_LightShadowData.x, 1.0, _ShadowMapTexture.SampleCmpLevelZero(sampler_ShadowMapTexture, at.xy, at.z));
    float away = unity_ShadowFadeCenterAndType.w > 0.5 ? distance(world, unity_ShadowFadeCenterAndType.xyz)
        : dot(RILL_EYE - world, RILL_VIEW_MATRIX[2].xyz);
    return saturate(lit + saturate(away * _LightShadowData.z + _LightShadowData.w));
}
#else
// Already on the screen: made of the shadow map and the camera's depth, which the ShadowCaster pass drew.
#ifdef RILL_STEREO
Texture2DArray _ShadowMapTexture;
#else
Texture2D _ShadowMapTexture;
#endif
float4 _ProjectionParams;       // x -1 where the projection is upside down

float LightShadow(float3 world, float4 clip)
{
    uint width, height;
#ifdef RILL_STEREO
    uint slices;
    _ShadowMapTexture.GetDimensions(width, height, slices);
#else
    _ShadowMapTexture.GetDimensions(width, height);
#endif
    float2 uv = float2(clip.x, clip.y * _ProjectionParams.x) / clip.w * 0.5 + 0.5;
    int2 texel = clamp(int2(uv * float2(width, height)), 0, int2(width, height) - 1);
#ifdef RILL_STEREO
    return _ShadowMapTexture.Load(int4(texel, eyeIndex, 0)).r;
#else
    return _ShadowMapTexture.Load(int3(texel, 0)).r;
#endif
}
#endif

#elif defined(RILL_UNIVERSAL) && defined(_MAIN_LIGHT_SHADOWS_SCREEN)

#ifdef RILL_STEREO
Texture2DArray _ScreenSpaceShadowmapTexture;
#else
Texture2D _ScreenSpaceShadowmapTexture;
#endif
SamplerState rill_point_clamp_sampler;
float4 _ProjectionParams;

float LightShadow(float3 world, float4 clip)
{
    float2 uv = float2(clip.x, clip.y * _ProjectionParams.x) / clip.w * 0.5 + 0.5;
#ifdef RILL_STEREO
    return _ScreenSpaceShadowmapTexture.SampleLevel(rill_point_clamp_sampler, float3(uv, eyeIndex), 0).r;
#else
    return _ScreenSpaceShadowmapTexture.SampleLevel(rill_point_clamp_sampler, uv, 0).r;
#endif
}

#elif defined(RILL_UNIVERSAL) && (defined(_MAIN_LIGHT_SHADOWS) || defined(_MAIN_LIGHT_SHADOWS_CASCADE))

Texture2D _MainLightShadowmapTexture;
SamplerComparisonState rill_linear_clamp_compare_sampler;
float4x4 _MainLightWorldToShadow[5];        // one for each cascade, and one for beyond
float4 _CascadeShadowSplitSpheres0;
float4 _CascadeShadowSplitSpheres1;
float4 _CascadeShadowSplitSpheres2;
float4 _CascadeShadowSplitSpheres3;
float4 _CascadeShadowSplitSphereRadii;      // squared
float4 _MainLightShadowOffset0;
float4 _MainLightShadowOffset1;
float4 _MainLightShadowParams;              // x strength, y 0 hard or else soft, z and w of the fade with distance squared

float LightShadow(float3 world, float4 clip)
{
    uint cascade = 0;
#ifdef _MAIN_LIGHT_SHADOWS_CASCADE
    float3 from0 = world - _CascadeShadowSplitSpheres0.xyz, from1 = world - _CascadeShadowSplitSpheres1.xyz;
    float3 from2 = world - _CascadeShadowSplitSpheres2.xyz, from3 = world - _CascadeShadowSplitSpheres3.xyz;
    bool4 outside = float4(dot(from0, from0), dot(from1, from1), dot(from2, from2), dot(from3, from3)) >= _CascadeShadowSplitSphereRadii;
    cascade = !outside.x ? 0 : !outside.y ? 1 : !outside.z ? 2 : !outside.w ? 3 : 4;
#endif
    float3 at = mul(_MainLightWorldToShadow[cascade], float4(world, 1.0)).xyz;
    if (at.z <= 0.0 || at.z >= 1.0)
        return 1.0;

    float lit;
    if (_MainLightShadowParams.y > 0.5)
    {
        lit = 0.25 * (_MainLightShadowmapTexture.SampleCmpLevelZero(rill_linear_clamp_compare_sampler, at.xy + _MainLightShadowOffset0.xy, at.z)
            + _MainLightShadowmapTexture.SampleCmpLevelZero(rill_linear_clamp_compare_sampler, at.xy + _MainLightShadowOffset0.zw, at.z)
            + _MainLightShadowmapTexture.SampleCmpLevelZero(rill_linear_clamp_compare_sampler, at.xy + _MainLightShadowOffset1.xy, at.z)
            + _MainLightShadowmapTexture.SampleCmpLevelZero(rill_linear_clamp_compare_sampler, at.xy + _MainLightShadowOffset1.zw, at.z));
    }
    else
        lit = _MainLightShadowmapTexture.SampleCmpLevelZero(rill_linear_clamp_compare_sampler, at.xy, at.z);

    float fade = saturate(EyeDistanceSquared(world) * _MainLightShadowParams.z + _MainLightShadowParams.w);
    return lerp(lerp(1.0, lit, _MainLightShadowParams.x), 1.0, fade);
}

#else

float LightShadow(float3 world, float4 clip)
{
    return 1.0;
}

#endif

// Shadow of a point that the pass draws, at its clip position. A light chosen on the component has a shadow only if it is the main one.
float MainLightShadow(MainLight light, float3 world, float4 clip)
{
    float3 main = RILL_LIGHT_DIRECTION;
    bool isMain = dot(light.direction, main) > 0.999 * sqrt(dot(main, main));
    return _ReceiveShadows > 0.5 && isMain ? LightShadow(world, clip) : 1.0;
}

#endif
