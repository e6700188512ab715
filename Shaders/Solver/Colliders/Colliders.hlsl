// Solid colliders: their shapes as signed distances, their motion in a substep, and which of them are near a point.
// Lengths in d, in the domain's frame. Include after Solver.hlsl.
#ifndef RILL_COLLIDERS_INCLUDED
#define RILL_COLLIDERS_INCLUDED

#include "../../Generated/Colliders.hlsl"
#include "../../Gpu/Rotations.hlsl"

static const uint kNoCollider = 0xFFFFu;

static const float kSameSurfaceCosine = 0.9;          // cosine between the normals of surfaces that are one
static const float kOtherSurfaceCosine = 0.5;         // and of those that are two

StructuredBuffer<Collider> _Colliders;
Texture3D<float> _Fields;                   // the distances of all meshes, brick by brick; see FieldAtlas.cs
Texture3D<float> _Heights;                  // the heights of all height fields, likewise
SamplerState sampler_LinearClamp;

// ---- frames

float3 ToCollider(Collider collider, float3 p)
{
    return Unrotate(collider.rotation, p - collider.position);
}

// Converts to the frame at the start of the substep.
float3 ToLastCollider(Collider collider, float3 p)
{
    return Unrotate(collider.lastRotation, p - collider.lastPosition);
}

float3 FromCollider(Collider collider, float3 local)
{
    return collider.position + Rotate(collider.rotation, local);
}

float3 FromLastCollider(Collider collider, float3 local)
{
    return collider.lastPosition + Rotate(collider.lastRotation, local);
}

// ---- signed distances in a collider's own frame: xyz the direction in which the distance grows, w the distance

float4 SphereDistance(float3 p, float radius)
{
    float lengthSquared = dot(p, p);
    float inverse = lengthSquared > 1e-12 ? rsqrt(lengthSquared) : 0.0;
    return float4(inverse > 0.0 ? p * inverse : float3(0.0, 1.0, 0.0), lengthSquared * inverse - radius);
}

float4 BoxDistance(float3 p, float3 halfSides)
{
    float3 side = p >= 0.0 ? 1.0 : -1.0;
    float3 q = abs(p) - halfSides;
    float3 beyond = max(q, 0.0);
    float lengthSquared = dot(beyond, beyond);
    if (lengthSquared > 0.0)
    {
        float inverse = rsqrt(lengthSquared);
        return float4(side * beyond * inverse, lengthSquared * inverse);
    }
    float nearest = max(q.x, max(q.y, q.z));
    float3 face = q.x == nearest ? float3(1.0, 0.0, 0.0) : q.y == nearest ? float3(0.0, 1.0, 0.0) : float3(0.0, 0.0, 1.0);
    return float4(side * face, nearest);
}

// Position in the atlas of the collider's shape.
float3 FieldPosition(Collider collider, float3 p)
{
    return collider.fieldCenter + p * collider.fieldScale;
}

// Whether a collider's field changes in the substep. Where none of a fluid's does, kernels are compiled without it (RILL_DEFORMING): with
// a look at the flag for each look-up, 256 colliders at rest took an eighth more.
bool Deforms(Collider collider)
{
#ifdef RILL_DEFORMING
    return (collider.flags & kDeforms) != 0;
#else
    return false;
#endif
}

// Distance of a mesh that deforms, at a blend of two fields: 0 where the steps of a frame start, 1 where they end.
float BlendedDistance(Collider collider, float3 p, float blend)
{
    float3 position = FieldPosition(collider, p);
    float stored = _Fields.SampleLevel(sampler_LinearClamp, position, 0.0);
    if (Deforms(collider))
        stored = lerp(_Fields.SampleLevel(sampler_LinearClamp, position + float3(0.0, 0.0, collider.fieldBefore), 0.0), stored, blend);
    return stored * collider.fieldUnit;
}

float FieldDistance(Collider collider, float3 p)
{
    return BlendedDistance(collider, p, collider.blend);
}

// Inside its volume by central differences. Outside it the surface is taken to be where the nearest place inside sees it.
float4 MeshDistance(Collider collider, float3 p)
{
    float3 q = clamp(p, -collider.size, collider.size);
    float3 low = max(q - 0.5 * collider.voxel, -collider.size);
    float3 high = min(q + 0.5 * collider.voxel, collider.size);
    float3 slope = float3(FieldDistance(collider, float3(high.x, q.yz)) - FieldDistance(collider, float3(low.x, q.yz)),
        FieldDistance(collider, float3(q.x, high.y, q.z)) - FieldDistance(collider, float3(q.x, low.y, q.z)),
        FieldDistance(collider, float3(q.xy, high.z)) - FieldDistance(collider, float3(q.xy, low.z))) / max(high - low, 1e-6);
    float steepness = dot(slope, slope);
    float3 direction = steepness > 1e-8 ? slope * rsqrt(steepness) : float3(0.0, 1.0, 0.0);
    float distance = FieldDistance(collider, q);
    float3 fromSurface = p - q + direction * distance;
    float lengthSquared = dot(fromSurface, fromSurface);
    if (any(p != q) && lengthSquared > 0.0)
        return float4(fromSurface * rsqrt(lengthSquared), sqrt(lengthSquared));
    return float4(direction, distance);
}

float GroundHeight(Collider collider, float2 position)
{
    return _Heights.SampleLevel(sampler_LinearClamp, FieldPosition(collider, float3(position.x, 0.0, position.y)), 0.0) * collider.fieldUnit;
}

// From the ground below p as if it were a plane; beyond its sides there is none.
float4 HeightDistance(Collider collider, float3 p)
{
    float2 q = clamp(p.xz, -collider.size.xz, collider.size.xz);
    float2 beyond = p.xz - q;
    float height = GroundHeight(collider, q);
    float2 low = max(q - collider.voxel, -collider.size.xz);
    float2 high = min(q + collider.voxel, collider.size.xz);
    float2 slope = float2(GroundHeight(collider, float2(high.x, q.y)) - GroundHeight(collider, float2(low.x, q.y)),
        GroundHeight(collider, float2(q.x, high.y)) - GroundHeight(collider, float2(q.x, low.y))) / max(high - low, 1e-6);
    float fraction = rsqrt(1.0 + dot(slope, slope));
    float3 normal = float3(-slope.x, 1.0, -slope.y) * fraction;
    float distance = (p.y - height) * fraction;
    if (all(beyond == 0.0))
        return float4(normal, distance);
    float3 fromSurface = float3(beyond.x, 0.0, beyond.y) + normal * max(distance, 0.0);
    float lengthSquared = dot(fromSurface, fromSurface);
    return float4(fromSurface * rsqrt(lengthSquared), sqrt(lengthSquared));
}

float4 LocalDistance(Collider collider, float3 p)
{
    float4 result;
    if (collider.shape == kSphere)
        result = SphereDistance(p, collider.size.x);
    else if (collider.shape == kBox)
        result = BoxDistance(p, collider.size);
    else if (collider.shape == kCapsule)
        result = SphereDistance(p - float3(0.0, clamp(p.y, -collider.size.y, collider.size.y), 0.0), collider.size.x);
    else if (collider.shape == kPlane)
        result = float4(0.0, 1.0, 0.0, p.y);
    else if (collider.shape == kHeightField)
        result = HeightDistance(collider, p);
    else
        result = MeshDistance(collider, p);
    return (collider.flags & kInsideOut) != 0 ? -result : result;
}

// No further from the surface than this, signed, at a blend of its fields: for steps along a path.
float MinDistanceAt(Collider collider, float3 p, float blend)
{
    float3 q = clamp(p, -collider.size, collider.size);
    float outside = length(p - q);
    float distance;
    if (collider.shape == kMesh)
    {
        distance = BlendedDistance(collider, q, blend);
        distance = outside > 0.0 ? max(outside, distance - outside) : distance;
        distance = (collider.flags & kInsideOut) != 0 ? -distance : distance;
    }
    else if (collider.shape == kHeightField)
    {
        float2 beyond = p.xz - q.xz;
        distance = any(beyond != 0.0) ? length(beyond) : (p.y - GroundHeight(collider, q.xz)) * collider.minFraction;
    }
    else
        distance = LocalDistance(collider, p).w;
    return distance;
}

float MinDistance(Collider collider, float3 p)
{
    return MinDistanceAt(collider, p, collider.blend);
}

// Over the whole substep: for bins.
float MinDistanceOfSubstep(Collider collider, float3 p)
{
    float distance = MinDistance(collider, p);
    if (Deforms(collider))
        distance = min(distance, MinDistanceAt(collider, p, collider.lastBlend));
    return distance;
}

// The distance itself, where 'least' is what MinDistance says of p: less than it only over a height field.
float SurfaceDistance(Collider collider, float3 p, float least)
{
    return collider.shape == kHeightField ? HeightDistance(collider, p).w : least;
}

// In the domain's frame, at the end of the substep.
float4 DomainDistance(Collider collider, float3 p)
{
    float4 local = LocalDistance(collider, ToCollider(collider, p));
    return float4(Rotate(collider.rotation, local.xyz), local.w);
}

// ---- motion

// How far the surface near p, in the collider's own frame, comes out along its normal in the substep.
float Advance(Collider collider, float3 p)
{
    float advance = 0.0;
    if (Deforms(collider))
    {
        float3 q = clamp(p, -collider.size, collider.size);
        advance = BlendedDistance(collider, q, collider.lastBlend) - BlendedDistance(collider, q, collider.blend);
        advance = (collider.flags & kInsideOut) != 0 ? -advance : advance;
    }
    return advance;
}

// Deformation as a vector in the domain's frame. Only its part along the normal is known.
float3 Deformation(Collider collider, float3 p)
{
    float3 deformation = 0.0;
    if (Deforms(collider))
        deformation = Rotate(collider.rotation, LocalDistance(collider, p).xyz * Advance(collider, p));
    return deformation;
}

// How the collider's matter that is at p at the end of the substep moved in it.
float3 SurfaceMotion(Collider collider, float3 p)
{
    float3 local = ToCollider(collider, p);
    return p - FromLastCollider(collider, local) + Deformation(collider, local);
}

// How the collider's surface moves by a point: half of how matter came there in the substep and of how it would go on. What turns comes
// along a chord, which ends inward of where it began, but its surface as a whole goes nowhere.
float3 CentralMotion(Collider collider, float3 p)
{
    float3 local = ToCollider(collider, p);
    return 0.5 * (FromCollider(collider, ToLastCollider(collider, p)) - FromLastCollider(collider, local)) + Deformation(collider, local);
}

#endif
