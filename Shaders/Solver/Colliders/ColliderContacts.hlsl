// Effect of nearby colliders on a particle: density, contact, the path that a particle can take. Include after Colliders.hlsl.
#ifndef RILL_COLLIDER_CONTACTS_INCLUDED
#define RILL_COLLIDER_CONTACTS_INCLUDED

#include "ColliderBins.hlsl"

static const float kTouching = 0.05;        // d: a particle touches within this distance of where it must stay
// d: as near to where it must stay as a mesh's distances tell; more would be asked of them for ever
static const float kContactTolerance = 0.005;
static const uint kDepenetrationSteps = 8;

// ---- density

// The densest half spaces behind the surfaces near a point, one for each direction.
struct Surfaces
{
    float3 normals[3];
    float4 behind[3];       // xyz gradient of its density, 1/d; w the density; 0: none
};

// Fraction of the density behind a plane at distance s, negative beyond it, and its derivative.
void Beyond(float s, out float fraction, out float slope)
{
    HalfSpace(abs(s), fraction, slope);
    fraction = s < 0.0 ? _WallScale - fraction : fraction;
}

// The density that a box adds at p in its own frame, as if the kernel were a product along its axes: exact by its faces, and
// much less at edges and corners than the half space behind them would be.
void BoxDensity(float3 p, float3 halfSides, bool insideOut, out float density, out float3 gradient)
{
    float3 inside, slope;
    [unroll]
    for (uint axis = 0; axis < 3; axis++)
    {
        float low, lowSlope, high, highSlope;
        Beyond(halfSides[axis] - p[axis], high, highSlope);
        Beyond(halfSides[axis] + p[axis], low, lowSlope);
        inside[axis] = saturate(1.0 - (low + high) / _WallScale);
        slope[axis] = (highSlope - lowSlope) / _WallScale;
    }
    density = _WallScale * inside.x * inside.y * inside.z;
    gradient = _WallScale * slope * float3(inside.y * inside.z, inside.x * inside.z, inside.x * inside.y);
    if (insideOut)
    {
        density = _WallScale - density;
        gradient = -gradient;
    }
}

// Density that a collider adds at p, where it is 'contact.w' away along 'contact.xyz', and what lies beyond its surface
// if that is a plane: xyz gradient, w density.
void ColliderDensity(Collider collider, float3 p, float4 contact, out float4 own, out float4 behind)
{
    float slope;
    HalfSpace(contact.w, behind.w, slope);
    behind.xyz = contact.xyz * slope;
    own = behind;
    if (collider.shape != kBox)
        return;
    bool insideOut = (collider.flags & kInsideOut) != 0;
    float3 gradient;
    BoxDensity(ToCollider(collider, p), collider.size, insideOut, own.w, gradient);
    own.xyz = Rotate(collider.rotation, gradient);
    // Inside, as much as at the surface.
    float surface, surfaceSlope;
    HalfSpace(0.0, surface, surfaceSlope);
    own.w = min(own.w, surface);
    if (own.w > behind.w)       // in the corners of a container
        behind = own;
}

void AddSurface(inout Surfaces surfaces, float3 normal, float4 behind)
{
    float thinnest = min(surfaces.behind[0].w, min(surfaces.behind[1].w, surfaces.behind[2].w));
    uint slot = surfaces.behind[0].w == thinnest ? 0 : surfaces.behind[1].w == thinnest ? 1 : 2;
    [unroll]
    for (uint i = 0; i < 3; i++)
        slot = dot(surfaces.normals[i], normal) >= kSameSurfaceCosine ? i : slot;
    [unroll]
    for (uint k = 0; k < 3; k++)
    {
        bool denser = k == slot && behind.w > surfaces.behind[k].w;
        surfaces.normals[k] = denser ? normal : surfaces.normals[k];
        surfaces.behind[k] = denser ? behind : surfaces.behind[k];
    }
}

void DenserFirst(inout Surfaces surfaces, uint first, uint second)
{
    if (surfaces.behind[first].w >= surfaces.behind[second].w)
        return;
    float3 normal = surfaces.normals[first];
    surfaces.normals[first] = surfaces.normals[second];
    surfaces.normals[second] = normal;
    float4 behind = surfaces.behind[first];
    surfaces.behind[first] = surfaces.behind[second];
    surfaces.behind[second] = behind;
}

// The density that lies behind any of them, w, and its gradient: planes combine as 1 - product of (1 - F), but what points in the
// same direction as a denser one lies behind that already.
float4 BehindAny(Surfaces surfaces)
{
    DenserFirst(surfaces, 0, 1);
    DenserFirst(surfaces, 1, 2);
    DenserFirst(surfaces, 0, 1);
    float4 all = 0.0;
    [unroll]
    for (uint i = 0; i < 3; i++)
    {
        float counts = 1.0;
        [unroll]
        for (uint denser = 0; denser < i; denser++)
            counts *= 1.0 - smoothstep(kOtherSurfaceCosine, kSameSurfaceCosine, dot(surfaces.normals[denser], surfaces.normals[i]));
        float4 behind = surfaces.behind[i] * counts;
        all.xyz = all.xyz * (1.0 - behind.w) + behind.xyz * (1.0 - all.w);
        all.w += behind.w * (1.0 - all.w);
    }
    return all;
}

// The domain's walls near p, which add their density elsewhere: without their gradients. What they leave free.
Surfaces WallSurfaces(float3 p, out float free)
{
    Surfaces surfaces = (Surfaces)0;
    free = 1.0;
    float3 above = _DomainSize - p;
    [unroll]
    for (uint axis = 0; axis < 3; axis++)
    {
        surfaces.normals[axis][axis] = p[axis] < above[axis] ? 1.0 : -1.0;
        float slope;
        HalfSpace(min(p[axis], above[axis]), surfaces.behind[axis].w, slope);
        free *= 1.0 - surfaces.behind[axis].w;
    }
    return surfaces;
}

// The collider nearest to a point, and what those around it add to the density there.
struct Surroundings
{
    float4 boundary;        // xyz gradient of the density added, 1/d; w the density, relative to rest
    float4 contact;         // of the nearest: xyz normal, w distance, d; at most _ColliderReach
    uint nearest;           // kNoCollider: none within _ColliderReach
};

Surroundings FindSurroundings(float3 p)
{
    Surroundings result;
    result.contact = float4(0.0, 1.0, 0.0, _ColliderReach);
    result.nearest = kNoCollider;
    float free = 1.0;
    Surfaces surfaces = (Surfaces)0;
    float4 apart = 0.0;         // gradient and density of the bodies, each for itself
    bool touches = false;
    uint cell = ColliderCell(p);
    FOR_COLLIDERS(cell, index)
        Collider collider = _Colliders[index];
        float4 contact = DomainDistance(collider, p);
        if (contact.w < result.contact.w)
        {
            result.contact = contact;
            result.nearest = index;
        }
        if (contact.w < kSupport && (collider.flags & kContributesDensity) != 0)
        {
            if (!touches)
                surfaces = WallSurfaces(p, free);
            touches = true;
            float4 own, behind;
            ColliderDensity(collider, p, contact, own, behind);
            AddSurface(surfaces, contact.xyz, behind);
            apart += own;
        }
    END_COLLIDERS
    result.boundary = 0.0;
    if (touches)
    {
        // Bodies side by side add up. Where they add up to more than lies behind their surfaces, they overlap.
        float4 all = BehindAny(surfaces);
        all.w = max(all.w + free - 1.0, 0.0);
        result.boundary = (apart.w < all.w ? apart : all) / free;
    }
    return result;
}

// ---- staying outside

// The deepest of the colliders that p is nearer to than 'contactOffset'.
uint Deepest(float3 p, float contactOffset, out float4 contact)
{
    contact = float4(0.0, 1.0, 0.0, contactOffset);
    uint deepest = kNoCollider;
    uint cell = ColliderCell(p);
    FOR_COLLIDERS(cell, index)
        float4 own = DomainDistance(_Colliders[index], p);
        if (own.w < contact.w)
        {
            contact = own;
            deepest = index;
        }
    END_COLLIDERS
    return deepest;
}

static const float kMaxPushOut = 1.0;    // d, of one move

// From a place that a collider is too near to, along its normal; between it and a wall of the domain along the wall.
float3 PushOut(float3 p, float4 contact, float contactOffset)
{
    float3 normal = contact.xyz;
    normal = p <= kContactOffset && normal < 0.0 || p >= _DomainSize - kContactOffset && normal > 0.0 ? 0.0 : normal;
    float steepness = max(dot(normal, normal), 1e-4);
    return normal * min((contactOffset - contact.w) / steepness, kMaxPushOut * rsqrt(steepness));
}

// Moves p out of what is nearer than 'contactOffset', to where what is around it is found; 'by' is the collider that moved it last.
Surroundings Depenetrate(inout float3 p, float contactOffset, inout uint by)
{
    Surroundings around;
    bool moves = true;      // and no break: lavapipe of Mesa 22.3 then gives what a lane found a part of what others find after it
    for (uint i = 0; moves; i++)
    {
        around = FindSurroundings(p);
        moves = around.contact.w < contactOffset - kContactTolerance && i < kDepenetrationSteps;
        if (moves)
        {
            by = around.nearest;
            p = ClampToDomain(p + PushOut(p, around.contact, contactOffset));
        }
    }
    return around;
}

// ---- paths

static const float kShortestStep = 0.25;    // d, along a path
static const uint kMaxSteps = 1024;        // a longer path ends there, as if it were stopped

// Whether the path from a to b, in the collider's own frame, comes nearer than kContactOffset, and after which fraction of it. One that
// starts nearer than that, 'start' away, may go on as long as it gets no nearer. A surface that deforms comes towards it meanwhile: by no
// more than it does at a, and twice the path, since no distance changes faster than by the path along it.
bool Trace(Collider collider, float3 a, float3 b, out float fraction, out float start)
{
    fraction = 0.0;
    float path = length(b - a);
    float distance = MinDistanceAt(collider, a, collider.lastBlend);
    start = SurfaceDistance(collider, a, distance);
    float least = min(kContactOffset, start - kTouching);
    if (Deforms(collider))
        path = 3.0 * path + abs(Advance(collider, a));
    if (distance >= kContactOffset + path)
        return false;
    for (uint i = 0; i < kMaxSteps; i++)
    {
        fraction = min(fraction + max(distance - kContactOffset, kShortestStep) / max(path, 1e-6), 1.0);
        float3 position = lerp(a, b, fraction);
        distance = MinDistanceAt(collider, position, lerp(collider.lastBlend, collider.blend, fraction));
        if (distance < least && SurfaceDistance(collider, position, distance) < least)
            return true;
        if (fraction >= 1.0)
            return false;
    }
    return true;
}

// The first collider that stops the path from a to b, or kNoCollider, and the distance of the nearest at its start. While 'moving',
// the path is that of the substep, under which the colliders move; else they are where they end.
uint FirstHit(float3 a, float3 b, bool moving, out float fraction, out float nearest)
{
    fraction = 1.0;
    nearest = kSupport;
    uint first = kNoCollider;
    float3 path = b - a;
    uint samples = uint(length(path) * _InverseColliderCellSize) + 2;
    FOR_COLLIDERS_ALONG(a, path, samples, index)
        Collider collider = _Colliders[index];
        float3 start = moving ? ToLastCollider(collider, a) : ToCollider(collider, a);
        collider.lastBlend = moving ? collider.lastBlend : collider.blend;
        float hit, distance;
        bool stops = Trace(collider, start, ToCollider(collider, b), hit, distance);
        nearest = min(nearest, distance);
        if (stops && (hit < fraction || first == kNoCollider))
        {
            fraction = hit;
            first = index;
        }
    END_COLLIDERS
    return first;
}

#endif
