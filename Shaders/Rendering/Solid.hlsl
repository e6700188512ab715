// A plain lit surface of a mesh. Passes and pipelines as in Particles.hlsl.
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

float4x4 unity_ObjectToWorld;
float4x4 unity_WorldToObject;

#ifdef RILL_PASS_MOTION
#ifdef RILL_BUILT_IN
float4x4 _PreviousM;
#define RILL_PREVIOUS_OBJECT_TO_WORLD _PreviousM
int _HasLastPositionData;               // 1 where the mesh is deformed and brings its last positions
#define RILL_HAS_LAST_POSITION (_HasLastPositionData != 0)
#else
float4x4 unity_MatrixPreviousM;
#define RILL_PREVIOUS_OBJECT_TO_WORLD unity_MatrixPreviousM
#define RILL_HAS_LAST_POSITION (unity_MotionVectorsParams.x > 0.5)
#endif
#endif

#ifdef RILL_PASS_FORWARD
float4 _Color;
float4 _Ambient;
float4 _Sun;                // world, any length: towards the light where the scene has none
float _Tile;                // m, side of square tiles in world space; 0 for a plain surface
#endif

struct SolidVertexInput
{
    float3 position : POSITION;
    float3 normal : NORMAL;
#ifdef RILL_PASS_MOTION
    float3 lastPosition : TEXCOORD4;
#endif
    uint instance : SV_InstanceID;
};

struct SolidVaryings
{
    float4 clip : SV_Position;
    float3 world : TEXCOORD0;
    float3 normal : TEXCOORD1;      // world
#ifdef RILL_PASS_MOTION
    float3 previous : TEXCOORD2;    // world, at the last frame
#endif
    RILL_VIEW_OUTPUT
};

float3 Unit(float3 v)
{
    return v * rsqrt(max(dot(v, v), 1e-20));
}

SolidVaryings SolidVertex(SolidVertexInput input)
{
    SolidVaryings result = (SolidVaryings)0;
    bool drawn = SelectView(input.instance);
    PassViewOn(result);
    result.clip = kNowhere;
    if (!drawn)
        return result;

    result.world = mul(unity_ObjectToWorld, float4(input.position, 1.0)).xyz;
    result.normal = mul(input.normal, (float3x3)unity_WorldToObject);
#if defined(RILL_PASS_SHADOW)
    result.clip = ShadowClip(result.world, Unit(result.normal));
#elif defined(RILL_PASS_MOTION)
    float3 last = RILL_HAS_LAST_POSITION ? input.lastPosition : input.position;
    result.previous = mul(RILL_PREVIOUS_OBJECT_TO_WORLD, float4(last, 1.0)).xyz;
    result.clip = MotionClip(WorldToClip(result.world));
#else
    result.clip = WorldToClip(result.world);
#endif
    return result;
}

#ifdef RILL_PASS_FORWARD
float TileNoise(float2 cell)
{
    return frac(sin(dot(cell, float2(12.9898, 78.233))) * 43758.5453);
}

// Between the values of four corners.
float TileGrain(float2 at)
{
    float2 cell = floor(at), t = at - cell;
    t = t * t * (3.0 - 2.0 * t);
    float low = lerp(TileNoise(cell), TileNoise(cell + float2(1.0, 0.0)), t.x);
    float high = lerp(TileNoise(cell + float2(0.0, 1.0)), TileNoise(cell + float2(1.0, 1.0)), t.x);
    return lerp(low, high, t.y);
}

// Stone tiles: each of its own shade, with grain and darker joints. Where a pixel is wider than what it shows, its mean.
float TileShade(float3 world, float3 normal)
{
    float3 facing = abs(normal);
    float2 at = facing.y >= max(facing.x, facing.z) ? world.xz : facing.x >= facing.z ? world.zy : world.xy;
    at /= max(_Tile, 1e-3);
    float2 cell = floor(at), within = at - cell;
    float pixel = max(max(fwidth(at.x), fwidth(at.y)), 1e-5), seen = saturate(1.0 - pixel * 2.0);
    float2 edge = min(within, 1.0 - within);
    float joint = 0.015;
    float stone = smoothstep(joint - pixel, joint + pixel, min(edge.x, edge.y));
    float shade = 1.0 + seen * (0.14 * (TileNoise(cell + 0.5) - 0.5) + 0.1 * (TileGrain(at * 7.0) - 0.5));
    shade += saturate(1.0 - pixel * 24.0) * 0.08 * (TileGrain(at * 41.0) - 0.5);
    return lerp(lerp(0.97, 0.62, seen), shade, lerp(1.0, stone, seen));
}
#endif

float4 SolidFragment(SolidVaryings input, bool isFront : SV_IsFrontFace) : SV_Target
{
    RestoreView(input);
#if defined(RILL_PASS_FORWARD) || defined(RILL_PASS_NORMALS)
    float3 normal = Unit(input.normal);
    normal = isFront ? normal : -normal;
#endif
#if defined(RILL_PASS_FORWARD)
    MainLight light = GetMainLight();
    float shadow = MainLightShadow(light, input.world, WorldToClip(input.world));
    float3 direct = light.color * (0.75 * saturate(dot(normal, light.direction)) * shadow);
    float shade = _Tile > 0.0 ? TileShade(input.world, normal) : 1.0;
    return float4(_Color.rgb * shade * min(_Ambient.rgb + direct, 1.0), _Color.a);
#elif defined(RILL_PASS_NORMALS)
    return ScreenNormal(normal);
#elif defined(RILL_PASS_MOTION)
    return ScreenMotion(input.world, input.previous);
#else
    return input.clip.z;
#endif
}
