// The two passes that draw particles for the water's surface, into textures of its own; see FluidSurfaceRecorder.cs. A pass says by
// one of
//   RILL_PASS_DEPTH      ellipsoids of the surface: the device's depth
//   RILL_PASS_THICKNESS  balls of all particles, added up: how much water the ray goes through in front of the scene, m
//
//   _SurfaceParticles   in   see SurfaceParticle.hlsl; of RILL_PASS_DEPTH
//   and the buffers of DrawnParticles.hlsl
#include "SurfaceQuadric.hlsl"
#include "DrawnParticles.hlsl"

float4x4 _DomainToWorld;        // from the domain's frame in d to world, metres

#ifdef RILL_PASS_DEPTH
#include "SurfaceParticle.hlsl"
StructuredBuffer<SurfaceParticle> _SurfaceParticles;
#if defined(SHADER_API_GLCORE) || defined(SHADER_API_GLES3)
#define RILL_CONSERVATIVE_DEPTH SV_DepthGreaterEqual
#else
#define RILL_CONSERVATIVE_DEPTH SV_DepthLessEqual
#endif
#else
#ifdef RILL_SCENE_ARRAY
Texture2DArray _CameraDepthTexture;
#else
Texture2D _CameraDepthTexture;
#endif
float4 _SceneSize;              // of the scene's depth: width and height of what is in use, texels
float _ParticleSpacing;         // m

static const float kBallRadius = 0.65;          // d; wider ones would be more and smaller terms of sums that a half has to hold
static const float kFillingRadius = 0.62035;    // d, of a ball with the volume of a particle
#endif

struct RasterVaryings
{
    float4 clip : SV_Position;
    float3 origin : TEXCOORD0;      // of the ray, in the frame in which the ellipsoid is a ball of radius 1
    float3 direction : TEXCOORD1;
#ifdef RILL_PASS_THICKNESS
    nointerpolation float2 amount : TEXCOORD2;      // m of water for each m of the ball along the view, in either channel
    float2 picture : TEXCOORD3;
#endif
};

Ellipsoid DrawnEllipsoid(uint i, out float amount)
{
    Ellipsoid e;
#ifdef RILL_PASS_DEPTH
    float3 center, chord;
    float3x3 axes;
    uint index;
    UnpackSurface(_SurfaceParticles[i], center, axes, index, chord);
    center = clamp(center + chord * _FrameLag.x, min(center, 0.0), max(center, _DrawnDomainSize.xyz));
    e.center = mul(_DomainToWorld, float4(center, 1.0)).xyz;
    e.a = mul((float3x3)_DomainToWorld, axes[0]);
    e.b = mul((float3x3)_DomainToWorld, axes[1]);
    e.c = mul((float3x3)_DomainToWorld, axes[2]);
    amount = 0.0;
#else
    e.center = mul(_DomainToWorld, float4(DrawnPosition(i), 1.0)).xyz;
    // At least a texel wide: the same water over a wider ball.
    float depth = dot(_SurfaceWorldToClip[_SurfaceEye][3], float4(e.center, 1.0));
    float texel = 2.0 * _SurfaceSize.w * max(depth, 0.0) * length(_SurfaceRays[_SurfaceEye * 6 + 5].xyz + _SurfaceRays[_SurfaceEye * 6 + 2].xyz);
    float radius = max(kBallRadius * _ParticleSpacing, 0.75 * texel);
    float filled = kFillingRadius * _ParticleSpacing / radius;
    amount = filled * filled * filled;
    e.a = float3(radius, 0, 0);
    e.b = float3(0, radius, 0);
    e.c = float3(0, 0, radius);
#endif
    return e;
}

RasterVaryings RasterVertex(uint vertex : SV_VertexID)
{
    static const float2 kCorners[6] = { float2(0, 0), float2(0, 1), float2(1, 1), float2(0, 0), float2(1, 1), float2(1, 0) };
    RasterVaryings result = (RasterVaryings)0;
    result.clip = float4(2, 2, 2, 1);
    float amount;
    Ellipsoid e = DrawnEllipsoid(vertex / 6, amount);
    PictureBounds bounds = BoundsOf(e, _SurfaceEye);
    if (!bounds.isSeen)
        return result;

    float2 picture = lerp(bounds.low, bounds.high, kCorners[vertex % 6]);
    RayInBall(e, RayThrough(picture, _SurfaceEye), result.origin, result.direction);
    result.clip = SurfacePosition(picture, bounds.nearest);
#ifdef RILL_PASS_THICKNESS
    // Two channels with half of the particles each: a sum of many in a half loses what is below its last bit.
    result.amount = amount * ((vertex / 6) & 1 ? float2(1.0, 0.0) : float2(0.0, 1.0));
    result.picture = picture;
#endif
    return result;
}

#ifdef RILL_PASS_DEPTH

void DepthFragment(RasterVaryings input, out float depth : RILL_CONSERVATIVE_DEPTH)
{
    float2 hit;
    if (!HitBall(input.origin, input.direction, hit))
        discard;
    depth = FlipDepth(ToSurfaceDepth(hit.x, _SurfaceEye));
}

#else

float4 ThicknessFragment(RasterVaryings input) : SV_Target
{
    float2 hit;
    if (!HitBall(input.origin, input.direction, hit))
        discard;
    uint2 texel = uint2(clamp((input.picture * 0.5 + 0.5) * _SceneSize.xy, 0.0, _SceneSize.xy - 1.0));
#ifdef RILL_SCENE_ARRAY
    float scene = _CameraDepthTexture.Load(int4(texel, _SurfaceEye, 0)).r;
#else
    float scene = _CameraDepthTexture.Load(int3(texel, 0)).r;
#endif
    float seen = min(hit.y, FromSurfaceDepth(FlipDepth(scene), _SurfaceEye)) - max(hit.x, 0.0);
    if (seen <= 0.0)
        discard;
    return float4(seen * length(RayThrough(input.picture, _SurfaceEye).direction) * input.amount, 0.0, 0.0);
}

#endif
