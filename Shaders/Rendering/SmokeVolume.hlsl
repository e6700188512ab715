// Draws smoke as slices across the view, the farthest first: each a square that hides and adds the light of its part of the path, and that what
// stands before it in the scene hides by its depth. So no pass needs the scene's depth as a texture. The SubShader around it says for which
// pipeline, see View.hlsl. Includes nothing of Unity's.
//
//   _SmokeVolume   in   see Smoke.compute: x extinction, 1/m; y the part of the sun that comes there; z temperature above the air's, K
#include "MainLight.hlsl"
#include "Billboard.hlsl"
#include "DrawnDomain.hlsl"

Texture3D<float4> _SmokeVolume;
SamplerState rill_linear_clamp_sampler;
float4 _SmokeSlices;        // x slices; y from one to the next, m; z radius of the box, m; w light of glowing smoke
float4 _SmokeCells;         // xyz cells of the grid; w temperature of the air, K
float4 _SmokeColor;         // linear
float4 _AmbientColor;       // linear
uint _SmokeOpenSides;       // bit 2 a + b: the lower (b 0) or upper side of the box along axis a is open

static const float kFadeCells = 3.0;        // over which smoke fades before an open side: it would end in a cut
static const float kSunPart = 0.6;          // of the light of the sun that smoke turns to the eye
static const float kScatteredDepth = 0.25;  // of the depth, for light that was scattered more than once ...
static const float kScatteredPart = 0.6;    // ... and its part: after Schneider and Vos 2015
static const float3 kWavelengths = float3(0.61, 0.549, 0.468);       // um, of red, green and blue
static const float kSecondRadiation = 14388.0;      // um K, of Planck's law
static const float kGlowing = 1400.0;       // K, whose red is 1

struct SmokeVaryings
{
    float4 clip : SV_Position;
    float3 world : TEXCOORD0;
    RILL_VIEW_OUTPUT
};

float3 Forward()
{
    return -RILL_VIEW_MATRIX[2].xyz;
}

SmokeVaryings SmokeVertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
{
    SmokeVaryings result = (SmokeVaryings)0;
    bool drawn = SelectView(instance);
    PassViewOn(result);
    result.clip = kNowhere;
    if (!drawn)
        return result;
    float3 center = mul(_DomainToWorld, float4(0.5 * _DrawnDomainSize.xyz, 1.0)).xyz;
    float away = _SmokeSlices.z - (vertex / 6 + 0.5) * _SmokeSlices.y;
    float2 corner = QuadCorner(vertex) * _SmokeSlices.z;
    result.world = center + Forward() * away + RILL_VIEW_MATRIX[0].xyz * corner.x + RILL_VIEW_MATRIX[1].xyz * corner.y;
    result.clip = WorldToClip(result.world);
    return result;
}

// Light that soot of a temperature gives, by Planck's law, over that of red at kGlowing.
float3 Glow(float temperature)
{
    float3 relative = kWavelengths.x / kWavelengths;
    float3 exponent = kSecondRadiation * (1.0 / (kWavelengths.x * kGlowing) - 1.0 / (kWavelengths * max(temperature, 300.0)));
    return relative * relative * relative * relative * relative * exp(min(exponent, 10.0));
}

// 0 at an open side of the box to 1 a few cells inside.
float FadeAtSides(float3 at)
{
    float3 cells = at * _SmokeCells.xyz, beyond = _SmokeCells.xyz - cells;
    float fade = 1.0;
    [unroll]
    for (uint axis = 0; axis < 3; axis++)
    {
        if ((_SmokeOpenSides >> (2 * axis) & 1) != 0)
            fade = min(fade, cells[axis] / kFadeCells);
        if ((_SmokeOpenSides >> (2 * axis + 1) & 1) != 0)
            fade = min(fade, beyond[axis] / kFadeCells);
    }
    return saturate(fade);
}

float4 SmokeFragment(SmokeVaryings input) : SV_Target
{
    RestoreView(input);
    float3 at = mul(_WorldToDomain, float4(input.world, 1.0)).xyz / _DrawnDomainSize.xyz;
    if (any(at < 0.0) || any(at > 1.0))
        discard;
    float4 smoke = _SmokeVolume.SampleLevel(rill_linear_clamp_sampler, at, 0);
    float along = max(-dot(ToEye(input.world), Forward()), 0.05);
    float covered = 1.0 - exp(-smoke.x * FadeAtSides(at) * _SmokeSlices.y / along);
    if (covered < 1e-4)
        discard;
    MainLight light = GetMainLight();
    float sun = max(smoke.y, kScatteredPart * pow(max(smoke.y, 1e-6), kScatteredDepth));
    float3 lit = light.color * (kSunPart * sun * MainLightShadow(light, input.world, WorldToClip(input.world))) + _AmbientColor.rgb;
    return float4((_SmokeColor.rgb * lit + _SmokeSlices.w * Glow(_SmokeCells.w + smoke.z)) * covered, covered);
}
