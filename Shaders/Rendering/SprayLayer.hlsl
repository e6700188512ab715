// Foam, spray and small droplets on the picture, from what WaterSpray.compute added up. Include after SurfaceView.hlsl.
//
//   _Spray     in   Texture2DArray, a slice for each eye: x optical depth of foam in front of the water, y what droplets cover, z mean distance
//                   along the view, m; w as x, but of foam on the water without its cells
//   _Bubbles   in   Texture2DArray: x optical depth of foam under water, y mean of the water in front of it, m
#ifndef RILL_SPRAY_LAYER_INCLUDED
#define RILL_SPRAY_LAYER_INCLUDED

#include "FoamShading.hlsl"

Texture2DArray<float4> _Spray;
Texture2DArray<float4> _Bubbles;

float4 SprayAt(float2 picture, uint eye, SamplerState linearClamp)
{
    return SampleFoam(_Spray, picture, eye, linearClamp);
}

// x how much they cover, 0 to 1; y water in front of them, m.
float2 BubblesAt(float2 picture, uint eye, SamplerState linearClamp)
{
    float2 layer = SampleFoam(_Bubbles, picture, eye, linearClamp).xy;
    return float2(1.0 - exp(-layer.x), layer.y);
}

#endif
