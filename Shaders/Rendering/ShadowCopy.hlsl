// Inputs of a directional light's shadow in the Built-in pipeline, copied while it is there: transparent draws come after it.
//
//   _ShadowMapSource   in   the light's map of depths, after it was drawn
//   the uniforms of UnityShadows, before the mask on the screen is made of them
//   target             out  the map; or a texel for each of the uniforms, see Generated/ShadowValues.hlsl
#include "Platform.hlsl"
#include "../Generated/ShadowValues.hlsl"

float4 ShadowCopyVertex(uint vertex : SV_VertexID) : SV_Position
{
    return float4(vertex == 1 ? 3.0 : -1.0, vertex == 2 ? 3.0 : -1.0, 0.5, 1.0);
}

#ifdef RILL_SHADOW_MAP
Texture2D<float> _ShadowMapSource;
float4 _ShadowCopySize;         // of the target, texels

float ShadowMapFragment(float4 clip : SV_Position) : SV_Target
{
    uint width, height;
    _ShadowMapSource.GetDimensions(width, height);
    return _ShadowMapSource.Load(int3(int2(clip.xy / _ShadowCopySize.xy * float2(width, height)), 0));
}
#else
float4x4 unity_WorldToShadow[4];
float4 unity_ShadowSplitSpheres[4];
float4 unity_ShadowSplitSqRadii;
float4 _LightSplitsFar;
float4 _LightShadowData;
float4 unity_ShadowFadeCenterAndType;
float4 _ShadowStamp;

float4 ShadowValueFragment(float4 clip : SV_Position) : SV_Target
{
    uint i = (uint)clip.x;
    if (i < kSplitSpheres)
        return unity_WorldToShadow[(i - kWorldToShadow) / 4][i % 4];
    if (i < kSplitSquaredRadii)
        return unity_ShadowSplitSpheres[i - kSplitSpheres];
    return i == kSplitSquaredRadii ? unity_ShadowSplitSqRadii : i == kSplitsFar ? _LightSplitsFar : i == kShadowData ? _LightShadowData
        : i == kShadowFade ? unity_ShadowFadeCenterAndType : _ShadowStamp;
}
#endif
