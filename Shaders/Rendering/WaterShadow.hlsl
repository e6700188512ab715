// The water in a shadow map, in a pattern with holes: it lets light through, and what is thin more of it. The far side of the domain's box is drawn,
// and a ray followed to it, but where the map of SunPath.hlsl knows that. The SubShader around it says for which pipeline, see View.hlsl. Includes
// nothing of Unity's.
//
//   the buffers of MeshField.hlsl
//   _SunPaths  in  Texture2D: see SunPath.hlsl
#include "ShadowBias.hlsl"
#include "ShadowPattern.hlsl"
#include "SunPath.hlsl"

static const float kShadowDepth = 4.0;      // path through water from which it throws a whole shadow, d
static const float kBehind = 1.0;           // d beyond the far side of the water

Texture2D<float4> _SunPaths;
float _ShadowOpacity;           // 0 to 1
float _ShadowIsBehind;          // 1 where it begins behind the water, 0 at its near side

struct ShadowVaryings
{
    float4 clip : SV_Position;
    float3 position : TEXCOORD0;        // d
    RILL_VIEW_OUTPUT
};

ShadowVaryings ShadowVertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
{
    static const uint kCorners[6] = { 0, 2, 3, 0, 3, 1 };       // clockwise from outside
    ShadowVaryings result = (ShadowVaryings)0;
    bool drawn = SelectView(instance);
    PassViewOn(result);
    result.clip = kNowhere;
    if (!drawn)
        return result;
    uint face = vertex / 6, axis = face >> 1, corner = kCorners[vertex % 6];
    float side = face & 1, u = corner & 1, v = corner >> 1;
    u = side > 0.5 ? 1.0 - u : u;
    float3 at = axis == 0 ? float3(side, v, 1.0 - u) : axis == 1 ? float3(1.0 - u, side, v) : float3(v, 1.0 - u, side);
    result.position = at * _DrawnDomainSize.xyz;
    result.clip = WorldToClip(mul(_DomainToWorld, float4(result.position, 1.0)).xyz);
    result.clip.z = 0.5 * result.clip.w;        // the water is drawn, not the box
    return result;
}

// Objects in the water are lit by CausticLight.hlsl where the shadow begins behind the water.
float4 ShadowFragment(ShadowVaryings input, out float depth : SV_Depth) : SV_Target
{
    RestoreView(input);
    float3 world = mul(_DomainToWorld, float4(input.position, 1.0)).xyz, toLight = ToEye(world);
    float3 lightward = normalize(mul((float3x3)_WorldToDomain, toLight));
    float4 path;
    if (_SunLight.w > 0.5 && dot(lightward, _SunLight.xyz) > 0.99999)
    {
        float2 texel = float2(dot(_SunAxisX, float4(input.position, 1.0)), dot(_SunAxisY, float4(input.position, 1.0)));
        path = _SunPaths.Load(int3(clamp(texel, 0.0, _SunSize.xy - 1.0), 0));
    }
    else
    {
        float3 wall;
        float near = BoxExit(input.position, lightward, wall);
        if (HomogeneousEye().w != 0.0)
            near = min(near, sqrt(EyeDistanceSquared(world)) / length(_DomainToWorld[0].xyz));
        path = TraceSun(input.position + lightward * near, -lightward);
    }
    // Each hole of the pattern is of another threshold: light ends there where it has passed as much water.
    float needed = Threshold(uint2(input.clip.xy)) / max(_ShadowOpacity, 1e-4) * kShadowDepth;
    bool isFirst = path.y > needed;
    if (!isFirst && path.y + path.w <= needed)
        discard;
    float starts = isFirst ? path.x : path.z;
    float ends = (path.w > 0.0 ? path.z + path.w : path.x + path.y) + kBehind;
    float along = dot(input.position, lightward) + (_ShadowIsBehind > 0.5 ? ends : starts);
    float4 clip = ShadowClip(mul(_DomainToWorld, float4(input.position - lightward * along, 1.0)).xyz, toLight);
    depth = saturate(DeviceDepth(clip));
    return depth;
}
