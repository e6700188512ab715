// Pieces of the water's surface near particles, and their mean among neighbors. Include SurfaceParticle.hlsl first.
#ifndef RILL_SURFACE_PLANE_INCLUDED
#define RILL_SURFACE_PLANE_INCLUDED

struct Plane
{
    float3 normal;      // unit, out of the water
    float depth;        // of the particle below it, along the normal, d
    float trust;        // 0 to 1; 0: nothing is known of the surface here
};

static const uint2 kNoPlane = 0;
static const float kPlaneFraction = 0.95;      // see AddPlane
static const float kMinCosine = 0.3;      // of normals that belong to one surface; above by as much counts in full

// x: see PackNormal; y: half2 depth, trust.
uint2 PackPlane(Plane plane)
{
    return uint2(PackNormal(plane.normal), PackHalves(plane.depth, plane.trust));
}

bool IsKnown(uint2 packed)
{
    return packed.y >> 16 != 0;
}

Plane UnpackPlane(uint2 packed)
{
    Plane plane;
    plane.normal = UnpackNormal(packed.x);
    float2 depthTrust = UnpackHalves(packed.y);
    plane.depth = depthTrust.x;
    plane.trust = depthTrust.y;
    return plane;
}

// Sums over the planes of neighbors that face as the particle's own does.
struct PlaneSums
{
    float3 normal;
    float depth;
    float weight;
    float bend;         // sum of the curvature's fraction of each pair
    float bendWeight;
};

// The height of a neighbor's piece over the particle is a mean of two: that of its point, and that of its plane. On a sphere the
// one is too low by what the other is too high; somewhat more of the point is smoother.
//   side: 1, or -1 along an axis that mirrors the neighbor
void AddPlane(inout PlaneSums sums, Plane own, float3 difference, float3 side, float weight, uint2 packed)
{
    if (!IsKnown(packed) || weight <= 0.0)
        return;
    Plane plane = UnpackPlane(packed);
    plane.normal *= side;
    float cosine = dot(plane.normal, own.normal);
    weight *= plane.trust * saturate((cosine - kMinCosine) / kMinCosine);
    if (weight <= 0.0)
        return;
    float3 between = kPlaneFraction * plane.normal + own.normal;
    float3 piece = difference + plane.normal * plane.depth;
    sums.normal += weight * plane.normal;
    sums.depth += weight * dot(between, piece) / (1.0 + kPlaneFraction * cosine);
    sums.weight += weight;
    float3 along = piece - own.normal * own.depth;
    sums.bend += weight * dot(plane.normal - own.normal, along);
    sums.bendWeight += weight * dot(along, along);
}

// Adds the particle's own plane to those of its neighbors.
void AddOwnPlane(inout PlaneSums sums, Plane own)
{
    sums.normal += own.normal * own.trust;
    sums.depth += own.depth * own.trust;
    sums.weight += own.trust;
}

// The mean plane; of an unknown one nothing.
Plane MeanPlane(PlaneSums sums, Plane own)
{
    if (sums.weight <= 1e-4)
        return own;
    Plane plane = own;
    plane.normal = normalize(sums.normal + own.normal * 1e-6);
    plane.depth = sums.depth / sums.weight;
    return plane;
}

#endif
