// A face of the water's mesh: its normal, also in one channel of 32 bits: 12 for each coordinate on an octahedron, as a whole number that a float
// holds.
#ifndef RILL_WATER_FACE_INCLUDED
#define RILL_WATER_FACE_INCLUDED

#include "DrawnDomain.hlsl"
#include "Directions.hlsl"

static const float kOnWall = 0.01;          // d: as near to a wall of the domain is the face of the water that lies in it
static const float kFaceLevels = 4095.0;

// A face that lies in a wall is as flat as it is, up to the line where the surface meets it, whose vertices have the normal of the surface.
// p: as it is drawn, d, in the domain's frame, as are both normals.
float3 FlatOnWalls(float3 p, float3 normal)
{
    float3 beyond = _DrawnDomainSize.xyz - p;
    float3 wall = p < kOnWall ? -1.0 : beyond < kOnWall ? 1.0 : 0.0;
    return any(wall != 0.0) ? normalize(wall) : normal;
}

float PackFace(float3 normal)
{
    float2 levels = round(saturate(PackDirection(normal) * 0.5 + 0.5) * kFaceLevels);
    return levels.x * (kFaceLevels + 1.0) + levels.y;
}

float3 UnpackFace(float packed)
{
    float x = floor(packed / (kFaceLevels + 1.0));
    return UnpackDirection(float2(x, packed - x * (kFaceLevels + 1.0)) / kFaceLevels * 2.0 - 1.0);
}

#endif
