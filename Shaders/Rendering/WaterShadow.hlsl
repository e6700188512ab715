// The mesh of the water in a shadow map, in a pattern with holes: water lets light through, and what is thin more of it. The SubShader around
// it says for which pipeline, see View.hlsl. Includes nothing of Unity's.
//
//   the buffers of MeshVertex.hlsl and MeshField.hlsl
#include "ShadowBias.hlsl"
#include "ShadowPattern.hlsl"
#include "MeshField.hlsl"
#include "MeshVertex.hlsl"

static const float kShadowDepth = 4.0;      // path through water from which it throws a whole shadow, d

static const float kBehind = 1.0;           // d beyond the far side of the water

float _ShadowOpacity;           // 0 to 1
float _ShadowIsBehind;          // 1 where it begins behind the water, 0 at its near side

struct ShadowVaryings
{
    float4 clip : SV_Position;
    float3 world : TEXCOORD0;
    float3 shift : TEXCOORD1;       // from where the field has it, d
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
    MeshVertex v = LoadMeshVertex(vertex);
    result.shift = MeshShift(v, _DrawnDomainSize.xyz);
    result.world = mul(_DomainToWorld, float4(v.position + result.shift, 1.0)).xyz;
    result.clip = ShadowClip(result.world, normalize(mul((float3x3)_DomainToWorld, v.normal)));
    return result;
}

// What stands in the water is lit by CausticLight.hlsl where the shadow begins behind the water.
float4 ShadowFragment(ShadowVaryings input, out float depth : SV_Depth) : SV_Target
{
    RestoreView(input);
    float3 p = mul(_WorldToDomain, float4(input.world, 1.0)).xyz - input.shift;
    float3 along = normalize(mul((float3x3)_WorldToDomain, -ToEye(input.world)));
    float3 wall;
    bool found;
    float end = BoxExit(p, along, wall), path = MarchMesh(p, along, 1.0, 0.0, _ShadowIsBehind > 0.5 ? end : min(end, kShadowDepth), found);
    if (Threshold(uint2(input.clip.xy)) > _ShadowOpacity * saturate(path / kShadowDepth))
        discard;
    depth = input.clip.z;
    if (_ShadowIsBehind > 0.5)
    {
        // As far behind the biased face.
        float3 far = mul(_DomainToWorld, float4(p + along * (path + kBehind), 1.0)).xyz, near = mul(_DomainToWorld, float4(p, 1.0)).xyz;
        depth += DeviceDepth(WorldToClip(far)) - DeviceDepth(WorldToClip(near));
    }
    return depth;
}
