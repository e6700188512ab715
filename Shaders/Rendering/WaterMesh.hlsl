// The mesh of the water's surface at the time of the frame: vertices go on along their displacement. Include after View.hlsl and, but
// for a shadow map, SurfaceView.hlsl.
//
//   the buffer of MeshVertex.hlsl
#ifndef RILL_WATER_MESH_INCLUDED
#define RILL_WATER_MESH_INCLUDED

#include "DrawnDomain.hlsl"
#include "MeshVertex.hlsl"

#ifndef RILL_SHADOW_VIEW
struct WaterVaryings
{
    precise float4 clip : SV_Position;      // the same to the bit in the pass of depth
    float3 world : TEXCOORD0;
    float3 drawn : TEXCOORD1;               // the same in the domain's frame, d
    float3 normal : TEXCOORD2;              // domain
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
    result.drawn = v.position + MeshShift(v, _DrawnDomainSize.xyz);
    result.world = mul(_DomainToWorld, float4(result.drawn, 1.0)).xyz;
    result.normal = v.normal;
    result.clip = WorldToClip(result.world);
    return result;
}

#endif

#endif
