// The part of a collider's surface that water touches: area, mean normal and center. Each particle near the surface stands for the part
// below it, as large as a face of its cube. Exact and independent of their order: integers, 64 bits each. Include after ColliderBins.hlsl
// and RWStructuredBuffer<uint> _Reactions is declared.
#ifndef RILL_WETTED_AREA_INCLUDED
#define RILL_WETTED_AREA_INCLUDED

#include "Reactions.hlsl"

static const float kHalfGap = 0.05;         // d: what is as far above the surface and in another collider is covered by that
static const float kCurvatureStep = 0.5;    // d, of differences between normals
static const float kMaxBelow = 2.0;         // of a length on the surface over that above it

// Weight of a particle at this distance from the surface, in faces of its cube. Over two spacings it comes to one, so that the layers
// of resting water, the first denser than the second, count right together; one alone counts three quarters.
float LayerFraction(float distance)
{
    return saturate(1.0 - distance / kSupport);
}

// Area of the surface below an area of 1 at this distance over it. What is curved along all directions alike has 'sides' of 2, what is
// curved along one of 1. From inside the radius is negative, and towards the center there is no limit to that area.
float BelowCurved(float radius, float distance, float sides)
{
    float over = radius + distance;
    float below = radius * over > 0.0 ? radius / over : 0.0;
    return pow(clamp(below, 0.0, kMaxBelow), sides);
}

float3 FieldNormal(Collider collider, float3 p)
{
    float3 normal = collider.shape == kHeightField ? HeightDistance(collider, p).xyz : MeshDistance(collider, p).xyz;
    return (collider.flags & kInsideOut) != 0 ? -normal : normal;
}

// Returns the fraction below for a field, by how its normals turn along the axes.
float BelowField(Collider collider, float3 p, float distance)
{
    float3 turnX = 0.0, turnY = 0.0, turnZ = 0.0;
    [loop]
    for (uint axis = 0; axis < 3; axis++)
    {
        float3 ahead = kCurvatureStep * float3(axis == 0, axis == 1, axis == 2);
        float3 turn = (FieldNormal(collider, p + ahead) - FieldNormal(collider, p - ahead)) / (2.0 * kCurvatureStep);
        turnX = axis == 0 ? turn : turnX;
        turnY = axis == 1 ? turn : turnY;
        turnZ = axis == 2 ? turn : turnZ;
    }
    float sum = turnX.x + turnY.y + turnZ.z;
    float product = turnX.x * turnY.y - turnX.y * turnY.x + turnX.x * turnZ.z - turnX.z * turnZ.x + turnY.y * turnZ.z - turnY.z * turnZ.y;
    return clamp(1.0 - distance * sum + distance * distance * product, 0.0, 4.0);
}

bool IsCovered(uint owner, float3 p)
{
    bool covered = false;
    uint cell = ColliderCell(p);
    FOR_COLLIDERS(cell, index)
        covered = covered || index != owner && DomainDistance(_Colliders[index], p).w < 0.0;
    END_COLLIDERS
    return covered;
}

// A particle at p wets 'area' of a collider, d², 'distance' below it against 'normal'; both are of the collider's own frame.
void AddWettedArea(uint owner, Collider collider, float3 p, float3 normal, float distance, float area)
{
    if (area <= 0.0)
        return;
    float3 foot = p - normal * distance;
    if (IsCovered(owner, FromCollider(collider, foot + normal * kHalfGap)))
        return;
    int3 facing = int3(round(Rotate(collider.rotation, normal) * area * kReactionScale));
    int3 at = int3(round(Rotate(collider.rotation, foot) / collider.momentArm * area * kReactionScale));
    uint first = kWettedFirst + owner * kWettedStride;
    AddSigned(first, int(round(area * kReactionScale)));
    for (uint axis = 0; axis < 3; axis++)
    {
        AddSigned(first + 2 + 2 * axis, facing[axis]);
        AddSigned(first + 8 + 2 * axis, at[axis]);
    }
}

// Each side of a box by itself, so that edges and corners, which have no area, get none.
void WetBox(uint owner, Collider collider, float3 p)
{
    float inward = (collider.flags & kInsideOut) != 0 ? -1.0 : 1.0;
    float3 above = saturate(collider.size - abs(p) + 0.5);      // fraction of its cube above a face, along that
    [loop]
    for (uint axis = 0; axis < 3; axis++)
    {
        float3 along = float3(axis == 0, axis == 1, axis == 2);
        float distance = inward * dot(abs(p) - collider.size, along);
        float3 across = along > 0.0 ? 1.0 : above;
        float area = across.x * across.y * across.z * LayerFraction(distance);
        AddWettedArea(owner, collider, p, dot(p, along) < 0.0 ? -inward * along : inward * along, distance, distance > -0.5 ? area : 0.0);
    }
}

// Adds the area of one collider that a particle wets.
void Wet(uint owner, float3 position)
{
    Collider collider = _Colliders[owner];
    float3 p = ToCollider(collider, position);
    float4 contact = LocalDistance(collider, p);
    if ((collider.flags & kTellsWettedArea) == 0 || contact.w >= kSupport)
        return;
    if (collider.shape == kBox)
    {
        WetBox(owner, collider, p);
        return;
    }
    float radius = (collider.flags & kInsideOut) != 0 ? -collider.size.x : collider.size.x;
    float area = LayerFraction(contact.w);
    if (collider.shape == kSphere)
        area *= BelowCurved(radius, contact.w, 2.0);
    else if (collider.shape == kCapsule)
        area *= BelowCurved(radius, contact.w, abs(p.y) > collider.size.y ? 2.0 : 1.0);
    else if (collider.shape != kPlane)
        area *= BelowField(collider, p, contact.w);
    AddWettedArea(owner, collider, p, contact.xyz, contact.w, area);
}

#endif
