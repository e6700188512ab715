// The mesh of the water's surface at the time of the frame: vertices go on along their displacement. Include after View.hlsl and, but
// for a shadow map, SurfaceView.hlsl.
//
//   _MeshVertices  in  28 bytes each: position (3 floats, d, domain's frame); unit normal out of the water (4 x snorm16); displacement in the
//                      last substep, d, and 1 where it lies on a wall of the domain, else 0 (4 halves)
#ifndef RILL_WATER_MESH_INCLUDED
#define RILL_WATER_MESH_INCLUDED

ByteAddressBuffer _MeshVertices;
float4x4 _DomainToWorld;        // from the domain's frame in d to world, meters
float4 _FrameLag;               // x: time of this frame since the newest state, substeps

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

#ifndef RILL_SHADOW_VIEW
struct WaterVaryings
{
    precise float4 clip : SV_Position;      // the same to the bit in the pass of depth
    float3 world : TEXCOORD0;
    float3 normal : TEXCOORD1;              // world
    float3 shift : TEXCOORD2;               // from where the field has it, d
    RILL_VIEW_OUTPUT
};

WaterVaryings WaterVertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
{
    WaterVaryings result = (WaterVaryings)0;
    bool drawn = SelectView(instance);
    PassViewOn(result);
    result.clip = kNowhere;
    if (!drawn || all(_PictureBounds == 0.0))
        return result;

    MeshVertex v = LoadMeshVertex(vertex);
    result.shift = MeshShift(v, _DrawnDomainSize.xyz);
    result.world = mul(_DomainToWorld, float4(v.position + result.shift, 1.0)).xyz;
    result.normal = mul((float3x3)_DomainToWorld, v.normal);
    result.clip = WorldToClip(result.world);
    return result;
}

#endif

#endif
