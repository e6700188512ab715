// Light that has come into the water, followed from one side of a drop, a jet or a sheet to the other and over the picture to the opaque scene:
// where it ends, not what color it has there. Kernels follow it for each texel of the picture; an eye in the water does so itself. Includes nothing
// of Unity's.
//
//   the buffers of MeshField.hlsl, the scene's depth; where RILL_PHASES is on, that of PhaseGrid.hlsl
// Include after SurfaceView.hlsl and what defines eyeIndex.
#ifndef RILL_WATER_RAYS_INCLUDED
#define RILL_WATER_RAYS_INCLUDED

#include "SceneDepth.hlsl"
#include "MeshField.hlsl"
#include "PhaseGrid.hlsl"
#include "Optics.hlsl"
#include "SceneTrace.hlsl"
#include "Directions.hlsl"

static const uint kSegments = 4;            // of a ray: between two faces of the water
static const uint kWaterSteps = 12, kAirSteps = 16, kReflectionSteps = 40;
static const float kFarAway = 200.0;        // m: as far as rays in the air are followed
static const float kWaterBorder = 1.8;      // of half the picture: as far beyond it as rays in the water go
static const float kContact = 1.0;          // d: what stands as near behind a wall of the domain is in contact with the water

static const uint kEndsUnderWater = 0;      // on the scene, which stands in the water
static const uint kEndsInAir = 1;           // on the scene, beyond the water
static const uint kEndsAround = 2;          // on no picture: in the surroundings
static const uint kEndsAtWall = 3;          // behind a wall of the domain: what the picture shows there
static const uint kEndsInWater = 4;         // turned back and lost: as bright as the water
static const uint kNoRay = 5;

static float3 fieldShift = 0.0;     // from the field's frame to that which is drawn, d

struct WaterRay
{
    uint ends;
    float2 picture;         // where the scene is seen
    float3 direction;       // world, unit: that in which it ends; where it ends in sunlight, the scene's normal there
    float path;             // through water, m
    float mirrored;         // part of the light that the faces along it mirror, and not the first
    float3 turned;          // world, unit: from where most of that comes
    float turnedPath;       // part of the path up to there
    bool turnsInWater;      // it comes from the water
    float4 sun;             // rgb: sunlight where it ends, after its path through the water, over that of the light on what faces it; w: 1
                            // where that is known, else 0
    float3 phases;          // fractions of phases 1 to 3 along the path; 0 where RILL_PHASES is off
};

float3 ToDrawn(float3 p)
{
    return mul(_DomainToWorld, float4(p + fieldShift, 1.0)).xyz;
}

float3 InDomain(float3 world)
{
    return mul(_WorldToDomain, float4(world, 1.0)).xyz - fieldShift;
}

// None of those that are seen looks away.
float3 FacingNormal(float3 normal, float3 toEye)
{
    return normalize(normal + toEye * max(0.03 - dot(normal, toEye), 0.0));
}

// A ray that begins in the water, d, in the field's frame.
WaterRay TraceWater(float3 p, float3 along)
{
    WaterRay ray = (WaterRay)0;
    ray.ends = kEndsAround;
    float spacing = Spacing(), side = 1.0, index = _SurfaceOptics.x;
    float left = 1.0, strongest = 0.0, begin = 0.0, turnedAt = 0.0;
    bool isDone = false, isTurned = false;
    float4 phases = 0.0;
    [loop]
    for (uint i = 0; i < kSegments && !isDone; i++)
    {
        bool isWater = side > 0.0, found;
        float3 normal;
        float end = BoxExit(p, along, normal), reach = MarchMesh(p, along, side, begin, end, found);
        float3 direction = mul((float3x3)_DomainToWorld, along) / spacing;
        float traced = found ? reach * spacing : isWater ? (reach + kContact) * spacing : kFarAway;
        SceneTrace seen = TraceScene(ToDrawn(p), direction * traced, isWater ? kWaterSteps : kAirSteps, isWater ? kWaterBorder : 1.0);
        if (isWater)
        {
            float through = min(seen.found ? traced * seen.reach : traced, reach * spacing);
            ray.path += through;
#ifdef RILL_PHASES
            if (_HasPhases > 0.5)
                AddPhases(p, along, through / spacing, phases);
#endif
        }
        ray.direction = direction;
        ray.picture = seen.picture;
        isDone = true;
        if (seen.found && isWater)
            ray.ends = kEndsUnderWater;
        else if (seen.found || !found && !isWater)
            ray.ends = seen.found || seen.open || seen.hidden ? kEndsInAir : kEndsAround;
        else if (!found && !seen.open)
            // A wall that something hides, or beyond the picture.
            ray.ends = isTurned ? kEndsInWater : kEndsAtWall;
        else
        {
            isDone = false;
            p += along * reach;
            normal = found ? MeshNormal(p) * side : normal;     // turned to where the ray goes
            float cosine = dot(along, normal);
            normal = normalize(normal + along * max(0.02 - cosine, 0.0));
            cosine = dot(along, normal);
            float ratio = isWater ? index : 1.0 / index, reflectance = Reflectance(cosine, ratio);
            float3 turned = reflect(along, normal);
            if (reflectance < 1.0)
            {
                float part = left * reflectance;
                if (part > strongest)
                {
                    strongest = part;
                    turnedAt = ray.path;
                    ray.turned = mul((float3x3)_DomainToWorld, turned) / spacing;
                    ray.turnsInWater = isWater;
                }
                ray.mirrored += part;
                left -= part;
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
    {
        ray.ends = kEndsAround;
        ray.direction = mul((float3x3)_DomainToWorld, along) / spacing;
    }
    ray.turnedPath = turnedAt / max(ray.path, 1e-6);
    ray.phases = MeanPhases(phases);
    return ray;
}

// Returns where the scene is that the surface mirrors. What is hardly seen is followed in fewer steps.
SceneTrace TraceMirrored(float3 world, float3 direction, float reflectance)
{
    uint steps = (uint)clamp(reflectance * 4.0 * kReflectionSteps, kReflectionSteps / 4, kReflectionSteps);
    return TraceScene(world, direction * kFarAway, steps, 1.0);
}

// ---- in textures of 16 bits a channel: points of the picture from that of the texel on

struct PackedRay
{
    float4 ends;            // xy point of the picture, z path, m, w kind of the end
    float4 directions;      // of the end, and of what is mirrored
    float4 mirrored;        // xy point of the picture that the surface mirrors, or kNoPoint; z, w: mirrored and turnedPath
    float4 sun;             // see WaterRay
    float3 phases;          // see there too
};

static const float kNoPoint = 8.0;

PackedRay NoRay()
{
    PackedRay packed = (PackedRay)0;
    packed.ends.w = kNoRay;
    packed.mirrored.xy = kNoPoint;
    return packed;
}

PackedRay PackRay(WaterRay ray, float2 picture)
{
    PackedRay packed;
    packed.ends = float4(ray.picture - picture, ray.path, ray.ends);
    packed.directions = float4(PackDirection(ray.direction), PackDirection(ray.turned));
    packed.mirrored = float4(kNoPoint, kNoPoint, ray.mirrored, ray.turnedPath);
    packed.sun = ray.sun;
    packed.phases = ray.phases;
    return packed;
}

WaterRay UnpackRay(PackedRay packed, float2 picture)
{
    WaterRay ray = (WaterRay)0;
    ray.ends = uint(packed.ends.w);
    ray.picture = packed.ends.xy + picture;
    ray.path = packed.ends.z;
    ray.direction = UnpackDirection(packed.directions.xy);
    ray.turned = UnpackDirection(packed.directions.zw);
    ray.mirrored = packed.mirrored.z;
    ray.turnedPath = packed.mirrored.w;
    ray.sun = packed.sun;
    ray.phases = packed.phases;
    return ray;
}

#endif
