// How foam is lit, on a surface on the screen and over a mesh. Include after SurfaceView.hlsl.
#ifndef RILL_FOAM_LIGHT_INCLUDED
#define RILL_FOAM_LIGHT_INCLUDED

// Foam scatters light to all sides: however the surface under it is turned, some arrives.
float3 LitFoam(float3 around, float3 lightColor, float cosine)
{
    return _FoamColor.rgb * (around + lightColor * (0.35 + 0.45 * saturate(cosine)));
}

#endif
