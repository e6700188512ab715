// Shades the water: the front faces of its mesh, or, in RILL_UNDER_WATER, all that an eye in the water sees. A ray is followed through the field
// of the mesh, from one side of a drop, a jet or a sheet to the other, and over the picture to the opaque scene. The SubShader around it says
// for which pipeline, see View.hlsl. Includes nothing of Unity's.
//
//   the buffers of WaterMesh.hlsl and MeshField.hlsl
//   the scene's color, where RILL_REFRACTION is on, and its depth, as the pipeline gives them
#include "SurfaceView.hlsl"
#include "MainLight.hlsl"
#include "Environment.hlsl"
#include "Fog.hlsl"
#include "SceneColor.hlsl"
#include "MeshField.hlsl"
#include "Optics.hlsl"
#include "WaterMesh.hlsl"
#ifdef RILL_REFRACTION
#include "SceneTrace.hlsl"
#endif

float4x4 _WorldToDomain;        // from world, m, to the domain's frame in d

static const uint kSegments = 4;            // of a ray: between two faces of the water
static const uint kWaterSteps = 12, kAirSteps = 16, kReflectionSteps = 40;
static const float kFarAway = 200.0;        // m: as far as rays in the air are followed
static const float kWaterBorder = 1.8;      // of half the picture: as far beyond it as rays in the water go
static const float kSeenBorder = 0.02, kMirrorBorder = 0.1;    // of half the picture's width: over which the scene fades to what is around
static const float kContact = 1.0;          // d: what stands as near behind a wall of the domain is in contact with the water

static float3 fieldShift = 0.0;     // from the field's frame to that which is drawn, d

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

float3 ToDrawn(float3 p)
{
    return mul(_DomainToWorld, float4(p + fieldShift, 1.0)).xyz;
}

float3 InDomain(float3 world)
{
    return mul(_WorldToDomain, float4(world, 1.0)).xyz - fieldShift;
}

float Spacing()
{
    return length(float3(_DomainToWorld[0].x, _DomainToWorld[1].x, _DomainToWorld[2].x));
}

#ifdef RILL_REFRACTION
#include "CausticLight.hlsl"

float3 SceneColorAt(float2 picture)
{
    return RILL_SCENE_COLOR(picture * 0.5 + 0.5).rgb;
}

// What a ray in the air meets that comes to no water: the scene where it is on the picture, else the surroundings.
float3 SeenInAir(SceneTrace seen, float3 world, float3 along)
{
    float3 color = Mirrored(world, along, 0.0);
    if (seen.found || seen.open || seen.hidden)
        color = lerp(color, SceneColorAt(seen.picture), BorderFade(seen.picture, kSeenBorder));
    return color;
}

// What is seen along a ray that begins in the water, d, in the field's frame. lit: see ScatteredLight.
float3 SeenInWater(float3 p, float3 along, float3 lit)
{
    float spacing = Spacing(), side = 1.0, index = _SurfaceOptics.x;
    float3 color = 0.0, left = 1.0;
    float begin = 0.0;
    bool isDone = false, isTurned = false;
    [loop]
    for (uint i = 0; i < kSegments && !isDone; i++)
    {
        bool isWater = side > 0.0, found;
        float3 normal;
        float end = BoxExit(p, along, normal), reach = MarchMesh(p, along, side, begin, end, found);
        float3 world = ToDrawn(p), direction = mul((float3x3)_DomainToWorld, along) / spacing;
        float traced = found ? reach * spacing : isWater ? (reach + kContact) * spacing : kFarAway;
        SceneTrace seen = TraceScene(world, direction * traced, isWater ? kWaterSteps : kAirSteps, isWater ? kWaterBorder : 1.0);
        if (isWater)
        {
            float path = min(seen.found ? traced * seen.reach : traced, reach * spacing);
            color += left * lit * (1.0 - exp(-_Scattering.w * path));
            left *= exp(-(_Absorption.rgb + _Scattering.w) * path);
        }
        isDone = true;
        if (seen.found && isWater)
            color += left * SceneColorAt(seen.picture) * SunThroughSurface(p + along * (traced * seen.reach / spacing), seen.picture);
        else if (seen.found || !found && !isWater)
            color += left * SeenInAir(seen, world, direction);
        else if (!found && !seen.open)
            // A wall that something hides, or beyond the picture.
            color += left * (isTurned ? lit : SceneColorAt(seen.picture));
        else
        {
            isDone = false;
            p += along * reach;
            normal = found ? MeshNormal(p) * side : normal;     // the way that the ray goes
            float cosine = dot(along, normal);
            normal = normalize(normal + along * max(0.02 - cosine, 0.0));
            cosine = dot(along, normal);
            float ratio = isWater ? index : 1.0 / index, reflectance = Reflectance(cosine, ratio);
            float3 turned = reflect(along, normal);
            if (reflectance < 1.0)
            {
                float3 turnedWorld = mul((float3x3)_DomainToWorld, turned) / spacing;
#ifdef RILL_UNDER_WATER
                color += left * reflectance * (isWater ? lit : Mirrored(ToDrawn(p), turnedWorld, 0.0));
#else
                color += left * reflectance * Mirrored(ToDrawn(p), turnedWorld, 0.0);
#endif
                left *= 1.0 - reflectance;
                along = refract(along, -normal, ratio);
                side = -side;
            }
            else
            {
                along = turned;
                isTurned = true;
            }
            along = normalize(along);
            begin = 0.2 * _MeshCell;
        }
    }
    // It has gone to and fro in a splash: bright as what is around, not dark.
    if (!isDone)
        color += left * Mirrored(ToDrawn(p), mul((float3x3)_DomainToWorld, along) / spacing, 0.0);
    return color;
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
    return float4(SeenInWater(p, along, lit), 1.0);
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

// What the surface mirrors: the scene where the ray meets it on the picture, else the surroundings.
// reflectance: what is hardly seen is followed in fewer steps.
float3 Reflected(float3 world, float3 direction, float roughness, float reflectance)
{
    float3 color = Mirrored(world, direction, roughness);
#ifdef RILL_REFRACTION
    uint steps = (uint)clamp(reflectance * 4.0 * kReflectionSteps, kReflectionSteps / 4, kReflectionSteps);
    SceneTrace seen = TraceScene(world, direction * kFarAway, steps, 1.0);
    if (seen.found || seen.hidden)
    {
        float shown = BorderFade(seen.picture, kMirrorBorder) * saturate(2.0 - 4.0 * roughness);
        color = lerp(color, SceneColorAt(seen.picture) * _ReflectionStrength, shown);
    }
#endif
    return color;
}

static const float kOnWall = 0.01;          // d: as near to a wall of the domain is the face of the water that lies in it

// A face that lies in a wall is as flat as it is, up to the line where the surface meets it, whose vertices have the normal of the surface.
float3 FlatOnWalls(float3 world, float3 normal)
{
    float3 p = mul(_WorldToDomain, float4(world, 1.0)).xyz, beyond = _DrawnDomainSize.xyz - p;
    float3 wall = p < kOnWall ? -1.0 : beyond < kOnWall ? 1.0 : 0.0;
    return any(wall != 0.0) ? normalize(mul((float3x3)_DomainToWorld, wall)) : normal;
}

float4 WaterFragment(WaterVaryings input) : SV_Target
{
    RestoreView(input);
    float3 normal = FlatOnWalls(input.world, normalize(input.normal));
    float alpha = FilteredAlpha(normal, _SurfaceOptics.z), roughness = sqrt(alpha);
    fieldShift = input.shift;
    float3 world = input.world, toEye = ToEye(world);
    normal = normalize(normal + toEye * max(0.03 - dot(normal, toEye), 0.0));       // none of those that are seen looks away
    float4 clip = SurfaceClip(world, eyeIndex);
    float z = DepthAlongView(clip, eyeIndex);

    MainLight light = LightOfWater();
    float3 lightColor = light.color * MainLightShadow(light, world + light.direction * _SurfaceOptics.w, WorldToClip(world));
    float reflectance = Reflectance(dot(normal, toEye), 1.0 / _SurfaceOptics.x);
    float3 mirrored = Reflected(world, reflect(-toEye, normal), roughness, reflectance) * reflectance
        + lightColor * Highlight(normal, toEye, light.direction, alpha);
    float3 lit = ScatteredLight(Ambient(world, normal), lightColor, dot(normal, light.direction));

    float3 p = InDomain(world);
#ifdef RILL_REFRACTION
    float3 bent = refract(-toEye, normal, 1.0 / _SurfaceOptics.x);
    float3 color = SeenInWater(p, normalize(mul((float3x3)_WorldToDomain, bent)), lit) * (1.0 - reflectance) + mirrored;
    float coverage = 1.0;
#else
    float3 wall, along = normalize(mul((float3x3)_WorldToDomain, -toEye));
    bool found;
    float end = BoxExit(p, along, wall), spacing = Spacing();
    float behind = max(SceneDepthAt(clip.xy / clip.w) - z, 0.0) / max(-dot(RILL_VIEW_MATRIX[2].xyz, -toEye), 1e-3);
    float path = min(MarchMesh(p, along, 1.0, 0.0, end, found) * spacing, behind);
    float3 through = exp(-(_Absorption.rgb + _Scattering.w) * path);
    float coverage = 1.0 - (1.0 - reflectance) * dot(through, 1.0 / 3.0);
    float3 color = lit * (1.0 - exp(-_Scattering.w * path)) * (1.0 - reflectance) + mirrored;
#endif
    return float4(ApplyFog(color, coverage, z), coverage);
}

#endif
