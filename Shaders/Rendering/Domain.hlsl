// The fluid's box: a chequered floor and twelve edges, from SV_VertexID alone. Passes and pipelines as in Particles.hlsl.
#if defined(RILL_PASS_FORWARD)
#include "MainLight.hlsl"
#elif defined(RILL_PASS_NORMALS)
#include "View.hlsl"
#include "ScreenNormal.hlsl"
#elif defined(RILL_PASS_SHADOW)
#include "ShadowBias.hlsl"
#elif defined(RILL_PASS_MOTION)
#include "ScreenMotion.hlsl"
#else
#include "View.hlsl"
#endif
#include "../Generated/Domain.hlsl"

float4x4 _BoxToWorld;           // unit cube, corner at 0, to world
float4x4 _LastBoxToWorld;       // at the frame before
float4 _BoxSize;                // m
float4 _LineColor;              // linear
float4 _FloorColor;             // linear
float _FloorTile;               // m
float _DrawFloor;               // 1 floor, 0 edges

struct DomainVaryings
{
    float4 clip : SV_Position;
    float3 box : TEXCOORD0;     // unit cube
    RILL_VIEW_OUTPUT
};

// Ends of the edges as corner numbers, bit 0 x, bit 1 y, bit 2 z.
static const uint kEdges[kEdgeVertices] = { 0,1, 2,3, 4,5, 6,7, 0,2, 1,3, 4,6, 5,7, 0,4, 1,5, 2,6, 3,7 };
static const uint kFloor[kFloorVertices] = { 0,4,5, 0,5,1 };

float3 FloorNormal()
{
    float3 up = cross(mul(_BoxToWorld, float4(0, 0, 1, 0)).xyz, mul(_BoxToWorld, float4(1, 0, 0, 0)).xyz);
    return up * rsqrt(max(dot(up, up), 1e-30));
}

DomainVaryings DomainVertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
{
    DomainVaryings result = (DomainVaryings)0;
    bool drawn = SelectView(instance);
    PassViewOn(result);
    result.clip = kNowhere;
    if (!drawn)
        return result;

    uint corner = _DrawFloor > 0.5 ? kFloor[vertex % kFloorVertices] : kEdges[vertex % kEdgeVertices];
    result.box = float3(corner & 1, (corner >> 1) & 1, corner >> 2);
    float3 world = mul(_BoxToWorld, float4(result.box, 1.0)).xyz;
#if defined(RILL_PASS_SHADOW)
    result.clip = ShadowClip(world, FloorNormal());
#elif defined(RILL_PASS_MOTION)
    result.clip = MotionClip(WorldToClip(world));
#else
    result.clip = WorldToClip(world);
#endif
    return result;
}

float4 DomainFragment(DomainVaryings input) : SV_Target
{
    RestoreView(input);
#if defined(RILL_PASS_FORWARD)
    if (_DrawFloor < 0.5)
        return float4(_LineColor.rgb, 1.0);
    float2 tile = floor(input.box.xz * _BoxSize.xz / max(_FloorTile, 1e-6));
    float odd = frac((tile.x + tile.y) * 0.5) * 2.0;
    float3 world = mul(_BoxToWorld, float4(input.box, 1.0)).xyz;
    float shadow = MainLightShadow(GetMainLight(), world, WorldToClip(world));
    return float4(_FloorColor.rgb * ((1.0 - 0.18 * odd) * (0.6 + 0.4 * shadow)), 1.0);
#elif defined(RILL_PASS_NORMALS)
    return ScreenNormal(_DrawFloor > 0.5 ? FloorNormal() : ToEye(mul(_BoxToWorld, float4(input.box, 1.0)).xyz));
#elif defined(RILL_PASS_MOTION)
    return ScreenMotion(mul(_BoxToWorld, float4(input.box, 1.0)).xyz, mul(_LastBoxToWorld, float4(input.box, 1.0)).xyz);
#else
    return input.clip.z;
#endif
}
