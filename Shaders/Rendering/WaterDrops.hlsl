// Draws droplets that are not small on the picture, one by one. The SubShader around it says for which pipeline, see View.hlsl.
#include "Water.hlsl"
#include "Billboard.hlsl"
#include "Ellipsoid.hlsl"
#include "Droplets.hlsl"

static const float kShaped = 10.0;      // semi-axis from which on what a droplet shows upside down is seen, texels; of a small one it is not

struct DropVaryings
{
    float4 clip : SV_Position;
    float3 world : TEXCOORD0;                   // on the quad
    nointerpolation float4 center : TEXCOORD1;  // w how much its own shape is seen
    nointerpolation float4 a : TEXCOORD2;       // semi-axes; w where along this one it begins, over its length
    nointerpolation float4 b : TEXCOORD3;       // w see Droplet
    nointerpolation float4 c : TEXCOORD4;       // whole registers: vkd3d, which runs FXC's bytecode, takes no others beside an eye's index
    RILL_VIEW_OUTPUT
};

// Returns a corner of the quad around a ball of radius reach that is narrower across an axis by a factor. center, axis, reach: world.
float3 PointOnSilhouette(float3 center, float2 corner, float3 axis, float narrower, float reach)
{
    float3 ray = -ToEye(center), along = normalize(axis), up = along - ray * dot(along, ray);
    float sine = length(up), size = SilhouetteRadius(center, reach);
    up = sine > 1e-3 ? up / sine : SideOf(ray);
    float height = sqrt(lerp(narrower * narrower, 1.0, sine * sine));
    return center + (cross(ray, up) * (corner.x * narrower) + up * (corner.y * height)) * size;
}

DropVaryings DropVertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
{
    DropVaryings result = (DropVaryings)0;
    bool drawn = SelectView(instance);
    PassViewOn(result);
    result.clip = kNowhere;
    if (!drawn || all(_PictureBounds == 0.0))
        return result;

    Droplet droplet = DropletOf(vertex / 6);
    float size = RadiusOf(droplet);
    if (!IsShown(droplet))
        return result;
    float3 x, y;
    TangentsOf(droplet.axis, x, y);
    float3x3 toWorld = (float3x3)_DomainToWorld;
    float3 center = mul(_DomainToWorld, float4(droplet.center, 1.0)).xyz;
    result.center = float4(center, smoothstep(kSmall, kShaped, size / droplet.texel));
    result.a = float4(mul(toWorld, droplet.axis) * droplet.along, droplet.isCap ? kCapSunk : -2.0);
    result.b = float4(mul(toWorld, x) * droplet.across, droplet.shown);
    result.c = float4(mul(toWorld, y) * droplet.across, 0.0);
    float3 ballCenter = droplet.isCap ? center + result.a.xyz * kCapSunk : center;
    float reach = (droplet.isCap ? kCapRadius : droplet.along) * Spacing();
    result.world = PointOnSilhouette(ballCenter, QuadCorner(vertex), result.a.xyz, droplet.isCap ? 1.0 : droplet.across / droplet.along, reach);
    result.clip = WorldToClip(result.world);
    // Depth of its nearest part, along the view.
    float4 nearest = WorldToClip(ballCenter + RILL_VIEW_MATRIX[2].xyz * reach);
    if (nearest.w > 1e-4)
        result.clip.z = nearest.z / nearest.w * result.clip.w;
    return result;
}

// Returns what a ray meets that leaves a droplet of a few pixels: the scene, as if all of it stood as far away as what is behind the droplet.
float3 SeenByDroplet(float3 world, float3 along, float2 picture, float z)
{
    float3 color = Mirrored(world, along, 0.0);
#ifdef RILL_REFRACTION
    float forward = dot(along, -ToEye(world)), behind = SceneDepthAt(picture, eyeIndex) - z;
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

// Returns what is visible in a cap: the solid that it lies on, bent once, and what it mirrors. plane: of the solid, see Ellipsoid's frame.
float4 SeenInCap(Ellipsoid e, float plane, float3 world, float3 normal, float3 ray)
{
    float index = _SurfaceOptics.x, reflectance = Reflectance(-dot(normal, ray), 1.0 / index);
    float3 mirrored = Mirrored(world, reflect(ray, normal), _SurfaceOptics.z);
#ifdef RILL_REFRACTION
    float3 bent = refract(ray, normal, 1.0 / index);
    float reach = (plane - ToBall(e, world - e.center).x) / min(ToBall(e, bent).x, -1e-3);
    float4 clip = SurfaceClip(world + bent * max(reach, 0.0), eyeIndex);
    return float4(lerp(SceneColorAt(clip.xy / clip.w), mirrored, reflectance), 1.0);
#else
    return float4(mirrored * reflectance, reflectance);
#endif
}

// A droplet is as clear as its path through it is short: light is bent twice and not absorbed. No shadow falls on what is so small. What flies
// while the picture is exposed covers a point for a part of that time.
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
    bool isCap = input.a.w > -1.0;
    if (isCap && ToBall(e, world - e.center).x < input.a.w)
        discard;
    float4 clip = WorldToClip(world);
    depth = DeviceDepth(clip);
    float shaped = input.center.w;
    float4 onPicture = SurfaceClip(world, eyeIndex);
    float z = DepthAlongView(onPicture, eyeIndex);

    // The scene behind a small droplet goes on being seen, but for what it gathers, and the sun, as in WaterSpray.hlsl.
    MainLight light = LightOfWater();
    float3 color = light.color * Highlight(normal, -ray, light.direction, 0.05);
    if (shaped < 1.0)
        color = lerp(kGathered * Ambient(world, float3(0.0, 1.0, 0.0)) + light.color * LightThroughBall(dot(light.direction, ray)), color, shaped);
    float4 seen = 0.0;
    if (isCap)
        seen = SeenInCap(e, input.a.w, world, normal, ray);
    else if (shaped > 0.0)
        seen = float4(SeenInDroplet(e, world, normal, ray, onPicture.xy / onPicture.w, z), 1.0);
    color += shaped * seen.rgb;
    float body = lerp(kGathered, seen.a, shaped);
    return float4(ApplyFog(color, body, z), body) * input.b.w;
}
