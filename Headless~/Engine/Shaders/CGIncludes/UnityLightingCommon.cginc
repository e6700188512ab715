// What every kind of lighting shares. Written again for the headless host.
#ifndef UNITY_LIGHTING_COMMON_INCLUDED
#define UNITY_LIGHTING_COMMON_INCLUDED

float4 _LightColor0;
float4 _SpecColor;

struct UnityLight
{
    half3 color;
    half3 dir;      // to the light
    half ndotl;     // of old, not used
};

struct UnityIndirect
{
    half3 diffuse;
    half3 specular;
};

struct UnityGI
{
    UnityLight light;
    UnityIndirect indirect;
};

struct UnityGIInput
{
    UnityLight light;
    float3 worldPos;
    half3 worldViewDir;
    half atten;
    half3 ambient;
};

#endif
