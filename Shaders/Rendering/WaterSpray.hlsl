// Draws foam, spray and small droplets in front of the water and on it, over the tiles of the picture that show some. The SubShader around it says
// for which pipeline, see View.hlsl.
#include "Water.hlsl"
#include "Droplets.hlsl"
#include "SprayLayer.hlsl"

static const float kMaxDroplets = 4.0;      // that cover all of a texel, and send light to the eye
static const float kLayerStep = 2.0;        // texels between the heaps of foam that shade each other
static const float kShade = 0.35;           // how much light is gone behind a heap, for each optical depth that it is thicker

// Light that reaches foam between heaps of more of it. more: optical depth of those over its own.
float Unshaded(float more)
{
    return exp(-kShade * clamp(more, 0.0, 8.0));
}

float4 SprayFragment(SurfaceVaryings input) : SV_Target
{
    RestoreView(input);
    float2 picture = input.picture.xy;
    float4 spray = SprayAt(picture, eyeIndex, rill_linear_clamp_sampler);
    if (spray.x + spray.y < 1e-3)
        discard;
    SurfaceRay ray = RayThrough(picture, eyeIndex);
    float3 world = ray.origin + ray.direction * spray.z, up = float3(0.0, 1.0, 0.0);
    MainLight light = LightOfWater();
    float3 sun = light.color * MainLightShadow(light, world, WorldToClip(world)), around = Ambient(world, up);

    // Small droplets show what is behind them but for what they gather, and the sun, whose light goes through those in front.
    float body = 1.0 - exp(-kGathered * spray.y);
    float3 color = body * around + min(spray.y, kMaxDroplets) * sun * LightThroughBall(dot(light.direction, normalize(ray.direction)));

    float foam = 1.0 - exp(-spray.x);
    if (foam > 0.0)
    {
        float2 texel = 2.0 * kLayerStep * _FoamSize.zw;
        float4 clip = SurfaceClip(world + light.direction * 0.1, eyeIndex);
        float2 toLight = clip.xy / max(clip.w, 1e-6) - picture;
        toLight *= texel / max(length(toLight / texel), 1e-6) / texel;
        float3 beside = float3(texel, 0.0);
        float more = 0.25 * (SprayAt(picture + beside.xz, eyeIndex, rill_linear_clamp_sampler).w
            + SprayAt(picture - beside.xz, eyeIndex, rill_linear_clamp_sampler).w
            + SprayAt(picture + beside.zy, eyeIndex, rill_linear_clamp_sampler).w
            + SprayAt(picture - beside.zy, eyeIndex, rill_linear_clamp_sampler).w) - spray.w;
        float shading = SprayAt(picture + toLight, eyeIndex, rill_linear_clamp_sampler).w - spray.w;
        float3 lit = LitFoam(around * Unshaded(more), sun * Unshaded(shading), light.direction.y);
        color = lerp(color, lit, foam);
        body = lerp(body, 1.0, foam);
    }
    return float4(ApplyFog(color, body, spray.z), body);
}
