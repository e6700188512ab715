// Draws each particle of foam as a small soft disc towards the eye, over what is drawn already and behind what is nearer. The
// SubShader around it says for which pipeline, see View.hlsl. Includes nothing of Unity's.
//
//   _FoamParticles   in   see Foam.hlsl
#include "MainLight.hlsl"
#include "Billboard.hlsl"
#include "Foam.hlsl"

StructuredBuffer<FoamParticle> _FoamParticles;
float4x4 _DomainToWorld;        // from the domain's frame in d to world, meters
float4 _FrameLag;               // y time of this frame since the newest state, s
float4 _DrawnDomainSize;        // xyz, d
// x largest radius, m; y how much nearer to the eye it is drawn, so that what carries it does not cover it, m; z opacity
float4 _FoamLook;
float4 _FoamColor;              // linear
float4 _AmbientColor;           // linear

struct FoamVaryings
{
    float4 clip : SV_Position;
    float4 world : TEXCOORD0;           // on the disc; w opacity
    float4 corner : TEXCOORD1;          // xy on the disc, its edge at 1
    RILL_VIEW_OUTPUT
};

FoamVaryings FoamVertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
{
    FoamVaryings result = (FoamVaryings)0;
    bool drawn = SelectView(instance);
    PassViewOn(result);
    result.clip = kNowhere;
    if (!drawn)
        return result;
    FoamParticle particle = _FoamParticles[vertex / 6];
    if (FoamKind(particle) == kNoFoam)
        return result;

    float2 corner = QuadCorner(vertex);
    float3 center = mul(_DomainToWorld, float4(DrawnFoamPosition(particle, _FrameLag.y, _DrawnDomainSize.xyz), 1.0)).xyz;
    center += ToEye(center) * _FoamLook.y;
    result.world = float4(PointOnQuad(center, corner, DrawnFoamRadius(particle, _FoamLook.x)), DrawnFoamOpacity(particle, _FoamLook.z));
    result.corner = float4(corner, 0.0, 0.0);
    result.clip = WorldToClip(result.world.xyz);
    return result;
}

float4 FoamFragment(FoamVaryings input) : SV_Target
{
    RestoreView(input);
    float inside = saturate(1.0 - dot(input.corner.xy, input.corner.xy));
    MainLight light = GetMainLight();
    float3 lightColor = light.color * MainLightShadow(light, input.world.xyz, WorldToClip(input.world.xyz));
    // Foam scatters light to all sides: what comes from above lights it whichever way the disc faces.
    float3 lit = _FoamColor.rgb * (_AmbientColor.rgb + lightColor * (0.35 + 0.45 * saturate(light.direction.y)));
    return float4(lit, input.world.w * inside * (2.0 - inside));
}
