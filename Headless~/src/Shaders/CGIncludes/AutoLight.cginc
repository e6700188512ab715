// Attenuation and shadows of a light. This host has one directional light without shadows: all of it is 1.
// Written anew for the headless host.
#ifndef AUTOLIGHT_INCLUDED
#define AUTOLIGHT_INCLUDED

#define SHADOW_COORDS(idx)
#define TRANSFER_SHADOW(a)
#define SHADOW_ATTENUATION(a) 1.0
#define LIGHT_ATTENUATION(a) 1.0
#define LIGHTING_COORDS(idx1, idx2)
#define DECLARE_LIGHT_COORDS(idx)
#define TRANSFER_VERTEX_TO_FRAGMENT(a)
#define UNITY_SHADOW_COORDS(idx)
#define UNITY_TRANSFER_SHADOW(a, coord)
#define UNITY_SHADOW_ATTENUATION(a, worldPos) 1.0
#define UNITY_LIGHTING_COORDS(idx1, idx2)
#define UNITY_TRANSFER_LIGHTING(a, coord)
#define UNITY_LIGHT_ATTENUATION(destName, input, worldPos) fixed destName = 1.0

#endif
