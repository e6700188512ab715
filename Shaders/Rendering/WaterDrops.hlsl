// What of the water is thinner than its mesh can hold, as droplets: each particle that flies by itself is a dozen of them, of its volume
// together, drawn out along the way that they go while the picture is exposed. The SubShader around it says for which pipeline, see View.hlsl.
//
//   _SurfaceElements  in  see SurfaceElement.hlsl
//   _MeshDrops        in  uint, indices of those that are drops
#include "Water.hlsl"
#include "Billboard.hlsl"
#include "Ellipsoid.hlsl"
#include "SurfaceParticle.hlsl"
#include "SurfaceElement.hlsl"
#include "../Gpu/Hash.hlsl"
#include "../Generated/SurfaceMesh.hlsl"

StructuredBuffer<SurfaceParticle> _SurfaceElements;
StructuredBuffer<uint> _MeshDrops;
float4 _FrameExposure;          // x: substeps while which the picture is exposed

static const float kSmallestDroplet = 0.2;      // radius of the last of a particle's droplets over the first
static const float kFirstRadius = 0.4401;       // of the first, d: with those radii all together have a volume of d^3
static const float kSpread = 0.75;              // of a particle's droplets around it, d
static const float kMinPixels = 0.6;            // radius of a droplet on the picture: a smaller one is fainter instead
static const float kGlintPixels = 2.5, kShapedPixels = 6.0;   // and up to which, and from which on, what it shows upside down is not and is seen
static const float kGathered = 0.1;             // coverage of a small one by the light that it gathers from everywhere

struct DropVaryings
{
    float4 clip : SV_Position;
    float3 world : TEXCOORD0;                   // on the quad
    nointerpolation float4 center : TEXCOORD1;  // w coverage
    nointerpolation float4 a : TEXCOORD2;       // semi-axes; w: the smallest on the picture, pixels
    nointerpolation float4 b : TEXCOORD3;       // whole registers: vkd3d, which runs FXC's bytecode, takes no others beside an eye's index
    nointerpolation float4 c : TEXCOORD4;
    RILL_VIEW_OUTPUT
};

float3 HashedInBall(uint id, uint k)
{
    float z = 2.0 * UnitFloat(Hash(id, k, 1u)) - 1.0, angle = 6.2831853 * UnitFloat(Hash(id, k, 2u));
    float ring = sqrt(max(1.0 - z * z, 0.0)), radius = pow(UnitFloat(Hash(id, k, 3u)), 1.0 / 3.0);
    return radius * float3(ring * cos(angle), ring * sin(angle), z);
}

static const float kMinDrawn = 1.25;            // radius on the picture below which the last of a particle's droplets go to the others, pixels
static const float kMinDroplets = 3.0;

// Radii fall by a power law, from the first to the last; 0 beyond the last that is drawn. first: of the first on the picture, pixels.
float DropletRadius(uint k, float first)
{
    float ratio = pow(kSmallestDroplet, 1.0 / (kDroplets - 1.0)), cubed = ratio * ratio * ratio;
    float drawn = clamp(floor(log(kMinDrawn / first) / log(ratio)) + 1.0, kMinDroplets, float(kDroplets));
    float grown = pow((1.0 - pow(cubed, float(kDroplets))) / (1.0 - pow(cubed, drawn)), 1.0 / 3.0);
    return float(k) < drawn ? kFirstRadius * grown * pow(ratio, float(k)) : 0.0;
}

// Width of a pixel at a point of the domain, d.
float PixelAt(float3 position)
{
    float4 clip = SurfaceClip(mul(_DomainToWorld, float4(position, 1.0)).xyz, eyeIndex);
    return PictureScale(eyeIndex).y * (IsOrthographic() ? 1.0 : max(DepthAlongView(clip, eyeIndex), 1e-6)) * 2.0 / SceneSize().y / Spacing();
}

DropVaryings DropVertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
{
    DropVaryings result = (DropVaryings)0;
    bool drawn = SelectView(instance);
    PassViewOn(result);
    result.clip = kNowhere;
    if (!drawn || all(_PictureBounds == 0.0))
        return result;

    uint k = vertex / 6 % kDroplets;
    SurfaceParticle drop = _SurfaceElements[_MeshDrops[vertex / (6 * kDroplets)]];
    uint id = drop.a.w;
    float3 chord = float3(UnpackHalves(drop.b.y), UnpackHalves(drop.b.z).x);
    float3 position = asfloat(drop.a.xyz) + chord * _FrameLag.x;
    float radius = DropletRadius(k, kFirstRadius / PixelAt(position));
    if (radius == 0.0)
        return result;
    position += kSpread * HashedInBall(id, k);
    position = clamp(position, radius, _DrawnDomainSize.xyz - radius);

    // As long as it flies during the exposure, and thinner by that: its volume stays.
    float flown = length(chord) * _FrameExposure.x;
    float along = radius + 0.5 * flown, across = radius * sqrt(radius / along);
    float3 axis = flown > 1e-4 ? normalize(chord) : float3(0.0, 1.0, 0.0);
    float3 x, y;
    TangentsOf(axis, x, y);
    float3x3 toWorld = (float3x3)_DomainToWorld;
    float3 center = mul(_DomainToWorld, float4(position, 1.0)).xyz;
    float pixel = PixelAt(position), drawnAcross = max(across, kMinPixels * pixel), drawnAlong = max(along, kMinPixels * pixel);
    result.center = float4(center, across * along / (drawnAcross * drawnAlong));
    result.a = float4(mul(toWorld, axis) * drawnAlong, drawnAcross / pixel);
    result.b = float4(mul(toWorld, x) * drawnAcross, 0.0);
    result.c = float4(mul(toWorld, y) * drawnAcross, 0.0);
    float reach = drawnAlong * Spacing();
    result.world = PointOnQuad(center, QuadCorner(vertex), SilhouetteRadius(center, reach));
    result.clip = WorldToClip(result.world);
    // As near as any of it, along the view.
    float4 nearest = WorldToClip(center + RILL_VIEW_MATRIX[2].xyz * reach);
    if (nearest.w > 1e-4)
        result.clip.z = nearest.z / nearest.w * result.clip.w;
    return result;
}

// What a ray meets that leaves a droplet of a few pixels: the scene, as if all of it stood as far away as what is behind the droplet.
float3 SeenByDroplet(float3 world, float3 along, float2 picture, float z)
{
    float3 color = Mirrored(world, along, 0.0);
#ifdef RILL_REFRACTION
    float forward = dot(along, -ToEye(world)), behind = SceneDepthAt(picture) - z;
    float4 clip = SurfaceClip(world + along * (max(behind, 0.0) / max(forward, 0.1)), eyeIndex);
    float2 met = clip.xy / max(clip.w, 1e-6);
    if (forward > 0.1 && clip.w > 1e-5)
        color = lerp(color, SceneColorAt(met), BorderFade(met, kSeenBorder));
#endif
    return color;
}

// Mirrored on its surface, and bent twice.
float3 SeenInDroplet(Ellipsoid e, float3 world, float3 normal, float3 ray, float2 picture, float z)
{
    float index = _SurfaceOptics.x, reflectance = Reflectance(-dot(normal, ray), 1.0 / index);
    float3 bent = refract(ray, normal, 1.0 / index);
    float2 hit;
    HitBall(ToBall(e, world - e.center), ToBall(e, bent), hit);
    float3 leaves = world + bent * hit.y, outward = EllipsoidNormal(e, leaves);
    float3 beyond = refract(bent, -outward, index);
    if (dot(beyond, beyond) < 0.5)
        beyond = reflect(bent, -outward);
    return lerp(SeenByDroplet(leaves, beyond, picture, z), Mirrored(world, reflect(ray, normal), _SurfaceOptics.z), reflectance);
}

// A droplet is as clear as its path through it is short: light is bent twice and not absorbed. No shadow falls on what is so small.
float4 DropFragment(DropVaryings input, out float depth : RILL_CONSERVATIVE_DEPTH) : SV_Target
{
    RestoreView(input);
    Ellipsoid e;
    e.center = input.center.xyz;
    e.a = input.a.xyz;
    e.b = input.b.xyz;
    e.c = input.c.xyz;
    float3 ray = -ToEye(input.world);
    float2 hit;
    if (!HitBall(ToBall(e, input.world - e.center), ToBall(e, ray), hit))
        discard;
    float3 world = input.world + ray * hit.x, normal = EllipsoidNormal(e, world);
    float4 clip = WorldToClip(world);
    depth = DeviceDepth(clip);
    float coverage = saturate(input.center.w), shaped = smoothstep(kGlintPixels, kShapedPixels, input.a.w);
    float4 onPicture = SurfaceClip(world, eyeIndex);
    float z = DepthAlongView(onPicture, eyeIndex);

    // What is behind a small droplet goes on being seen, but for what it gathers; its glint stays.
    MainLight light = LightOfWater();
    float3 color = light.color * Highlight(normal, -ray, light.direction, 0.05);
    if (shaped < 1.0)
        color += (1.0 - shaped) * kGathered * Ambient(world, float3(0.0, 1.0, 0.0));
    if (shaped > 0.0)
        color += shaped * SeenInDroplet(e, world, normal, ray, onPicture.xy / onPicture.w, z);
    float body = coverage * lerp(kGathered, 1.0, shaped);
    return float4(ApplyFog(color * coverage, body, z), body);
}
