// Shades the water: the front faces of its mesh, by the rays that WaterRays.compute has followed, or, in RILL_UNDER_WATER, all that an eye in the
// water sees, whose rays it follows itself. The SubShader around it says for which pipeline, see View.hlsl. Includes nothing of Unity's.
//
//   _RayEnds, _RayDirections, _RayMirrors  in  Texture2DArrays, a slice for each eye, see PackedRay
//   the buffers of WaterMesh.hlsl and MeshField.hlsl
//   the scene's color, where RILL_REFRACTION is on, and its depth, as the pipeline gives them
#include "SurfaceView.hlsl"
#include "MainLight.hlsl"
#include "Environment.hlsl"
#include "Fog.hlsl"
#include "SceneColor.hlsl"
#include "WaterRays.hlsl"
#include "WaterMesh.hlsl"
#include "WaterFace.hlsl"

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

// Squared GGX roughness with that of normals that differ within a pixel (Tokuyoshi and Kaplanyan 2019).
float FilteredAlpha(float3 normal, float roughness)
{
    float3 x = ddx(normal), y = ddy(normal);
    float spread = min(2.0 * 0.15915494 * (dot(x, x) + dot(y, y)), 0.18);
    float alpha = max(roughness * roughness, 0.002);
    return sqrt(saturate(alpha * alpha + spread));
}

MainLight LightOfWater()
{
    MainLight light = GetMainLight();
#if defined(RILL_HIGH_DEFINITION)
    light.color *= RILL_EXPOSURE / 3.14159265;      // from lux to the radiance of a white surface
#endif
    return light;
}

// What scatters in the water sends to the eye in the end, where it is deep.
float3 ScatteredLight(float3 around, float3 lightColor, float toLight)
{
    return (around + lightColor * (0.5 * saturate(toLight) + 0.25)) * _Scattering.rgb;
}

#ifdef RILL_REFRACTION
#include "CausticLight.hlsl"

float3 SceneColorAt(float2 picture)
{
    return RILL_SCENE_COLOR(picture * 0.5 + 0.5).rgb;
}

// What is seen at the end of a ray and on its way. world: where it begins; lit: see ScatteredLight.
float3 SeenAlong(WaterRay ray, float3 world, float3 lit)
{
    float3 rate = _Absorption.rgb + _Scattering.w;
    float3 color = lit * (1.0 - exp(-_Scattering.w * ray.path));
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
        end = SceneColorAt(ray.picture) * SunThroughSurface(ray.picture);
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
    float3 middle = InDomain(OnNearPlane(0.0));
    float radius = length(InDomain(OnNearPlane(1.0)) - middle);
    float3 nearest = clamp(middle, 0.0, _DrawnDomainSize.xyz);
    if (distance(middle, nearest) > radius || MeshDistance(nearest) < -min(radius + 0.5, 0.9 * kMeshFar) && radius < 0.9 * kMeshFar - 0.5)
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
    float3 lit = ScatteredLight(Ambient(world, float3(0.0, 1.0, 0.0)), lightColor, light.direction.y);
#ifdef RILL_REFRACTION
    return float4(SeenAlong(TraceWater(p, along), world, lit), 1.0);
#else
    float3 wall;
    bool found;
    float end = BoxExit(p, along, wall), z = SceneDepthAt(picture) - FromSurfaceDepth(1.0, eyeIndex);
    float path = min(MarchMesh(p, along, 1.0, 0.0, end, found) * Spacing(), z * length(ray.direction));
    float through = dot(exp(-(_Absorption.rgb + _Scattering.w) * path), 1.0 / 3.0);
    return float4(lit * (1.0 - exp(-_Scattering.w * path)), 1.0 - through);
#endif
}

#else

Texture2DArray<float4> _RayEnds;
Texture2DArray<float4> _RayDirections;
Texture2DArray<float4> _RayMirrors;

// The ray of a point of the picture, or of a neighbor where the middle of its texel is beside the water. mirrored: what the surface mirrors, see
// PackedRay.
WaterRay RayAt(float2 picture, out float2 mirrored)
{
    static const int2 kNear[5] = { int2(0, 0), int2(-1, 0), int2(1, 0), int2(0, -1), int2(0, 1) };
    int2 middle = SurfaceTexel(picture), last = int2(_SurfaceWindow.zw) - 1;
    PackedRay packed = (PackedRay)0;
    packed.ends.w = kNoRay;
    [loop]
    for (uint i = 0; i < 5 && packed.ends.w == kNoRay; i++)
    {
        int4 texel = int4(clamp(middle + kNear[i], 0, last), eyeIndex, 0);
        packed.ends = _RayEnds.Load(texel);
        packed.directions = _RayDirections.Load(texel);
        packed.mirrored = _RayMirrors.Load(texel);
    }
    WaterRay ray = UnpackRay(packed, picture);
    if (packed.ends.w == kNoRay)
    {
        ray.ends = kEndsAtWall;
        ray.picture = picture;
        packed.mirrored.x = kNoPoint;
    }
    mirrored = packed.mirrored.x == kNoPoint ? kNoPoint : packed.mirrored.xy + picture;
    return ray;
}

// What the surface mirrors: the scene where the ray meets it on the picture, else the surroundings.
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

float4 WaterFragment(WaterVaryings input) : SV_Target
{
    RestoreView(input);
    float3 normal = normalize(mul((float3x3)_DomainToWorld, FlatOnWalls(input.drawn, normalize(input.normal))));
    float alpha = FilteredAlpha(normal, _SurfaceOptics.z), roughness = sqrt(alpha);
    float3 world = input.world, toEye = ToEye(world);
    normal = FacingNormal(normal, toEye);
    float4 clip = SurfaceClip(world, eyeIndex);
    float z = DepthAlongView(clip, eyeIndex);
    float2 mirroredAt;
    WaterRay ray = RayAt(clip.xy / clip.w, mirroredAt);

    MainLight light = LightOfWater();
    float3 lightColor = light.color * MainLightShadow(light, world + light.direction * _SurfaceOptics.w, WorldToClip(world));
    float reflectance = Reflectance(dot(normal, toEye), 1.0 / _SurfaceOptics.x);
    float3 mirrored = Reflected(world, reflect(-toEye, normal), roughness, mirroredAt) * reflectance
        + lightColor * Highlight(normal, toEye, light.direction, alpha);
    float3 lit = ScatteredLight(Ambient(world, normal), lightColor, dot(normal, light.direction));

#ifdef RILL_REFRACTION
    float3 color = SeenAlong(ray, world, lit) * (1.0 - reflectance) + mirrored;
    float coverage = 1.0;
#else
    float3 through = exp(-(_Absorption.rgb + _Scattering.w) * ray.path);
    float coverage = 1.0 - (1.0 - reflectance) * dot(through, 1.0 / 3.0);
    float3 color = lit * (1.0 - exp(-_Scattering.w * ray.path)) * (1.0 - reflectance) + mirrored;
#endif
    return float4(ApplyFog(color, coverage, z), coverage);
}

#endif
