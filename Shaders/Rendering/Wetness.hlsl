// Surfaces of the opaque scene that the fluid has wetted, over their picture: darker, and they mirror the sky. One rectangle
// over what the fluid's box covers of it, into the camera's color. The SubShader around it says for which pipeline, see View.hlsl. Includes
// nothing of Unity's.
//
// Water in the pores of a rough surface turns back part of the light that it scatters, which then has another chance to be absorbed (Lekner and
// Dorf, Why some things are darker when wet, Applied Optics 27, 1988): the color is multiplied. The film on it mirrors by Fresnel.
//
//   _CameraDepthTexture  in   the pipeline's
//   _WetStamps           in   see Wetness.compute
//   target               i/o  color: times alpha, plus rgb
#include "View.hlsl"
#include "SurfaceView.hlsl"
#include "SurfaceRectangle.hlsl"
#include "DrawnDomain.hlsl"
#if defined(RILL_HIGH_DEFINITION) || defined(RILL_STEREO)
#define RILL_SCENE_ARRAY
#endif
#include "SceneDepth.hlsl"
#include "WetGrid.hlsl"
#include "../Generated/Wetness.hlsl"

StructuredBuffer<uint> _WetStamps;
uint _WetNow;                   // fluid's time of the frame, as the stamps have it
uint _WetStamp;                 // of the newest state
float4 _WetLook;                // x darkening, y smoothness, 0 to 1; z 1 / the time to dry, 1/s; w 1 where the fluid itself is opaque
float4 _WetFog;                 // the scene's: the visible fraction at z is saturate(x z + y) exp2(-z' - z'^2) with z' of z and w
float4 _WetFogColor;

#ifdef RILL_HIGH_DEFINITION
TextureCubeArray _SkyTexture;   // HDRP's sky, nits; the first is as a shiny surface reflects it
Texture2D _ExposureTexture;
SamplerState rill_trilinear_clamp_sampler;
#else
TextureCube _WetSky;            // what the scene mirrors where no probe is
SamplerState sampler_WetSky;
float4 _WetSkyDecode;
#endif

static const float kMargin = 1.0;       // d, by which the rectangle is larger than the box: surfaces at its walls
static const float kInFront = 0.5;      // d in front of a surface: where the particles lie that touch it
static const float kWetReflectance = 0.02;      // of water, head on
static const float kSkyLevels = 6.0;    // mips over which it goes from a mirror to matt, in every pipeline

float3 InDomain(float2 picture, float z)
{
    SurfaceRay ray = RayThrough(picture, eyeIndex);
    return mul(_WorldToDomain, float4(ray.origin + ray.direction * z, 1.0)).xyz;
}

// From the texel before to a point or from there to the next, d: on the side where the depth changes less.
float3 StepAlong(float2 picture, float2 texel, float z, float3 p)
{
    float before = SceneDepthAt(picture - texel, eyeIndex), after = SceneDepthAt(picture + texel, eyeIndex);
    bool isBefore = abs(before - z) < abs(after - z);
    float3 other = InDomain(isBefore ? picture - texel : picture + texel, isBefore ? before : after);
    return isBefore ? p - other : other - p;
}

// -1 to 1, in waves of two to three spacings that stay where they are in the world as the box leaves the water.
float EdgeNoise(float3 p)
{
    float3 at = p - _WetGridShifted.xyz;
    float3 waves = float3(dot(at, float3(1.9, 0.7, 1.3)), dot(at, float3(-1.1, 2.3, 0.9)) + 1.7, dot(at, float3(0.8, -1.4, 2.1)) + 4.1);
    return dot(sin(waves), 1.0 / 3.0);
}

// x: how wet it is at a point, 0 to 1; y: the part of that where water is now.
float2 WetnessAt(float3 p)
{
    float3 part;
    uint3 low = WetCell(p, part);
    float2 sum = 0.0;
    float reached = 0.0;
    for (uint corner = 0; corner < 8; corner++)
    {
        uint3 side = WetCorner(corner);
        float3 weights = lerp(1.0 - part, part, (float3)side);
        uint stamp = _WetStamps[WetNode(low + side)];
        if (stamp > 0)
        {
            float age = (float)(_WetNow - min(stamp, _WetNow)) * (1.0 / kWetTicks), weight = weights.x * weights.y * weights.z;
            reached += weight;
            sum += weight * float2(exp(-age * _WetLook.z), stamp == _WetStamp ? 1.0 : 0.0);
        }
    }
    // A seam between nodes that water has reached and others, which is neither straight nor a spacing wide. All are reached: 1; none: 0.
    float edge = smoothstep(0.3, 0.7, reached + 0.2 * EdgeNoise(p));
    return edge * sum / max(reached, 1e-6);
}

// Returns what the film mirrors in a direction, linear. roughness: 0 a mirror.
float3 SkyIn(float3 direction, float roughness)
{
    float level = roughness * (1.7 - 0.7 * roughness) * kSkyLevels;
#ifdef RILL_HIGH_DEFINITION
    float exposure = _ExposureTexture.Load(int3(0, 0, 0)).r;
    return exposure * _SkyTexture.SampleLevel(rill_trilinear_clamp_sampler, float4(direction, 0.0), level).rgb;
#else
    float4 sky = _WetSky.SampleLevel(sampler_WetSky, direction, level);
    float alpha = max(_WetSkyDecode.w * (sky.a - 1.0) + 1.0, 0.0);
    return _WetSkyDecode.x * pow(max(alpha, 1e-6), _WetSkyDecode.y) * sky.rgb;
#endif
}

float SeenThroughFog(float z)
{
    float thin = _WetFog.z * z, thick = _WetFog.w * z;
    return saturate(_WetFog.x * z + _WetFog.y) * exp2(-thin - thick * thick);
}

float4 WetFragment(SurfaceVaryings input) : SV_Target
{
    RestoreView(input);
    // The center of the texel that the depth is of.
    float2 size = SceneSize(), texel = 2.0 / size;
    float2 picture = (floor((input.picture.xy * 0.5 + 0.5) * size) + 0.5) * texel - 1.0;
    float z = SceneDepthAt(picture, eyeIndex);
    float3 p = InDomain(picture, z);
    if (any(p < -kMargin) || any(p > _DrawnDomainSize.xyz + kMargin))
        discard;

    float3 toEye = -mul((float3x3)_WorldToDomain, RayThrough(picture, eyeIndex).direction);
    float3 normal = cross(StepAlong(picture, float2(texel.x, 0.0), z, p), StepAlong(picture, float2(0.0, texel.y), z, p));
    normal *= rsqrt(max(dot(normal, normal), 1e-24)) * (dot(normal, toEye) < 0.0 ? -1.0 : 1.0);
    toEye *= rsqrt(max(dot(toEye, toEye), 1e-24));

    // In front of it: nodes behind a surface may never have been reached, and its other side is dry.
    float3 front = p + kInFront * normal, beyond = max(-front, front - _DrawnDomainSize.xyz);
    float inBox = saturate(1.0 - 2.0 * max(beyond.x, max(beyond.y, beyond.z)));
    float2 wet = inBox * WetnessAt(front);
    if (_WetLook.w > 0.5)
        wet.x = max(wet.x - max(wet.y, WetnessAt(p - kInFront * normal).y), 0.0);       // the visible surface may be the fluid
    if (wet.x < kDry)
        discard;

    // No film exists under water.
    float film = _WetLook.y * saturate(wet.x - wet.y);
    float cosine = saturate(dot(normal, toEye)), grazing = 1.0 - cosine, squared = grazing * grazing;
    float roughness = 1.0 - _WetLook.y;
    float mirrored = film * (kWetReflectance + max(_WetLook.y - kWetReflectance, 0.0) * squared * squared * grazing);
    float3 direction = mul((float3x3)_DomainToWorld, reflect(-toEye, normal));
    direction *= rsqrt(max(dot(direction, direction), 1e-24));
    float kept = (1.0 - _WetLook.x * wet.x) * (1.0 - mirrored), seen = SeenThroughFog(z);
    return float4(seen * mirrored * SkyIn(direction, roughness) + (1.0 - kept) * (1.0 - seen) * _WetFogColor.rgb, kept);
}
