// The scene's fog, of the Built-in pipeline and URP. Includes nothing of Unity's.
#ifndef RILL_FOG_INCLUDED
#define RILL_FOG_INCLUDED

#if defined(FOG_LINEAR) || defined(FOG_EXP) || defined(FOG_EXP2)
float4 unity_FogParams;
float4 unity_FogColor;
#endif

// How much is seen through the fog, at a depth along the view in m.
float FogTransmittance(float z)
{
#if defined(FOG_LINEAR)
    return saturate(z * unity_FogParams.z + unity_FogParams.w);
#elif defined(FOG_EXP)
    return saturate(exp2(-unity_FogParams.y * z));
#elif defined(FOG_EXP2)
    float x = unity_FogParams.x * z;
    return saturate(exp2(-x * x));
#else
    return 1.0;
#endif
}

// coverage: how much of what is behind the color hides; it is multiplied with that already.
float3 ApplyFog(float3 color, float coverage, float z)
{
#if defined(FOG_LINEAR) || defined(FOG_EXP) || defined(FOG_EXP2)
    return lerp(unity_FogColor.rgb * coverage, color, FogTransmittance(z));
#else
    return color;
#endif
}

#endif
