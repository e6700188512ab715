// A vertex of the water's mesh, and how far it has gone on at the time of the frame.
//
//   _MeshVertices  in  28 bytes each: position (3 floats, d, domain's frame); unit normal out of the water (4 x snorm16); displacement in the
//                      last substep, d, and 1 where it lies on a wall of the domain, else 0 (4 halves)
#ifndef RILL_MESH_VERTEX_INCLUDED
#define RILL_MESH_VERTEX_INCLUDED

#include "DrawnDomain.hlsl"

ByteAddressBuffer _MeshVertices;

static const uint kMeshVertexBytes = 28;

struct MeshVertex
{
    float3 position;        // d, where the field has it
    float3 normal;
    float3 displacement;    // d
};

float2 FromSnorm(uint packed)
{
    return max(float2(int2(packed << 16, packed) >> 16) / 32767.0, -1.0);
}

MeshVertex LoadMeshVertex(uint index)
{
    uint at = index * kMeshVertexBytes;
    uint3 position = _MeshVertices.Load3(at);
    uint4 rest = _MeshVertices.Load4(at + 12);
    MeshVertex v;
    v.position = asfloat(position);
    v.normal = float3(FromSnorm(rest.x), FromSnorm(rest.y).x);
    v.displacement = float3(f16tof32(rest.z & 0xffff), f16tof32(rest.z >> 16), f16tof32(rest.w & 0xffff));
    return v;
}

// How far it has gone on, d; not out of the domain, whose size is given.
float3 MeshShift(MeshVertex v, float3 size)
{
    float3 moved = v.position + v.displacement * _FrameLag.x;
    return clamp(moved, min(v.position, 0.0), max(v.position, size)) - v.position;
}

#endif
