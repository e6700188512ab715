// Shades the water's surface: one rectangle over the textures that FluidSurfaceRecorder filled for this camera, with depth. The
// SubShader around it says for which pipeline, see View.hlsl. Includes nothing of Unity's.
//
//   _SurfaceDepth       in  Texture2DArray, a slice for each eye: see SurfaceView.hlsl
//   _SurfaceNormals     in  xyz unit normal, world; w variance of the normals around
//   _SurfaceThickness   in  water along the ray in front of the scene, m, or of each of four phases
//   _SurfaceFoam        in  see FoamLayer.hlsl; where RILL_FOAM is on
//   the scene's color and depth as the pipeline gives them; where RILL_REFRACTION is on
#include "SurfaceView.hlsl"
#include "MainLight.hlsl"
#include "SurfaceRectangle.hlsl"
#include "Environment.hlsl"
#include "Fog.hlsl"
#include "../Gpu/Filtering.hlsl"
#include "Medium.hlsl"
#ifdef RILL_FOAM
#include "FoamLayer.hlsl"
#endif

Texture2DArray<float> _SurfaceDepth;
Texture2DArray<float4> _SurfaceNormals;
Texture2DArray<float4> _SurfaceThickness;

#ifdef RILL_REFRACTION
#include "SceneColor.hlsl"
#endif

struct SurfacePoint
{
    float3 world;
    float3 normal;
    float3 ray;             // unit, away from the eye
    float z;                // depth along the view, m
    float stretch;          // length of the ray for 1 m of depth along the view
    float roughness;        // perceptual
};

SurfacePoint PointOn(float2 picture)
{
    int2 texel = SurfaceTexel(picture);
    float depth = _SurfaceDepth.Load(int4(texel, eyeIndex, 0));
    if (depth == 0.0)
        discard;
    float4 normal = _SurfaceNormals.Load(int4(texel, eyeIndex, 0));

    SurfacePoint p;
    SurfaceRay ray = RayThrough(picture, eyeIndex);
    SurfaceRay middle = RayThrough(TexelPicture(texel), eyeIndex);
    p.z = FromSurfaceDepth(depth, eyeIndex);
    // From the middle of the texel along its plane: no steps where textures are smaller than the screen.
    float3 there = middle.origin + middle.direction * p.z;
    float facing = dot(normal.xyz, ray.direction);
    float z = dot(normal.xyz, there - ray.origin) / min(facing, -1e-4);
    p.z = abs(z - p.z) < 0.02 * p.z ? z : p.z;
    p.stretch = length(ray.direction);
    p.ray = ray.direction / p.stretch;
    p.world = ray.origin + ray.direction * p.z;
    p.normal = normal.xyz;
    p.roughness = sqrt(sqrt(saturate(pow(_SurfaceOptics.z, 4.0) + normal.w)));      // variances of slopes add up
    return p;
}

#ifdef RILL_REFRACTION
static const int kRefractionSteps = 8;      // that halve how much of the bend is known to be hidden
static const float kRefractionReach = 0.8;  // of the depth that a ray should reach: the scene there may be nearer by the rest, as no floor is flat

// Whether the scene that a filtered sample takes in is as far away as the ray there: what hides it must not show in its place.
bool IsBehind(float2 picture, float z)
{
    float2 texel = 1.0 / SceneSize();        // half of one, on the picture
    float nearest = min(min(SceneDepthAt(picture - texel, eyeIndex), SceneDepthAt(picture + texel, eyeIndex)),
        min(SceneDepthAt(picture + float2(texel.x, -texel.y), eyeIndex), SceneDepthAt(picture + float2(-texel.x, texel.y), eyeIndex)));
    return nearest >= z;
}

// The scene behind, along the refracted ray for as long as there is water. Where something in front hides that, or the ray hits
// something, only as far along as that: the path is then shorter.
float3 Refracted(SurfacePoint p, float2 picture, float3 bent, inout float path)
{
    float4 clip = SurfaceClip(p.world + bent * path, eyeIndex);
    float2 shift = clip.w > 0.0 ? clip.xy / max(clip.w, 1e-6) - picture : 0.0;
    // As far as the picture goes.
    float2 room = (1.0 - abs(picture) * sign(picture * shift)) / max(abs(shift), 1e-6);
    float inside = saturate(min(room.x, room.y));
    shift *= inside;
    // How far the ray gets along the view; short of it, since the floor need not be flat.
    float reach = kRefractionReach * inside * (DepthAlongView(clip, eyeIndex) - p.z);
    if (!IsBehind(picture + shift, p.z + reach))
    {
        float seen = 0.0, hidden = 1.0;
        for (int i = 0; i < kRefractionSteps; i++)
        {
            float middle = 0.5 * (seen + hidden);
            bool isSeen = IsBehind(picture + shift * middle, p.z + reach * middle);
            seen = isSeen ? middle : seen;
            hidden = isSeen ? hidden : middle;
        }
        shift *= seen;
        path *= seen;
    }
    return RILL_SCENE_COLOR((picture + shift) * 0.5 + 0.5).rgb;
}
#endif

// Returns the medium along a ray. path: length of it, m.
Medium MediumAt(float2 picture, out float path)
{
    float2 texels = TexelsAt(picture, _ThicknessSize, _ThicknessWindow);
    float4 thickness = max(LoadBilinear(_SurfaceThickness, texels, 0.0, _ThicknessWindow.zw - 1.0, eyeIndex), 0.0);
    path = _HasPhases > 0.5 ? dot(thickness, 1.0) : thickness.x;
    Medium medium = MediumOfLook();
    if (_HasPhases > 0.5 && path > 1e-6)
        medium = Stirred(thickness);
    return medium;
}

// Reflectance of a dielectric (Schlick 1994).
float Fresnel(float cosine, float roughness)
{
    float reflectance = _SurfaceOptics.y;
    return reflectance + (max(1.0 - roughness, reflectance) - reflectance) * pow(saturate(1.0 - cosine), 5.0);
}

MainLight LightOfSurface()
{
    MainLight light = GetMainLight();
#if defined(RILL_HIGH_DEFINITION)
    light.color *= RILL_EXPOSURE / 3.14159265;      // from lux to the radiance of a white surface
#endif
    return light;
}

// GGX (Walter et al. 2007) with the visibility of Hammon 2017, for a light of unit radiance times pi.
float Highlight(float3 normal, float3 toEye, float3 toLight, float roughness)
{
    float3 halfway = toEye + toLight;
    halfway *= rsqrt(max(dot(halfway, halfway), 1e-12));
    float nl = saturate(dot(normal, toLight)), nv = saturate(dot(normal, toEye)) + 1e-4, nh = saturate(dot(normal, halfway));
    float alpha = max(roughness * roughness, 0.002), squared = alpha * alpha;
    float spread = nh * nh * (squared - 1.0) + 1.0;
    float visibility = 0.5 / max(lerp(2.0 * nl * nv, nl + nv, alpha), 1e-4);
    return min(squared / (spread * spread) * visibility * Fresnel(dot(toLight, halfway), 0.0) * nl, 64.0);
}

#ifdef RILL_FOAM
bool IsWater(float2 picture)
{
    return _SurfaceDepth.Load(int4(SurfaceTexel(picture), eyeIndex, 0)) > 0.0;
}

// What flies where there is no water behind it.
float4 Spray(FoamLayer foam, float2 picture, out float depth)
{
    if (foam.front < 0.01)
        discard;
    SurfaceRay ray = RayThrough(picture, eyeIndex);
    float3 world = ray.origin + ray.direction * foam.z;
    float4 clip = WorldToClip(world);
    depth = DeviceDepth(clip);
    MainLight light = LightOfSurface();
    float3 lit = LitFoam(Ambient(world, float3(0.0, 1.0, 0.0)), light.color * MainLightShadow(light, world, clip), light.direction.y);
    return float4(ApplyFog(lit * foam.front, foam.front, foam.z), foam.front);
}
#endif

float4 SurfaceFragment(SurfaceVaryings input, out float depth : SV_Depth) : SV_Target
{
    RestoreView(input);
    float2 picture = input.picture.xy;
#ifdef RILL_FOAM
    FoamLayer foam = FoamLayerAt(picture, eyeIndex, rill_linear_clamp_sampler);
    if (!IsWater(picture))
        return Spray(foam, picture, depth);
#endif
    SurfacePoint p = PointOn(picture);
    float4 clip = WorldToClip(p.world);
    depth = DeviceDepth(clip);

    float3 toEye = -p.ray;
    float facing = dot(p.normal, toEye);
    p.normal = normalize(p.normal + toEye * max(0.05 - facing, 0.0));       // none of those that are seen looks away
    facing = saturate(dot(p.normal, toEye));
    float path;
    Medium medium = MediumAt(picture, path);
#ifdef RILL_REFRACTION
    // The textures of thickness are coarse: what stands in the water keeps its edges by its own depth.
    path = min(path, max(SceneDepthAt(picture, eyeIndex) - p.z, 0.0) * p.stretch);
#endif

    MainLight light = LightOfSurface();
    float3 lightColor = light.color * MainLightShadow(light, p.world + light.direction * _SurfaceOptics.w, clip);
    float3 around = Ambient(p.world, p.normal);
    float reflectance = Fresnel(facing, p.roughness);
    float3 mirrored = Mirrored(p.world, reflect(p.ray, p.normal), p.roughness) * reflectance + lightColor * Highlight(p.normal, toEye,
        light.direction, p.roughness);

#ifdef RILL_REFRACTION
    // As deep below the surface as the straight ray gets, which is where a floor is.
    float3 bent = refract(p.ray, p.normal, 1.0 / _SurfaceOptics.x);
    path *= dot(p.ray, p.normal) / min(dot(bent, p.normal), -0.05);
    float3 behind = Refracted(p, picture, bent, path);
#endif
    float3 through = exp(-(medium.absorption + medium.scattering) * path);
    float3 lit = (around + lightColor * (0.5 * saturate(dot(p.normal, light.direction)) + 0.25)) * medium.color;
    float3 scattered = lit * (1.0 - exp(-medium.scattering * path));
#ifdef RILL_FOAM
    // Under water it hides what is behind it, and is seen through what is in front of it.
    float3 foamLight = LitFoam(around, lightColor, dot(p.normal, light.direction));
    float3 under = foamLight * exp(-(medium.absorption + medium.scattering) * foam.below) + lit * (1.0 - exp(-medium.scattering * foam.below));
    scattered = lerp(scattered, under, foam.under);
    through *= 1.0 - foam.under;
#endif
#ifdef RILL_REFRACTION
    float3 color = (behind * through + scattered) * (1.0 - reflectance) + mirrored;
    float coverage = 1.0;
#else
    float coverage = 1.0 - (1.0 - reflectance) * dot(through, 1.0 / 3.0);
    float3 color = scattered * (1.0 - reflectance) + mirrored;
#endif
#ifdef RILL_FOAM
    color = lerp(color, foamLight, foam.front);
    coverage = lerp(coverage, 1.0, foam.front);
#endif
    return float4(ApplyFog(color, coverage, p.z), coverage);
}
