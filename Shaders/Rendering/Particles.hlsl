// Draws each particle as a sphere: a quad towards the eye from SV_VertexID, intersected with the ray through the pixel, with
// the depth of the hit. One vertex and one fragment program for every pass; which, a pass says by one of
//   RILL_PASS_FORWARD   lit, with the main light's shadow
//   RILL_PASS_DEPTH     depth alone
//   RILL_PASS_NORMALS   world normals
//   RILL_PASS_SHADOW    into a shadow map, or the Built-in pipeline's depth texture
//   RILL_PASS_MOTION    motion on the screen
// and the SubShader around it says for which pipeline, see View.hlsl. Includes nothing of Unity's.
//
//   _Tags         uint, the phase in the highest byte, see ParticleTags.hlsl; where RILL_TAGS is on
//   and the buffers of DrawnParticles.hlsl
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

#include "Billboard.hlsl"
#include "DrawnParticles.hlsl"

float4x4 _DomainToWorld;        // from the domain's frame in d to world, meters
float4x4 _LastDomainToWorld;    // at the frame before
float _ParticleRadius;          // m

#ifdef RILL_PASS_FORWARD
#ifdef RILL_TAGS
#include "../Generated/ParticleRenderer.hlsl"
#include "../Generated/ParticleTags.hlsl"

StructuredBuffer<uint> _Tags;
float4 _PhaseColors[kPhases];   // linear
#endif
float _ParticleSpacing;         // m
float4 _SlowColor;              // linear, at value 0 of the ramp
float4 _MiddleColor;            // at 0.5
float4 _FastColor;              // at 1
float4 _ColorRange;             // ramp value = speed * x + (density - 1) * y + z
float4 _AmbientColor;           // linear
#endif

struct ParticleVaryings
{
    float4 clip : SV_Position;
    float3 world : TEXCOORD0;               // on the quad
    // The fourth components are free: a register each, as some translators of SV_RenderTargetArrayIndex need it.
    nointerpolation float4 center : TEXCOORD1;
#if defined(RILL_PASS_FORWARD)
    nointerpolation float4 color : TEXCOORD2;
#elif defined(RILL_PASS_MOTION)
    nointerpolation float4 displacement : TEXCOORD2;    // since the last frame, m
#endif
    RILL_VIEW_OUTPUT
};

#ifdef RILL_PASS_FORWARD
float3 RampColor(float value)
{
    value = saturate(value);
    return value < 0.5 ? lerp(_SlowColor.rgb, _MiddleColor.rgb, value * 2.0) : lerp(_MiddleColor.rgb, _FastColor.rgb, value * 2.0 - 1.0);
}

float3 ParticleColor(uint i)
{
#ifdef RILL_TAGS
    return _PhaseColors[min(_Tags[i] >> kTagPhaseShift, kPhases - 1)].rgb;
#else
    float4 velocity = _Velocities[i];
    float speed = length(velocity.xyz) * _ParticleSpacing;
    return RampColor(speed * _ColorRange.x + (velocity.w - 1.0) * _ColorRange.y + _ColorRange.z);
#endif
}
#endif

ParticleVaryings ParticleVertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
{
    ParticleVaryings result = (ParticleVaryings)0;
    bool drawn = SelectView(instance);
    PassViewOn(result);
    result.clip = kNowhere;
    if (!drawn)
        return result;

    uint i = vertex / 6;
    float3 center = mul(_DomainToWorld, float4(DrawnPosition(i), 1.0)).xyz;
    result.center = float4(center, 1.0);
#if defined(RILL_PASS_FORWARD)
    result.color = float4(ParticleColor(i), 1.0);
#elif defined(RILL_PASS_MOTION)
    result.displacement = float4(center - mul(_LastDomainToWorld, float4(LastDrawnPosition(i), 1.0)).xyz, 0.0);
#endif

    result.world = PointOnQuad(center, QuadCorner(vertex), SilhouetteRadius(center, _ParticleRadius));
    result.clip = WorldToClip(result.world);
    return result;
}

struct SphereHit
{
    float3 world;
    float3 normal;
    float3 ray;         // unit, away from the eye
};

// Discards what passes the sphere by.
SphereHit HitSphere(ParticleVaryings input)
{
    SphereHit hit;
    hit.ray = -ToEye(input.world);
    float3 toCenter = input.center.xyz - input.world;
    float along = dot(toCenter, hit.ray);
    float3 offset = toCenter - hit.ray * along;
    float missing = _ParticleRadius * _ParticleRadius - dot(offset, offset);
    if (missing < 0.0)
        discard;
    hit.world = input.world + hit.ray * (along - sqrt(max(missing, 0.0)));
    hit.normal = (hit.world - input.center.xyz) / _ParticleRadius;
    return hit;
}

float4 ParticleFragment(ParticleVaryings input, out float depth : SV_Depth) : SV_Target
{
    RestoreView(input);
    SphereHit hit = HitSphere(input);
#if defined(RILL_PASS_SHADOW)
    float4 clip = ShadowClip(hit.world, hit.normal);
#elif defined(RILL_PASS_MOTION)
    float4 clip = MotionClip(WorldToClip(hit.world));
#else
    float4 clip = WorldToClip(hit.world);
#endif
    depth = DeviceDepth(clip);

#if defined(RILL_PASS_FORWARD)
    MainLight light = GetMainLight();
    float3 lightColor = light.color * MainLightShadow(light, hit.world, clip);
    float diffuse = saturate(dot(hit.normal, light.direction) * 0.6 + 0.4);
    float highlight = pow(saturate(dot(reflect(hit.ray, hit.normal), light.direction)), 40.0);
    float rim = 1.0 - saturate(-dot(hit.ray, hit.normal));
    float3 sky = _AmbientColor.rgb * (0.6 + 0.4 * hit.normal.y);
    return float4(input.color.rgb * (sky + lightColor * diffuse) + lightColor * (0.25 * highlight) + sky * (0.2 * rim * rim * rim), 1.0);
#elif defined(RILL_PASS_NORMALS)
    return ScreenNormal(hit.normal);
#elif defined(RILL_PASS_MOTION)
    return ScreenMotion(hit.world, hit.world - input.displacement.xyz);
#else
    return depth;
#endif
}
