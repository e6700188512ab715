// A face of the water's mesh, in four halves: its normal on an octahedron, and 24 bits in two whole numbers of 12 that a half holds.
#ifndef RILL_WATER_FACE_INCLUDED
#define RILL_WATER_FACE_INCLUDED

#include "DrawnDomain.hlsl"
#include "Directions.hlsl"

static const float kOnWall = 0.01;          // d: as near to a wall of the domain is the face of the water that lies in it
static const float kMaxChord = 16.0;        // d

// A face that lies in a wall is as flat as it is, up to the line where the surface meets it, whose vertices have the normal of the surface.
// p: as it is drawn, d, in the domain's frame, as are both normals.
float3 FlatOnWalls(float3 p, float3 normal)
{
    float3 beyond = _DrawnDomainSize.xyz - p;
    float3 wall = p < kOnWall ? -1.0 : beyond < kOnWall ? 1.0 : 0.0;
    return any(wall != 0.0) ? normalize(wall) : normal;
}

// chord: displacement in the last substep, d, to 1/63 of its largest component or 0.002. Three components of 7 bits have one exponent.
float4 PackFace(float3 normal, float3 chord)
{
    float most = max(abs(chord.x), max(abs(chord.y), abs(chord.z)));
    float exponent = clamp(floor(log2(kMaxChord / max(most, 1e-6))), 0.0, 7.0);
    uint3 steps = uint3(round(clamp(chord / kMaxChord * exp2(exponent), -1.0, 1.0) * 63.0 + 64.0));
    uint bits = uint(exponent) << 21 | steps.x << 14 | steps.y << 7 | steps.z;
    return float4(PackDirection(normal), float2(bits >> 12, bits & 4095) - 2048.0);
}

float3 UnpackNormal(float4 face)
{
    return UnpackDirection(face.xy);
}

float3 UnpackChord(float4 face)
{
    uint2 halves = uint2(round(face.zw + 2048.0));
    uint bits = halves.x << 12 | halves.y;
    return (float3(uint3(bits >> 14, bits >> 7, bits) & 127u) - 64.0) / 63.0 * kMaxChord * exp2(-float(bits >> 21));
}

#endif
