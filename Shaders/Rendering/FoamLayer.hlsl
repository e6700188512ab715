// Foam as the water's surface shows it, from what SurfaceFoam.compute added up. Include after SurfaceView.hlsl and Environment.hlsl.
//
//   _SurfaceFoam   in   Texture2DArray, a slice for each eye: optical depth of what is in front of the water and on it, its sum with the
//                       distance along the view, m; optical depth under water, its sum with the water in front of it, m
#ifndef RILL_FOAM_LAYER_INCLUDED
#define RILL_FOAM_LAYER_INCLUDED

#include "FoamShading.hlsl"

Texture2DArray<float4> _SurfaceFoam;

struct FoamLayer
{
    float front;            // how much what is in front of the water and on it covers, 0 to 1
    float z;                // its distance along the view, m
    float under;            // how much what is under water covers
    float below;            // water in front of that, m
};

FoamLayer FoamLayerAt(float2 picture, uint eye, SamplerState linearClamp)
{
    float4 foam = SampleFoam(_SurfaceFoam, picture, eye, linearClamp);
    FoamLayer layer;
    layer.front = 1.0 - exp(-foam.x);
    layer.z = foam.y / max(foam.x, 1e-6);
    layer.under = 1.0 - exp(-foam.z);
    layer.below = foam.w / max(foam.z, 1e-6);
    return layer;
}

#endif
