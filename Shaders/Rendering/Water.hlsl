// Shades the water: rectangles over the textures that WaterRays.compute has filled for this camera, with depth, or, in RILL_UNDER_WATER, all that
// an eye in the water sees, whose rays it follows itself. The SubShader around it says for which pipeline, see View.hlsl. Includes nothing of
// Unity's.
//
//   _Bubbles      in   see SprayLayer.hlsl; where RILL_FOAM is on
//   _RayFaces, _RayEnds, _RayDirections, _RayMirrors  in  Texture2DArrays, a slice for each eye, see WaterRays.compute
//   _RaySun       in   Texture2DArray, see there too; read where _CausticLight.w is not 0
//   _RayPhases    in   Texture2DArray, see there too; read where _HasPhases is 1, as is that of PhaseGrid.hlsl: a keyword would double the variants
//   the buffers of MeshField.hlsl, in RILL_UNDER_WATER
//   the scene's color, where RILL_REFRACTION is on, and its depth, as the pipeline gives them
#define RILL_PHASES
#include "SurfaceView.hlsl"
#include "MainLight.hlsl"
#include "Environment.hlsl"
#include "Fog.hlsl"
#include "SceneColor.hlsl"
#include "WaterRays.hlsl"
#include "WaterTile.hlsl"
#include "Medium.hlsl"

static const float kMaxBrightening = 32.0;      // of what stands in the water, by the sun
static const float kSameLight = 0.999;          // cosine between the main light and that of the caustics
static const float kSeenBorder = 0.02, kMirrorBorder = 0.1;    // of half the picture's width: over which the scene fades to what is around

// ---- optics

// GGX (Walter et al. 2007) with the visibility of Hammon 2017, for a light of unit radiance times pi. alpha: squared roughness.
float Highlight(float3 normal, float3 toEye, float3 toLight, float alpha)
{
    float3 halfway = toEye + toLight;
    halfway *= rsqrt(max(dot(halfway, halfway), 1e-12));
    float nl = saturate(dot(normal, toLight)), nv = saturate(dot(normal, toEye)) + 1e-4, nh = saturate(dot(normal, halfway));
    float squared = alpha * alpha, spread = nh * nh * (squared - 1.0) + 1.0;
    float visibility = 0.5 / max(lerp(2.0 * nl * nv, nl + nv, alpha), 1e-4);
    return min(squared / (spread * spread) * visibility * Reflectance(dot(toLight, halfway), 1.0 / _SurfaceOptics.x) * nl, 64.0);
}

MainLight LightOfWater()
{
    MainLight light = GetMainLight();
#if defined(RILL_HIGH_DEFINITION)
    light.color *= RILL_EXPOSURE / 3.14159265;      // from lux to the radiance of a white surface
#endif
    return light;
}

// Light that scattering in deep water sends to the eye in the end.
float3 ScatteredLight(Medium medium, float3 around, float3 lightColor, float toLight)
{
    return (around + lightColor * (0.5 * saturate(toLight) + 0.25)) * medium.color;
}

// Returns one medium for all of a ray's path.
Medium MediumAlong(WaterRay ray)
{
    Medium medium = MediumOfLook();
    if (_HasPhases > 0.5)
        medium = Stirred(ray.phases);
    return medium;
}

#ifdef RILL_REFRACTION
#include "CausticLight.hlsl"

float3 SceneColorAt(float2 picture)
{
    return RILL_SCENE_COLOR(picture * 0.5 + 0.5).rgb;
}

// Returns the color of the scene at the end of a ray, which stands in the water. The picture has it lit as if there were none: its direct light, as
// far as the main light and the ambient light let one tell, is changed.
float3 SceneInWater(WaterRay ray, MainLight light)
{
    float3 color = SceneColorAt(ray.picture);
    if (ray.sun.w > 0.0 && dot(light.direction, ToSun()) > kSameLight)
    {
        float3 world = ScenePoint(ray.picture, SceneDepthAt(ray.picture, eyeIndex)), normal = ray.direction;
        float3 sun = light.color * MainLightShadow(light, world, WorldToClip(world)), ambient = AmbientOfScene(normal);
        float3 dry = ambient + sun * max(dot(normal, light.direction), 0.0), wet = ambient + sun * ray.sun.rgb;
        color *= dry > 1e-5 ? min(wet / max(dry, 1e-5), kMaxBrightening) : 1.0;
    }
    return color;
}

// Light from the end of a ray and from along it. world: where it begins; lit: see ScatteredLight.
float3 SeenAlong(WaterRay ray, Medium medium, MainLight light, float3 world, float3 lit)
{
    float3 rate = medium.absorption + medium.scattering;
    float3 color = lit * (1.0 - exp(-medium.scattering * ray.path));
    if (ray.mirrored > 0.0)
    {
        float3 mirrored = ray.turnsInWater ? lit : Mirrored(world, ray.turned, 0.0);
        color += ray.mirrored * exp(-rate * ray.path * ray.turnedPath) * mirrored;
    }
    float3 end = lit;
    if (ray.ends == kEndsInAir || ray.ends == kEndsAround)
        end = Mirrored(world, ray.direction, 0.0);
    if (ray.ends == kEndsInAir)
        end = lerp(end, SceneColorAt(ray.picture), BorderFade(ray.picture, kSeenBorder));
    else if (ray.ends == kEndsUnderWater)
        end = SceneInWater(ray, light);
    else if (ray.ends == kEndsAtWall)
        end = SceneColorAt(ray.picture);
    return color + (1.0 - ray.mirrored) * exp(-rate * ray.path) * end;
}

#endif

#ifdef RILL_UNDER_WATER

struct UnderWaterVaryings
{
    float4 clip : SV_Position;
    float4 picture : TEXCOORD0;     // xy
    RILL_VIEW_OUTPUT
};

bool IsInWater(float3 p)
{
    return all(p >= 0.0) && all(p <= _DrawnDomainSize.xyz) && MeshDistance(p) > 0.0;
}

float3 OnNearPlane(float2 picture)
{
    SurfaceRay ray = RayThrough(picture, eyeIndex);
    return ray.origin + ray.direction * FromSurfaceDepth(1.0, eyeIndex);
}

UnderWaterVaryings UnderWaterVertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
{
    UnderWaterVaryings result = (UnderWaterVaryings)0;
    bool drawn = SelectView(instance);
    PassViewOn(result);
    result.clip = kNowhere;
    if (!drawn || all(_PictureBounds == 0.0))
        return result;

    // Nothing where no part of the near plane can be in the water.
    float3 center = InDomain(OnNearPlane(0.0));
    float radius = length(InDomain(OnNearPlane(1.0)) - center);
    float3 nearest = clamp(center, 0.0, _DrawnDomainSize.xyz);
    if (distance(center, nearest) > radius || MeshDistance(nearest) < -min(radius + 0.5, 0.9 * kMeshFar) && radius < 0.9 * kMeshFar - 0.5)
        return result;
    float2 picture = RectangleCorner(vertex, -1.0, 1.0);
    SurfaceRay ray = RayThrough(picture, eyeIndex);
    result.clip = WorldToClip(ray.origin + ray.direction * FromSurfaceDepth(0.5, eyeIndex));
    result.clip.z = 0.5 * result.clip.w;        // whatever an oblique near plane makes of it
    result.picture = float4(picture, 0.0, 0.0);
    return result;
}

float4 UnderWaterFragment(UnderWaterVaryings input) : SV_Target
{
    RestoreView(input);
    float2 picture = input.picture.xy;
    float3 world = OnNearPlane(picture), p = InDomain(world);
    if (!IsInWater(p))
        discard;
    SurfaceRay ray = RayThrough(picture, eyeIndex);
    float3 along = normalize(mul((float3x3)_WorldToDomain, ray.direction));
    MainLight light = LightOfWater();
    float3 lightColor = light.color * MainLightShadow(light, world, WorldToClip(world));
    float3 around = Ambient(world, float3(0.0, 1.0, 0.0));
#ifdef RILL_REFRACTION
    WaterRay traced = TraceWater(p, along);
    FindSunlight(traced);
    Medium medium = MediumAlong(traced);
    return float4(SeenAlong(traced, medium, light, world, ScatteredLight(medium, around, lightColor, light.direction.y)), 1.0);
#else
    float3 wall;
    bool found;
    float end = BoxExit(p, along, wall), z = SceneDepthAt(picture, eyeIndex) - FromSurfaceDepth(1.0, eyeIndex);
    float path = min(MarchMesh(p, along, 1.0, 0.0, end, found) * Spacing(), z * length(ray.direction));
    Medium medium = MediumAlong(p, along, path / Spacing());
    float3 lit = ScatteredLight(medium, around, lightColor, light.direction.y);
    float through = dot(exp(-(medium.absorption + medium.scattering) * path), 1.0 / 3.0);
    return float4(lit * (1.0 - exp(-medium.scattering * path)), 1.0 - through);
#endif
}

#else

#ifdef RILL_FOAM
#include "SprayLayer.hlsl"
#endif

Texture2DArray<float4> _RayFaces;
Texture2DArray<float4> _RayEnds;
Texture2DArray<float4> _RayDirections;
Texture2DArray<float4> _RayMirrors;
Texture2DArray<float4> _RaySun;
Texture2DArray<float4> _RayPhases;

struct WaterPoint
{
    float3 world;
    float3 normal;
    float3 toEye;
    float z;                // depth along the view, m
    float alpha;            // squared roughness
    WaterRay ray;
    float2 mirrored;        // what the surface mirrors, see PackedRay
};

// Returns the nearest ray. Where rays are fewer than pixels its ends lie between those of the rays around that end on the same.
PackedRay RayAt(float2 picture)
{
    int4 texel = int4(clamp(TexelsAt(picture, _FoamSize, _FoamWindow), 0.0, _FoamWindow.zw - 1.0), eyeIndex, 0);
    PackedRay ray;
    ray.ends = _RayEnds.Load(texel);
    ray.directions = _RayDirections.Load(texel);
    ray.mirrored = _RayMirrors.Load(texel);
    ray.sun = 0.0;
#ifdef RILL_REFRACTION
    if (_CausticLight.w > 0.0)
        ray.sun = _RaySun.Load(texel);
#endif
    ray.phases = 0.0;
    if (_HasPhases > 0.5)
        ray.phases = _RayPhases.Load(texel).xyz;
    if (_FoamSize.x < _SurfaceSize.x)
    {
        float3 at = PointOfLayer(_RayEnds, picture, eyeIndex);
        if (all(_RayEnds.GatherAlpha(rill_linear_clamp_sampler, at) == ray.ends.w))
        {
            ray.ends.xyz = _RayEnds.SampleLevel(rill_linear_clamp_sampler, at, 0).xyz;
#ifdef RILL_REFRACTION
            if (_CausticLight.w > 0.0 && all(_RaySun.GatherAlpha(rill_linear_clamp_sampler, at) > 0.0))
                ray.sun = _RaySun.SampleLevel(rill_linear_clamp_sampler, at, 0);
#endif
        }
        if (all(_RayMirrors.GatherRed(rill_linear_clamp_sampler, at) < kNoPoint))
            ray.mirrored = _RayMirrors.SampleLevel(rill_linear_clamp_sampler, at, 0);
    }
    return ray;
}

WaterPoint PointOn(float2 picture)
{
    int4 texel = int4(SurfaceTexel(picture), eyeIndex, 0);
    float4 face = _RayFaces.Load(texel);
    if (face.x == 0.0)
        discard;
    WaterPoint p;
    p.normal = UnpackDirection(face.yz);
    SurfaceRay view = RayThrough(picture, eyeIndex), center = RayThrough(TexelPicture(texel.xy), eyeIndex);
    p.z = FromSurfaceDepth(face.x, eyeIndex);
    // From the center of the texel along its plane: no steps where textures are smaller than the screen.
    float3 there = center.origin + center.direction * p.z;
    float z = dot(p.normal, there - view.origin) / min(dot(p.normal, view.direction), -1e-4);
    p.z = abs(z - p.z) < 0.02 * p.z ? z : p.z;
    p.world = view.origin + view.direction * p.z;
    p.toEye = -normalize(view.direction);
    p.normal = FacingNormal(p.normal, p.toEye);
    // With the roughness of normals that differ within a pixel (Tokuyoshi and Kaplanyan 2019).
    float alpha = max(_SurfaceOptics.z * _SurfaceOptics.z, 0.002);
    p.alpha = sqrt(saturate(alpha * alpha + min(2.0 * 0.15915494 * face.w, 0.18)));

    PackedRay packed = RayAt(picture);
    p.ray = UnpackRay(packed, picture);
    p.mirrored = packed.mirrored.x == kNoPoint ? kNoPoint : packed.mirrored.xy + picture;
    return p;
}

// Returns what the surface mirrors: the scene where the ray meets it on the picture, else the surroundings.
float3 Reflected(float3 world, float3 direction, float roughness, float2 picture)
{
    float3 color = Mirrored(world, direction, roughness);
#ifdef RILL_REFRACTION
    if (picture.x != kNoPoint)
    {
        float shown = BorderFade(picture, kMirrorBorder) * saturate(2.0 - 4.0 * roughness);
        color = lerp(color, SceneColorAt(picture) * _ReflectionStrength, shown);
    }
#endif
    return color;
}

float4 WaterFragment(SurfaceVaryings input, out float depth : SV_Depth) : SV_Target
{
    RestoreView(input);
    WaterPoint p = PointOn(input.picture.xy);
    float4 clip = WorldToClip(p.world);
    depth = DeviceDepth(clip);

    MainLight light = LightOfWater();
    float3 lightColor = light.color * MainLightShadow(light, p.world + light.direction * _SurfaceOptics.w, clip);
    float reflectance = Reflectance(dot(p.normal, p.toEye), 1.0 / _SurfaceOptics.x);
    float3 mirrored = Reflected(p.world, reflect(-p.toEye, p.normal), sqrt(p.alpha), p.mirrored) * reflectance
        + lightColor * Highlight(p.normal, p.toEye, light.direction, p.alpha);
    float3 around = Ambient(p.world, p.normal);
    float toLight = dot(p.normal, light.direction);
    Medium medium = MediumAlong(p.ray);
    float3 lit = ScatteredLight(medium, around, lightColor, toLight);
    float covered = 0.0;
    float3 bubbles = 0.0;
#ifdef RILL_FOAM
    float2 under = BubblesAt(input.picture.xy, eyeIndex, rill_linear_clamp_sampler);
    under.y = min(under.y, p.ray.path);
    covered = under.x;
    bubbles = LitFoam(around, lightColor, toLight) * exp(-(medium.absorption + medium.scattering) * under.y)
        + lit * (1.0 - exp(-medium.scattering * under.y));
#endif

#ifdef RILL_REFRACTION
    float3 color = lerp(SeenAlong(p.ray, medium, light, p.world, lit), bubbles, covered) * (1.0 - reflectance) + mirrored;
    float coverage = 1.0;
#else
    float3 through = exp(-(medium.absorption + medium.scattering) * p.ray.path) * (1.0 - covered);
    float coverage = 1.0 - (1.0 - reflectance) * dot(through, 1.0 / 3.0);
    float3 color = lerp(lit * (1.0 - exp(-medium.scattering * p.ray.path)), bubbles, covered) * (1.0 - reflectance) + mirrored;
#endif
    return float4(ApplyFog(color, coverage, p.z), coverage);
}

#endif
