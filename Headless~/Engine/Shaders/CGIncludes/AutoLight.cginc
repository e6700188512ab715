// Attenuation and shadows of a light: one directional light here, whose shadow is a mask on the screen (SHADOWS_SCREEN).
// Written again for the headless host.
#ifndef AUTOLIGHT_INCLUDED
#define AUTOLIGHT_INCLUDED

#include "UnityShaderVariables.cginc"

#ifdef SHADOWS_SCREEN
UNITY_DECLARE_SCREENSPACE_TEXTURE(_ShadowMapTexture);
inline fixed unitySampleShadow(float4 coord) { return UNITY_SAMPLE_SCREENSPACE_TEXTURE(_ShadowMapTexture, coord.xy / coord.w).r; }
#define SHADOW_COORDS(idx) float4 _ShadowCoord : TEXCOORD##idx;
#define TRANSFER_SHADOW(a) a._ShadowCoord = ComputeScreenPos(a.pos);
#define SHADOW_ATTENUATION(a) unitySampleShadow(a._ShadowCoord)
#else
#define SHADOW_COORDS(idx)
#define TRANSFER_SHADOW(a)
#define SHADOW_ATTENUATION(a) 1.0
#endif

#define LIGHT_ATTENUATION(a) SHADOW_ATTENUATION(a)
#define LIGHTING_COORDS(idx1, idx2) SHADOW_COORDS(idx2)
#define DECLARE_LIGHT_COORDS(idx)
#define TRANSFER_VERTEX_TO_FRAGMENT(a) TRANSFER_SHADOW(a)
#define UNITY_SHADOW_COORDS(idx) SHADOW_COORDS(idx)
#define UNITY_TRANSFER_SHADOW(a, coord) TRANSFER_SHADOW(a)
#define UNITY_SHADOW_ATTENUATION(a, worldPos) SHADOW_ATTENUATION(a)
#define UNITY_LIGHTING_COORDS(idx1, idx2) SHADOW_COORDS(idx2)
#define UNITY_TRANSFER_LIGHTING(a, coord) TRANSFER_SHADOW(a)
#define UNITY_LIGHT_ATTENUATION(destName, input, worldPos) fixed destName = SHADOW_ATTENUATION(input);

#endif
