// Finds the sunlight that has come through the water's surface onto the scene in it, by the map of CausticMap.hlsl. The kernel of the rays does so,
// and an eye in the water itself. Include after WaterRays.hlsl and Medium.hlsl.
//
//   _CausticMap     in  Texture2D, see CausticMap.hlsl
#ifndef RILL_CAUSTIC_LIGHT_INCLUDED
#define RILL_CAUSTIC_LIGHT_INCLUDED

#include "CausticMap.hlsl"

Texture2D<float4> _CausticMap;

static const float kMinCosine = 0.05;

// Returns the direction to the light that the map is of, world.
float3 ToSun()
{
    return normalize(mul((float3x3)_DomainToWorld, _CausticLight.xyz));
}

// xy: light and light times path of a layer.
float2 CausticsIn(uint layer, float2 texel)
{
    float2 at = CausticCorner(layer) + clamp(texel, 0.5, _CausticSize.xy - 0.5);
    return _CausticMap.SampleLevel(rill_field_linear_clamp_sampler, at / (_CausticSize.xy * _CausticSize.zw + float2(0.0, 1.0)), 0).xy;
}

// Returns the caustics at a point in the water, d.
float2 CausticsAt(float3 p)
{
    float range = _CausticMap.Load(int3(CausticRangeTexel(), 0)).x, last = _CausticLight.w - 1.0;
    float at = clamp((1.0 - CausticHeight(p) / max(range, 1e-3)) * last, 0.0, last);
    uint layer = (uint)min(floor(at), max(last - 1.0, 0.0));
    float2 texel = InCausticMap(p);
    return lerp(CausticsIn(layer, texel), CausticsIn(layer + 1, texel), at - layer);
}

float3 ScenePoint(float2 picture, float z)
{
    SurfaceRay ray = RayThrough(picture, eyeIndex);
    return ray.origin + ray.direction * z;
}

// Along an axis of the picture, on that side where the depth changes less.
float3 SceneStep(float2 picture, float2 texel, float z, float3 at)
{
    float before = SceneDepthAt(picture - texel, eyeIndex), after = SceneDepthAt(picture + texel, eyeIndex);
    bool isBefore = abs(before - z) < abs(after - z);
    float3 other = ScenePoint(isBefore ? picture - texel : picture + texel, isBefore ? before : after);
    return isBefore ? at - other : other - at;
}

// Finds the sunlight where a ray ends: ray.sun, and in its direction the normal there. Nothing but for the scene in the water, on the map.
void FindSunlight(inout WaterRay ray)
{
    ray.sun = 0.0;
    if (_CausticLight.w == 0.0 || ray.ends != kEndsUnderWater)
        return;
    float2 size = SceneSize(), texel = 2.0 / size, picture = (floor((ray.picture * 0.5 + 0.5) * size) + 0.5) * texel - 1.0;
    float z = SceneDepthAt(picture, eyeIndex);
    float3 world = ScenePoint(picture, z), p = mul(_WorldToDomain, float4(world, 1.0)).xyz;
    float2 inMap = InCausticMap(p);
    if (any(inMap < 0.0) || any(inMap > _CausticSize.xy))
        return;

    float3 normal = cross(SceneStep(picture, float2(texel.x, 0.0), z, world), SceneStep(picture, float2(0.0, texel.y), z, world));
    normal *= rsqrt(max(dot(normal, normal), 1e-24)) * (dot(normal, RayThrough(picture, eyeIndex).direction) > 0.0 ? -1.0 : 1.0);

    // A layer tells what crosses it; what faces otherwise gets more or less of the bundle, which goes down as through calm water.
    float2 caustics = CausticsAt(p);
    float path = caustics.y / max(caustics.x, 1e-4);
    float3 toLight = ToSun(), up = normalize(mul((float3x3)_DomainToWorld, _CausticUp.xyz));
    float3 calm = normalize(lerp(toLight, -refract(-toLight, up, 1.0 / _SurfaceOptics.x), saturate(path)));
    float turned = max(dot(normal, calm), 0.0) * max(dot(up, toLight), kMinCosine) / max(dot(up, calm), kMinCosine);
    Medium medium = MediumAlong(p, normalize(mul((float3x3)_WorldToDomain, calm)), path);
    ray.sun = float4(turned * caustics.x * exp(-(medium.absorption + medium.scattering) * path * Spacing()), 1.0);
    ray.direction = normal;
}

#endif
