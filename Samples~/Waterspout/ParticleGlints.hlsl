// Glints on the particles of a phase: a quad towards the eye from SV_VertexID. A SubShader defines its pipeline, as View.hlsl has it.
#include "Packages/com.rill.fluids/Shaders/Rendering/View.hlsl"
#include "Packages/com.rill.fluids/Shaders/RillParticles.hlsl"

float4 _Color;
float _Radius;              // spacings
float _Phase;
float _FullSpeed;           // m/s

struct Glint
{
    float4 clip : SV_Position;
    float4 corner : TEXCOORD0;      // xy corner, z brightness; a whole register, as some translators of SV_RenderTargetArrayIndex need it
    RILL_VIEW_OUTPUT
};

Glint GlintVertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
{
    Glint glint = (Glint)0;
    bool drawn = SelectView(instance);
    PassViewOn(glint);
    glint.clip = kNowhere;
    uint i = vertex / 6;
    uint k = vertex % 6;
    if (!drawn || i >= RillCount() || RillPhase(i) != (uint)_Phase)
        return glint;

    glint.corner.xy = float2(k == 0 || k == 2 || k == 3 ? -1.0 : 1.0, k == 0 || k == 1 || k == 4 ? -1.0 : 1.0);
    glint.corner.z = saturate(length(RillVelocity(i)) / _FullSpeed);
    float3 center = RillDrawnPosition(i);
    float3 across = RILL_VIEW_MATRIX[0].xyz * glint.corner.x + RILL_VIEW_MATRIX[1].xyz * glint.corner.y;
    glint.clip = WorldToClip(center + across * (_Radius * RillSpacing()) + ToEye(center) * RillSpacing());
    return glint;
}

float4 GlintFragment(Glint glint) : SV_Target
{
    RestoreView(glint);
    float round = saturate(1.0 - dot(glint.corner.xy, glint.corner.xy));
    return float4(_Color.rgb * (round * round * glint.corner.z), 1.0);
}
