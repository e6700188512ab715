// A unit vector as a point of an octahedron (Meyer et al. 2010), -1 to 1. Includes nothing.
#ifndef RILL_DIRECTIONS_INCLUDED
#define RILL_DIRECTIONS_INCLUDED

float2 PackDirection(float3 n)
{
    n /= max(dot(abs(n), 1.0), 1e-6);
    float2 folded = (1.0 - abs(n.yx)) * (n.xy >= 0.0 ? 1.0 : -1.0);
    return n.z < 0.0 ? folded : n.xy;
}

float3 UnpackDirection(float2 packed)
{
    float3 n = float3(packed, 1.0 - abs(packed.x) - abs(packed.y));
    float folded = saturate(-n.z);
    n.xy += n.xy >= 0.0 ? -folded : folded;
    return normalize(n);
}

#endif
