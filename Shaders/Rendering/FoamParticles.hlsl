// Draws each particle of foam over what is drawn already and behind what is nearer: foam as a patch of small cells that opens as it ages,
// spray as a streak along its path during the exposure. How much of the picture all of them cover is the same at any size of the picture. The
// SubShader around it says for which pipeline, see View.hlsl. Includes nothing of Unity's.
//
//   _FoamParticles   in   see Foam.hlsl
#define RILL_PICTURE_SIZE
#include "MainLight.hlsl"
#include "Billboard.hlsl"
#include "Foam.hlsl"
#include "../Gpu/Hash.hlsl"

StructuredBuffer<FoamParticle> _FoamParticles;
float4x4 _DomainToWorld;        // from the domain's frame in d to world, meters
float4 _FrameLag;               // y time of this frame since the newest state, s
float4 _DrawnDomainSize;        // xyz, d
// x largest radius, m; y how much nearer to the eye it is drawn, so that what carries it does not cover it, m; z opacity; w exposure, s
float4 _FoamLook;
float4 _FoamColor;              // linear
float4 _AmbientColor;           // linear

static const float kMinPixels = 0.6;        // radius on the picture: a smaller particle is fainter instead
static const float kSeenCell = 1.5;         // pixels from center to center, from which on cells are seen; of smaller ones the mean is
static const float kCells = 2.5;            // of foam, in a particle's radius
static const float kSoft = 0.12;            // how soft their edges are, of what covers

struct FoamVaryings
{
    float4 clip : SV_Position;
    float4 world : TEXCOORD0;           // on the quad; w how much its center covers
    float4 corner : TEXCOORD1;          // xy on the quad, its edge at 1; z size of a cell, pixels, 0 without cells; w random
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
    uint kind = FoamKind(particle);
    if (kind == kNoFoam)
        return result;

    float3 center = mul(_DomainToWorld, float4(DrawnFoamPosition(particle, _FrameLag.y, _DrawnDomainSize.xyz), 1.0)).xyz;
    center += ToEye(center) * _FoamLook.y;
    float3 ray = -ToEye(center), flown = 0.0;
    if (kind == kSpray)
        flown = mul((float3x3)_DomainToWorld, FoamVelocity(particle)) * _FoamLook.w;
    flown -= ray * dot(flown, ray);
    float path = length(flown);
    float3 side = path > 1e-6 ? flown / path : SideOf(ray);

    // Wider or longer than the particle, it covers less: the sum stays.
    float pixels = PixelsPerMeter(center), radius = DrawnFoamRadius(particle, _FoamLook.x);
    float across = max(radius, kMinPixels / pixels), along = max(radius + 0.5 * path, across);
    float2 corner = QuadCorner(vertex);
    result.world.xyz = center + side * (corner.x * along) + cross(ray, side) * (corner.y * across);
    result.world.w = DrawnFoamOpacity(particle, _FoamLook.z) * radius * radius / (across * along);
    result.corner = float4(corner, kind == kFoam ? radius * pixels / kCells : 0.0, FoamRandom(particle));
    result.clip = WorldToClip(result.world.xyz);
    return result;
}

// How far a point is from the center of a cell, as the part of all points that is nearer: evenly spread over 0 to 1.
float RankInCells(float2 at, uint seed)
{
    int2 first = int2(floor(at));
    float nearest = 8.0;
    [unroll]
    for (int y = -1; y <= 1; y++)
    {
        [unroll]
        for (int x = -1; x <= 1; x++)
        {
            int2 cell = first + int2(x, y);
            uint hash = Hash(asuint(cell.x), asuint(cell.y), seed);
            float2 offset = cell + float2(UnitFloat(hash), UnitFloat(Hash(hash))) - at;
            nearest = min(nearest, dot(offset, offset));
        }
    }
    return 1.0 - exp(-pow(2.04 * sqrt(nearest), 2.35));       // fitted to 30,000 points, within 0.016
}

// Partial foam covers the rims of its cells.
float InCells(float covered, float2 at, float cellPixels, uint seed)
{
    float rim = CoveredByRank(covered, RankInCells(at, seed), kSoft);
    return lerp(covered, rim, saturate(cellPixels / kSeenCell - 1.0));
}

float4 FoamFragment(FoamVaryings input) : SV_Target
{
    RestoreView(input);
    float inside = saturate(1.0 - dot(input.corner.xy, input.corner.xy));
    float covered = saturate(input.world.w * inside * (2.0 - inside));
    if (input.corner.z > kSeenCell)
    {
        float angle = 6.2831853 * input.corner.w, s = sin(angle), c = cos(angle);
        float2 turned = float2(c * input.corner.x - s * input.corner.y, s * input.corner.x + c * input.corner.y);
        covered = InCells(covered, turned * kCells, input.corner.z, uint(input.corner.w * 255.0 + 0.5));
    }
    MainLight light = GetMainLight();
    float3 lightColor = light.color * MainLightShadow(light, input.world.xyz, WorldToClip(input.world.xyz));
    // Foam scatters light to all sides: what comes from above lights it wherever the disc faces.
    float3 lit = _FoamColor.rgb * (_AmbientColor.rgb + lightColor * (0.35 + 0.45 * saturate(light.direction.y)));
    return float4(lit, covered);
}
