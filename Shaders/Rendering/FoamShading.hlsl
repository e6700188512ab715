// How layers of foam on the picture of the water are sampled, and how foam is lit. Include after SurfaceView.hlsl.
#ifndef RILL_FOAM_SHADING_INCLUDED
#define RILL_FOAM_SHADING_INCLUDED

// Returns a layer at a point of the picture, between its texels.
float4 SampleFoam(Texture2DArray<float4> layer, float2 picture, uint eye, SamplerState linearClamp)
{
    return layer.SampleLevel(linearClamp, PointOfLayer(layer, picture, eye), 0);
}

// Foam scatters light to all sides: however the surface under it is turned, some arrives.
float3 LitFoam(float3 around, float3 lightColor, float cosine)
{
    return _FoamColor.rgb * (around + lightColor * (0.35 + 0.45 * saturate(cosine)));
}

#endif
