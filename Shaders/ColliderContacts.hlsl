// What the colliders near a particle do to it: density, contact, the way that a path can go. Include after Colliders.hlsl.
#ifndef RILL_COLLIDER_CONTACTS_INCLUDED
#define RILL_COLLIDER_CONTACTS_INCLUDED

StructuredBuffer<uint> _ColliderMasks;      // [cells * words], see ColliderCell

static const float kTouching = 0.05;        // d: what is no further from where it must stay than this touches
static const uint kSettleSteps = 8;
static const float kFar = 1.0;              // an inset that no particle has to keep
static const float kUnhinderedWay = 2.0;    // d: a way no longer than this, from where no collider is near, meets none; = what bins reach, less kWallInset

// Whether a collider comes near the cell of p within the substep. Most water is far from all of them and is done with this.
bool IsNear(float3 p)
{
    uint cell = ColliderCell(p);
    uint bits = 0;
    for (uint word = 0; word < _ColliderWords; word++)
        bits |= _ColliderMasks[cell + word];
    return bits != 0;
}

// ---- density

// The surfaces that add density at a place: where several lie in one plane they are one. A share of 0 is no surface.
struct Surfaces
{
    float3 normals[3];
    float shares[3];
    uint count;
};

// Share of the density behind a plane at distance s, negative beyond it, and its derivative.
void Beyond(float s, out float share, out float slope)
{
    HalfSpace(abs(s), share, slope);
    share = s < 0.0 ? _WallScale - share : share;
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

// The density that a collider adds at p, where it is 'contact.w' away along 'contact.xyz', and its gradient.
void ColliderDensity(Collider collider, float3 p, float4 contact, out float density, out float3 gradient)
{
    if (collider.shape == kBox)
    {
        BoxDensity(ToCollider(collider, p), collider.size, (collider.flags & kInsideOut) != 0, density, gradient);
        gradient = Rotate(collider.rotation, gradient);
    }
    else
    {
        float slope;
        HalfSpace(contact.w, density, slope);
        gradient = contact.xyz * slope;
    }
    // Of what is inside, as much as at the surface.
    float surface, surfaceSlope;
    HalfSpace(0.0, surface, surfaceSlope);
    density = min(density, surface);
}

// What is left of a share of density beside surfaces that point the same way.
float Unshared(Surfaces surfaces, float3 normal, float share)
{
    float left = share;
    [unroll]
    for (uint i = 0; i < 3; i++)
    {
        float alike = smoothstep(0.5, 0.9, dot(surfaces.normals[i], normal));
        left = lerp(left, max(left - surfaces.shares[i], 0.0) / (1.0 - surfaces.shares[i]), alike);
    }
    return left;
}

void AddSurface(inout Surfaces surfaces, float3 normal, float share)
{
    [unroll]
    for (uint i = 0; i < 3; i++)
    {
        bool own = i == surfaces.count && share > 0.0;
        surfaces.normals[i] = own ? normal : surfaces.normals[i];
        surfaces.shares[i] = own ? share : surfaces.shares[i];
    }
    surfaces.count += share > 0.0 ? 1 : 0;
}

// The domain's walls near p, which add their density elsewhere.
Surfaces WallSurfaces(float3 p)
{
    Surfaces surfaces = (Surfaces)0;
    float3 above = _DomainSize - p;
    [unroll]
    for (uint axis = 0; axis < 3; axis++)
    {
        float3 normal = 0.0;
        normal[axis] = p[axis] < above[axis] ? 1.0 : -1.0;
        float share, slope;
        HalfSpace(min(p[axis], above[axis]), share, slope);
        AddSurface(surfaces, normal, share);
    }
    return surfaces;
}

// The collider nearest to a place, and what those around it add to the density there.
struct Surroundings
{
    float4 boundary;        // xyz gradient of the density added, 1/d; w the density, relative to rest
    float4 contact;         // of the nearest: xyz normal, w distance, d; at most kSupport
    uint nearest;           // kNoCollider: none within kSupport
};

Surroundings FindSurroundings(float3 p)
{
    Surroundings result;
    result.boundary = 0.0;
    result.contact = float4(0.0, 1.0, 0.0, kSupport);
    result.nearest = kNoCollider;
    Surfaces surfaces = WallSurfaces(p);
    float free = 1.0;
    uint cell = ColliderCell(p);
    for (uint word = 0; word < _ColliderWords; word++)
    {
        for (uint bits = _ColliderMasks[cell + word]; bits != 0; bits &= bits - 1)
        {
            uint index = word * 32 + firstbitlow(bits);
            Collider collider = _Colliders[index];
            float4 contact = DomainDistance(collider, p);
            if (contact.w >= kSupport)
                continue;
            if (contact.w < result.contact.w)
            {
                result.contact = contact;
                result.nearest = index;
            }
            if ((collider.flags & kCarriesDensity) == 0)
                continue;
            float full;
            float3 gradient;
            ColliderDensity(collider, p, contact, full, gradient);
            float share = Unshared(surfaces, contact.xyz, full);
            AddSurface(surfaces, contact.xyz, share);
            gradient *= full > 0.0 ? share / full : 0.0;
            result.boundary.xyz = result.boundary.xyz * (1.0 - share) + gradient * free;
            free *= 1.0 - share;
        }
    }
    result.boundary.w = 1.0 - free;
    return result;
}

// ---- staying outside

// The deepest of the colliders that p is nearer to than 'inset'.
uint Deepest(float3 p, float inset, out float4 contact)
{
    contact = float4(0.0, 1.0, 0.0, inset);
    uint deepest = kNoCollider;
    uint cell = ColliderCell(p);
    for (uint word = 0; word < _ColliderWords; word++)
    {
        for (uint bits = _ColliderMasks[cell + word]; bits != 0; bits &= bits - 1)
        {
            uint index = word * 32 + firstbitlow(bits);
            float4 own = DomainDistance(_Colliders[index], p);
            if (own.w < contact.w)
            {
                contact = own;
                deepest = index;
            }
        }
    }
    return deepest;
}

static const float kLongestSettle = 1.0;    // d, of one move

// From a place that a collider is too near to, along its normal; between it and a wall of the domain along the wall.
float3 WayOut(float3 p, float4 contact, float inset)
{
    float3 normal = contact.xyz;
    normal = p <= kWallInset && normal < 0.0 || p >= _DomainSize - kWallInset && normal > 0.0 ? 0.0 : normal;
    float steepness = max(dot(normal, normal), 1e-4);
    return normal * min((inset - contact.w) / steepness, kLongestSettle * rsqrt(steepness));
}

// Moves p out of what is nearer than 'inset'; 'by' is the collider that moved it last.
float3 Settle(float3 p, float inset, inout uint by)
{
    for (uint i = 0; i < kSettleSteps; i++)
    {
        float4 contact;
        uint deepest = Deepest(p, inset - 1e-4, contact);
        if (deepest == kNoCollider)
            break;
        by = deepest;
        p = ClampToDomain(p + WayOut(p, contact, inset));
    }
    return p;
}

// ---- paths

static const float kShortestStep = 0.25;    // d, along a path
static const uint kMostSteps = 1024;        // a longer path ends there, as if it were stopped

// Whether the way from a to b, in the collider's own frame, comes nearer than kWallInset, and after which share of it. One that
// starts nearer than that may go on as long as it gets no nearer.
bool Trace(Collider collider, float3 a, float3 b, out float share)
{
    share = 0.0;
    float way = length(b - a);
    float distance = LeastDistance(collider, a);
    float least = min(kWallInset, SurfaceDistance(collider, a, distance) - kTouching);
    if (distance >= kWallInset + way)
        return false;
    for (uint i = 0; i < kMostSteps; i++)
    {
        share = min(share + max(distance - kWallInset, kShortestStep) / max(way, 1e-6), 1.0);
        float3 place = lerp(a, b, share);
        distance = LeastDistance(collider, place);
        if (distance < least && SurfaceDistance(collider, place, distance) < least)
            return true;
        if (share >= 1.0)
            return false;
    }
    return true;
}

// The first collider that stops the way from a to b, or kNoCollider. While 'moving', the way is that of the substep, under
// which the colliders move; else they are where they end.
uint FirstHit(float3 a, float3 b, bool moving, out float share)
{
    share = 1.0;
    uint first = kNoCollider;
    float3 way = b - a;
    uint places = uint(length(way) * _InverseColliderCellSize) + 2;
    for (uint word = 0; word < _ColliderWords; word++)
    {
        uint bits = 0;
        for (uint place = 0; place < places; place++)
            bits |= _ColliderMasks[ColliderCell(a + way * (place / (places - 1.0))) + word];
        for (; bits != 0; bits &= bits - 1)
        {
            uint index = word * 32 + firstbitlow(bits);
            Collider collider = _Colliders[index];
            float3 start = moving ? ToLastCollider(collider, a) : ToCollider(collider, a);
            float hit;
            if (Trace(collider, start, ToCollider(collider, b), hit) && (hit < share || first == kNoCollider))
            {
                share = hit;
                first = index;
            }
        }
    }
    return first;
}

#endif
