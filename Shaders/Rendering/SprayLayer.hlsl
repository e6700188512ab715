// Foam, spray and small droplets on the picture, from what WaterSpray.compute added up. Include after SurfaceView.hlsl.
//
//   _Spray     in   Texture2DArray, a slice for each eye: x optical depth of foam in front of the water, y what droplets cover, z mean distance
//                   along the view, m
//   _Bubbles   in   Texture2DArray: x optical depth of foam under water, y mean of the water in front of it, m
#ifndef RILL_SPRAY_LAYER_INCLUDED
#define RILL_SPRAY_LAYER_INCLUDED

#include "FoamLight.hlsl"

Texture2DArray<float4> _Spray;
Texture2DArray<float4> _Bubbles;

// Returns where a layer is sampled for a point of the picture. texels: width and height of the texture.
float3 PlaceInSpray(float2 picture, float2 texels, uint eye)
{
    return float3(clamp(TexelsAt(picture, _FoamSize, _FoamWindow), 0.5, max(_FoamWindow.zw - 0.5, 0.5)) / texels, eye);
}

float3 SprayAt(float2 picture, uint eye, SamplerState linearClamp)
{
    uint width, height, slices;
    _Spray.GetDimensions(width, height, slices);
    return _Spray.SampleLevel(linearClamp, PlaceInSpray(picture, float2(width, height), eye), 0).xyz;
}

// x how much they cover, 0 to 1; y water in front of them, m.
float2 BubblesAt(float2 picture, uint eye, SamplerState linearClamp)
{
    uint width, height, slices;
    _Bubbles.GetDimensions(width, height, slices);
    float2 layer = _Bubbles.SampleLevel(linearClamp, PlaceInSpray(picture, float2(width, height), eye), 0).xy;
    return float2(1.0 - exp(-layer.x), layer.y);
}

#endif
