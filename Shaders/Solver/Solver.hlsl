// Common parts of all kernels of the solver: constants of a step, counters, the particle-to-thread map, kernels, walls.
//
// Lengths are in units of the particle spacing d, times in seconds, densities relative to rest: the numbers that a
// kernel sees do not depend on the scale of the scene. Positions are in the domain's frame, its lowest corner at 0.
#ifndef RILL_SOLVER_INCLUDED
#define RILL_SOLVER_INCLUDED

#include "../Generated/Counters.hlsl"
#include "../Generated/Solver.hlsl"
#include "../Gpu/GroupIndex.hlsl"
#include "../Gpu/Hash.hlsl"

static const float kSupportSquared = kSupport * kSupport;
static const float kCoincident = 1e-8;      // squared distance below which a pair has no direction of its own

static const uint kNewParticle = 0xFFFFFFFFu;  // instead of where a sorted particle was before the sort: it is new since the last step

uint ParticleIndex(uint3 group, uint thread)
{
    return GroupIndex(group) * kGroup + thread;
}

// Thread groups for 'count' particles, folded into two dimensions. At least one, so that the kernel which updates the
// counters runs when no particle is left.
uint3 GroupsFor(uint count)
{
    uint groups = max((count + kGroup - 1) / kGroup, 1);
    return uint3(min(groups, kMaxGroups), (groups + kMaxGroups - 1) / kMaxGroups, 1);
}

// By bits: a compiler may assume that floats are finite.
bool IsFinite(float3 v)
{
    uint3 exponent = asuint(v) & 0x7f800000u;
    return exponent.x != 0x7f800000u && exponent.y != 0x7f800000u && exponent.z != 0x7f800000u;
}

static const float kMaxRestDensity = 2.0;   // by what colliders leave: with less room than that, particles lie in them by mistake
static const float kMaxSlack = 0.007;       // above the mean density, of rest

// Particles in the box, over those that it holds at rest.
float MeanDensity(uint particles)
{
    return particles / (_DomainSize.x * _DomainSize.y * _DomainSize.z);
}

// Density that the constraint seeks, relative to rest: above 1 where a closed box holds more than it can, which no iteration
// could press out of it and all would fight over. Above the mean by a slack: the constraint presses and does not pull, so that
// exactly the mean would keep half of the particles pushing. 'open' is the fraction of the box that colliders leave.
float RestDensity(uint particles, float open)
{
    float mean = MeanDensity(particles);
    float rest = max(min(mean / max(open, 1e-6), max(mean, kMaxRestDensity)), 1.0);
    return rest + min(0.5 * (rest - 1.0), kMaxSlack);
}

float3 ClampToDomain(float3 p)
{
    return clamp(p, kContactOffset, _DomainSize - kContactOffset);
}

// Returns where a particle's flow alone takes it in a substep. The projection is found and looked up there: water that is about to meet
// other water, or a wall, lies in its cells already.
float3 AlongFlow(float3 p, float3 velocity)
{
    return ClampToDomain(p + velocity * _TimeStep + _GravityStep);
}

uint CellIndex(float3 p)
{
    uint3 cell = min(uint3(max(p * _InverseCellSize, 0.0)), _CellCounts - 1);
    return (cell.z * _CellCounts.y + cell.y) * _CellCounts.x + cell.x;
}

// poly6 (Mueller et al. 2003, eq. 20) without its normalization; 0 beyond the support.
float Poly6(float distanceSquared)
{
    float t = max(kSupportSquared - distanceSquared, 0.0);
    return t * t * t;
}

// A coincident pair has no direction: this gives it one of its own, the opposite for the other particle.
float3 CoincidentDirection(uint self, uint other)
{
    uint hash = Hash(min(self, other), max(self, other));
    float z = (hash & 0xFFFFu) * (2.0 / 65535.0) - 1.0;
    float angle = (hash >> 16) * (6.2831853 / 65536.0);
    float ring = sqrt(max(1.0 - z * z, 0.0));
    float3 direction = float3(ring * cos(angle), ring * sin(angle), z);
    return self < other ? direction : -direction;
}

// Fraction of the rest density that a half space of fluid behind a plane at distance s adds, and its derivative along the
// normal (negative: density falls as the particle leaves the wall).
//   density     poly6 integrated over the half space:  1/2 - 315/256 (x - 4/3 x^3 + 6/5 x^5 - 4/7 x^7 + x^9/9), x = s/h
//   derivative  the spiky gradient integrated likewise:  -30/h^6 (h t^4/4 - t^5/5), t = h - s
void HalfSpace(float s, out float density, out float derivative)
{
    s = clamp(s, 0.0, kSupport);
    float x = s / kSupport;
    float y = x * x;
    density = _WallScale * (0.5 - (315.0 / 256.0) * x * (1.0 + y * (-4.0 / 3.0 + y * (6.0 / 5.0 + y * (-4.0 / 7.0 + y / 9.0)))));
    float t = kSupport - s;
    float t4 = t * t * t * t;
    derivative = -_WallScale * (30.0 / 64.0) * t4 * (kSupport / 4.0 - t / 5.0);
}

// The domain's six walls as fluid at rest behind them: density added (relative) and its gradient at p.
// Planes combine as 1 - product of (1 - F).
void WallDensity(float3 p, out float density, out float3 gradient)
{
    density = 0.0;
    gradient = 0.0;
    float3 above = _DomainSize - p;
    if (all(p >= kSupport) && all(above >= kSupport))
        return;

    float3 low, lowSlope, high, highSlope;
    HalfSpace(p.x, low.x, lowSlope.x);
    HalfSpace(p.y, low.y, lowSlope.y);
    HalfSpace(p.z, low.z, lowSlope.z);
    HalfSpace(above.x, high.x, highSlope.x);
    HalfSpace(above.y, high.y, highSlope.y);
    HalfSpace(above.z, high.z, highSlope.z);
    float3 free = (1.0 - low) * (1.0 - high);
    density = 1.0 - free.x * free.y * free.z;
    gradient = float3(free.y * free.z, free.x * free.z, free.x * free.y) * (lowSlope * (1.0 - high) - highSlope * (1.0 - low));
}

// Instead of what a particle keeps from colliders, d:
static const float kFar = 1.0;              // none comes near it in the substep
static const float kNeedsSweep = 2.0;          // one may: CollidePaths finds out

// Adds what colliders contribute: xyz its gradient, w the density.
void AddBoundary(float4 boundary, inout float density, inout float3 gradient)
{
    gradient = gradient * (1.0 - boundary.w) + boundary.xyz * (1.0 - density);
    density = 1.0 - (1.0 - density) * (1.0 - boundary.w);
}

#endif
