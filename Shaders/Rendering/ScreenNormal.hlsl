// Output of DepthNormals passes: a world normal as URP stores it. Includes nothing.
#ifndef RILL_SCREEN_NORMAL_INCLUDED
#define RILL_SCREEN_NORMAL_INCLUDED

float4 ScreenNormal(float3 normal)
{
#ifdef _GBUFFER_NORMALS_OCT
    // Deferred with accurate normals: the octahedron's two coordinates in 12 bits each.
    float3 folded = normal / max(dot(abs(normal), 1.0), 1e-6);
    float turned = saturate(-folded.z);
    float2 octahedron = folded.xy + float2(folded.x >= 0.0 ? turned : -turned, folded.y >= 0.0 ? turned : -turned);
    uint2 bits = (uint2)(saturate(octahedron * 0.5 + 0.5) * 4095.5);
    uint2 high = bits >> 8, low = bits & 255;
    return float4(float3(low, high.x | (high.y << 4)) / 255.0, 0.0);
#else
    return float4(normal, 0.0);
#endif
}

#endif
