// The ellipsoids of the water's surface in a shadow map, in a pattern with holes: water lets light through. The SubShader around it
// says for which pipeline, see View.hlsl. Includes nothing of Unity's.
//
//   the buffers of DrawnSurface.hlsl
#include "ShadowBias.hlsl"
#include "Billboard.hlsl"
#include "ShadowPattern.hlsl"
#include "DrawnSurface.hlsl"

static const float kShadowDepth = 4.0;      // path through drops, sheets and spray from which they throw a whole shadow, d

float _ShadowOpacity;           // 0 to 1

struct ShadowVaryings
{
    float4 clip : SV_Position;
    float3 world : TEXCOORD0;                   // on the quad
    nointerpolation float4 center : TEXCOORD1;  // w: 1 / kShadowDepth, 1/m; 0 for a disc, which is the top of deeper water
    nointerpolation float4 a : TEXCOORD2;       // semi-axes
    nointerpolation float4 b : TEXCOORD3;
    nointerpolation float4 c : TEXCOORD4;
    RILL_VIEW_OUTPUT
};

ShadowVaryings ShadowVertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
{
    ShadowVaryings result = (ShadowVaryings)0;
    bool drawn = SelectView(instance);
    PassViewOn(result);
    result.clip = kNowhere;
    if (!drawn)
        return result;

    Ellipsoid e = DrawnEllipsoid(vertex / 6);
    float spacing = length(mul((float3x3)_DomainToWorld, float3(1, 0, 0)));
    result.center = float4(e.center, IsDisc(_SurfaceParticles[vertex / 6]) ? 0.0 : 1.0 / (kShadowDepth * spacing));
    result.a = float4(e.a, 0.0);
    result.b = float4(e.b, 0.0);
    result.c = float4(e.c, 0.0);

    // A quad that holds the ball around the ellipsoid.
    float squared = max(max(dot(e.a, e.a), dot(e.b, e.b)), dot(e.c, e.c));
    result.world = PointOnQuad(e.center, QuadCorner(vertex), SilhouetteRadius(e.center, sqrt(squared)));
    result.clip = WorldToClip(result.world);
    return result;
}

float4 ShadowFragment(ShadowVaryings input, out float depth : SV_Depth) : SV_Target
{
    RestoreView(input);
    Ellipsoid e;
    e.center = input.center.xyz;
    e.a = input.a.xyz;
    e.b = input.b.xyz;
    e.c = input.c.xyz;
    float3 ray = -ToEye(input.world);
    float2 hit;
    if (!HitBall(ToBall(e, input.world - e.center), ToBall(e, ray), hit))
        discard;
    float fraction = input.center.w > 0.0 ? saturate((hit.y - hit.x) * input.center.w) : 1.0;
    if (Threshold(uint2(input.clip.xy)) > _ShadowOpacity * fraction)
        discard;
    float3 world = input.world + ray * hit.x;
    depth = DeviceDepth(ShadowClip(world, EllipsoidNormal(e, world)));
    return depth;
}
