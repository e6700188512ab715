// A face of the water's mesh, in four halves: its normal on an octahedron, and 24 bits in two whole numbers of 12 that a half holds.
#ifndef RILL_WATER_FACE_INCLUDED
#define RILL_WATER_FACE_INCLUDED

#include "DrawnDomain.hlsl"
#include "Directions.hlsl"

static const float kOnWall = 0.01;          // d: as near to a wall of the domain is the face of the water that lies in it
static const float kMaxDisplacement = 1.0;  // d in a substep: faster water is taken to be as fast

// A face that lies in a wall is as flat as it is, up to the line where the surface meets it, whose vertices have the normal of the surface.
// p: as it is drawn, d, in the domain's frame, as are both normals.
float3 FlatOnWalls(float3 p, float3 normal)
{
    float3 beyond = _DrawnDomainSize.xyz - p;
    float3 wall = p < kOnWall ? -1.0 : beyond < kOnWall ? 1.0 : 0.0;
    return any(wall != 0.0) ? normalize(wall) : normal;
}

// shift: of what is drawn from where the field has it, d, to 1/128 of how far the fastest goes on.
float4 PackFace(float3 normal, float3 shift)
{
    uint3 steps = uint3(round(clamp(shift / max(kMaxDisplacement * _FrameLag.x, 1e-6), -1.0, 1.0) * 127.0 + 128.0));
    uint bits = steps.x << 16 | steps.y << 8 | steps.z;
    return float4(PackDirection(normal), (float2(bits >> 12, bits & 4095) - 2048.0));
}

float3 UnpackNormal(float4 face)
{
    return UnpackDirection(face.xy);
}

float3 UnpackShift(float4 face)
{
    uint2 halves = uint2(round(face.zw + 2048.0));
    uint bits = halves.x << 12 | halves.y;
    return (float3(uint3(bits >> 16, bits >> 8, bits) & 255u) - 128.0) / 127.0 * (kMaxDisplacement * _FrameLag.x);
}

#endif
