// Light of the scene's surroundings from a direction: the reflection probes, light probes and sky that the pipeline gives, or a
// cube map of the user's own where RILL_OWN_REFLECTION is on. Includes nothing of Unity's; see View.hlsl.
//
//   _ReflectionCube      of the user's own; linear. In HDRP, whose light has units: nits
//   _ReflectionStrength  factor, see SurfaceView.hlsl
#ifndef RILL_ENVIRONMENT_INCLUDED
#define RILL_ENVIRONMENT_INCLUDED

#include "View.hlsl"

SamplerState rill_linear_clamp_sampler;

static const float kReflectionLevels = 6.0;     // mips over which a probe goes from a mirror to matt, in every pipeline

#if defined(RILL_OWN_REFLECTION)
TextureCube _ReflectionCube;
SamplerState sampler_ReflectionCube;
#elif !defined(RILL_HIGH_DEFINITION)
// Those of the draw, which Unity chooses by where it is. Without a probe the first is the sky's.
TextureCube unity_SpecCube0;
TextureCube unity_SpecCube1;
SamplerState samplerunity_SpecCube0;
float4 unity_SpecCube0_HDR;
float4 unity_SpecCube0_BoxMin;          // w: in the Built-in pipeline how much the first counts
float4 unity_SpecCube0_BoxMax;          // w: in URP the distance over which it fades towards its sides, m
float4 unity_SpecCube0_ProbePosition;   // w above 0: projected onto its box
float4 unity_SpecCube1_HDR;
float4 unity_SpecCube1_BoxMin;          // w: in URP by how much more important the first is
float4 unity_SpecCube1_BoxMax;
float4 unity_SpecCube1_ProbePosition;
#endif
#if defined(RILL_HIGH_DEFINITION)
TextureCubeArray _SkyTexture;   // HDRP's sky, nits; the first is as a shiny surface reflects it
SamplerState rill_trilinear_clamp_sampler;
#else
// Light probes at the draw, or the ambient light.
float4 unity_SHAr;
float4 unity_SHAg;
float4 unity_SHAb;
float4 unity_SHBr;
float4 unity_SHBg;
float4 unity_SHBb;
float4 unity_SHC;
#endif
#if defined(RILL_UNIVERSAL) && !defined(RILL_OWN_REFLECTION)
TextureCube _GlossyEnvironmentCubeMap;
SamplerState sampler_GlossyEnvironmentCubeMap;
float4 _GlossyEnvironmentCubeMap_HDR;
// Forward+ gives no probes to draws: all that a camera sees are in one texture, as octahedra. Elsewhere their number is 0.
#define RILL_MAX_PROBES 64
#define RILL_PROBE_MIPS 7
Texture2D urp_ReflProbes_Atlas;
float urp_ReflProbes_Count;
cbuffer urp_ReflectionProbeBuffer
{
    float4 urp_ReflProbes_BoxMax[RILL_MAX_PROBES];
    float4 urp_ReflProbes_BoxMin[RILL_MAX_PROBES];
    float4 urp_ReflProbes_ProbePosition[RILL_MAX_PROBES];      // w: its mips, below 0 where it is not projected onto its box
    float4 urp_ReflProbes_MipScaleOffset[RILL_MAX_PROBES * RILL_PROBE_MIPS];
};
#endif

// HDRP's color buffer holds light times the camera's exposure, and so does the copy of the scene: what is added must be exposed too.
#if defined(RILL_HIGH_DEFINITION)
Texture2D _ExposureTexture;
#define RILL_EXPOSURE _ExposureTexture.Load(int3(0, 0, 0)).r
#else
#define RILL_EXPOSURE 1.0
#endif

// x times the alpha channel to the power of y, as far as w says that alpha holds a factor.
float3 DecodeProbe(float4 sampled, float4 hdr)
{
    float alpha = max(hdr.w * (sampled.a - 1.0) + 1.0, 0.0);
    return hdr.x * pow(max(alpha, 1e-6), hdr.y) * sampled.rgb;
}

#if !defined(RILL_OWN_REFLECTION) && !defined(RILL_HIGH_DEFINITION)

// Returns where a ray from a point of the world hits the walls of a probe's box, seen from the probe.
float3 ProjectedOnBox(float3 direction, float3 world, float4 probe, float4 low, float4 high)
{
    if (probe.w <= 0.0)
        return direction;
    float3 safe = abs(direction) > 1e-6 ? direction : 1e-6;
    float3 reach = ((safe > 0.0 ? high.xyz : low.xyz) - world) / safe;
    return world - probe.xyz + direction * min(reach.x, min(reach.y, reach.z));
}

float3 FirstProbe(float3 world, float3 direction, float level)
{
    float3 at = ProjectedOnBox(direction, world, unity_SpecCube0_ProbePosition, unity_SpecCube0_BoxMin, unity_SpecCube0_BoxMax);
    return DecodeProbe(unity_SpecCube0.SampleLevel(samplerunity_SpecCube0, at, level), unity_SpecCube0_HDR);
}

float3 SecondProbe(float3 world, float3 direction, float level)
{
    float3 at = ProjectedOnBox(direction, world, unity_SpecCube1_ProbePosition, unity_SpecCube1_BoxMin, unity_SpecCube1_BoxMax);
    return DecodeProbe(unity_SpecCube1.SampleLevel(samplerunity_SpecCube0, at, level), unity_SpecCube1_HDR);
}

#endif
#if defined(RILL_UNIVERSAL) && !defined(RILL_OWN_REFLECTION)

// How much of a probe is seen at a point: all inside of its box, none at its sides.
float ProbeWeight(float3 world, float4 low, float4 high)
{
    float3 inside = min(world - low.xyz, high.xyz - world) / max(high.w, 1e-4);
    return saturate(min(inside.x, min(inside.y, inside.z)));
}

float3 AtlasMip(uint probe, float2 octahedron, float mip)
{
    float4 part = urp_ReflProbes_MipScaleOffset[probe * RILL_PROBE_MIPS + uint(mip)];
    return urp_ReflProbes_Atlas.SampleLevel(rill_linear_clamp_sampler, octahedron * part.xy + part.zw, 0).rgb;
}

float3 AtlasProbe(uint probe, float3 world, float3 direction, float level)
{
    float4 position = urp_ReflProbes_ProbePosition[probe];
    float3 n = ProjectedOnBox(direction, world, position, urp_ReflProbes_BoxMin[probe], urp_ReflProbes_BoxMax[probe]);
    n /= max(dot(abs(n), 1.0), 1e-6);
    float folded = saturate(-n.z);
    float2 octahedron = saturate((n.xy + (n.xy >= 0.0 ? folded : -folded)) * 0.5 + 0.5);
    float last = max(abs(position.w) - 1.0, 0.0), mip = clamp(level, 0.0, last);
    return lerp(AtlasMip(probe, octahedron, floor(mip)), AtlasMip(probe, octahedron, min(floor(mip) + 1.0, last)), frac(mip));
}

// Blends probes like the clustered renderer and the others of URP, whatever the asset says of blending and boxes. The sky is the rest.
float3 ProbesOfUniversal(float3 world, float3 direction, float level)
{
    float3 sum = 0.0;
    float rest = 1.0;
    uint count = min(uint(urp_ReflProbes_Count), RILL_MAX_PROBES);
    for (uint i = 0; i < count && rest > 0.01; i++)     // the most important first
    {
        float weight = min(ProbeWeight(world, urp_ReflProbes_BoxMin[i], urp_ReflProbes_BoxMax[i]), rest);
        if (weight > 0.0)
            sum += weight * AtlasProbe(i, world, direction, level);
        rest -= weight;
    }
    if (count == 0)
    {
        float first = ProbeWeight(world, unity_SpecCube0_BoxMin, unity_SpecCube0_BoxMax);
        float second = ProbeWeight(world, unity_SpecCube1_BoxMin, unity_SpecCube1_BoxMax);
        float3 size0 = unity_SpecCube0_BoxMax.xyz - unity_SpecCube0_BoxMin.xyz, size1 = unity_SpecCube1_BoxMax.xyz - unity_SpecCube1_BoxMin.xyz;
        float smaller = dot(size1, size1) - dot(size0, size0), importance = unity_SpecCube1_BoxMin.w;
        bool firstLeads = importance > 0.0 || importance == 0.0 && smaller > 1e-4;
        bool secondLeads = importance < 0.0 || importance == 0.0 && smaller < -1e-4;
        float alone = first;
        first = secondLeads ? min(first, 1.0 - second) : first;
        second = firstLeads ? min(second, 1.0 - alone) : second;
        float most = max(first + second, 1.0);
        rest = 1.0 - (first + second) / most;
        if (first > 0.0)
            sum += first / most * FirstProbe(world, direction, level);
        if (second > 0.0)
            sum += second / most * SecondProbe(world, direction, level);
    }
    if (rest > 0.01)
        sum += rest * DecodeProbe(_GlossyEnvironmentCubeMap.SampleLevel(sampler_GlossyEnvironmentCubeMap, direction, level),
            _GlossyEnvironmentCubeMap_HDR);
    return sum;
}

#endif

// Returns what is visible in a direction from a point of the world, linear. roughness: perceptual, 0 a mirror.
float3 Mirrored(float3 world, float3 direction, float roughness)
{
    float level = roughness * (1.7 - 0.7 * roughness) * kReflectionLevels;
#if defined(RILL_OWN_REFLECTION)
    return _ReflectionStrength * RILL_EXPOSURE * _ReflectionCube.SampleLevel(sampler_ReflectionCube, direction, level).rgb;
#elif defined(RILL_UNIVERSAL)
    return _ReflectionStrength * ProbesOfUniversal(world, direction, level);
#elif defined(RILL_BUILT_IN)
    float3 color = FirstProbe(world, direction, level);
    if (unity_SpecCube0_BoxMin.w < 0.9999)
        color = lerp(SecondProbe(world, direction, level), color, unity_SpecCube0_BoxMin.w);
    return _ReflectionStrength * color;
#else
    return _ReflectionStrength * RILL_EXPOSURE * _SkyTexture.SampleLevel(rill_trilinear_clamp_sampler, float4(direction, 0.0), level).rgb;
#endif
}

// Returns what a white surface of the scene that faces there shows of the light around.
float3 AmbientOfScene(float3 normal)
{
#if !defined(RILL_HIGH_DEFINITION)
    float4 first = float4(normal, 1.0), second = normal.xyzz * normal.yzzx;
    float3 light = float3(dot(unity_SHAr, first), dot(unity_SHAg, first), dot(unity_SHAb, first));
    light += float3(dot(unity_SHBr, second), dot(unity_SHBg, second), dot(unity_SHBb, second));
    light = max(light + unity_SHC.rgb * (normal.x * normal.x - normal.y * normal.y), 0.0);
#ifdef UNITY_COLORSPACE_GAMMA
    light = max(1.055 * pow(max(light, 1e-6), 1.0 / 2.4) - 0.055, 0.0);     // the harmonics are linear even there
#endif
    return light;
#else
    return RILL_EXPOSURE * _SkyTexture.SampleLevel(rill_trilinear_clamp_sampler, float4(normal, 0.0), kReflectionLevels).rgb;
#endif
}

// Returns the ambient light of a part of the water, as it mirrors its surroundings.
float3 Ambient(float3 world, float3 normal)
{
#if defined(RILL_OWN_REFLECTION)
    return Mirrored(world, normal, 1.0);
#else
    return _ReflectionStrength * AmbientOfScene(normal);
#endif
}

#endif
