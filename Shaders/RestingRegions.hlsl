// Which regions of the box sleep: cubes of 8 spacings whose water has come to rest. Include after Solver.hlsl.
#ifndef RILL_RESTING_REGIONS_INCLUDED
#define RILL_RESTING_REGIONS_INCLUDED

static const float kRegionSize = 8.0;       // d, = RestingRegions.RegionSize in RestingRegions.cs

// States of a region. Particles asleep are not moved. Those at the edge still have lists and multipliers, which their
// neighbors that move push against; the others are further from all that moves than any kernel reaches.
static const uint kAsleep = 0;
static const uint kAsleepAtEdge = 1;
static const uint kAwake = 2;

uint3 RegionCounts()
{
    return max(uint3(ceil(_DomainSize / kRegionSize)), 1);
}

uint RegionOf(float3 p)
{
    uint3 counts = RegionCounts();
    uint3 region = min(uint3(max(p / kRegionSize, 0.0)), counts - 1);
    return (region.z * counts.y + region.y) * counts.x + region.x;
}

static const uint kMotionStride = 5;        // words of a region's motion, = RestingRegions.MotionStride
static const uint kMaxDisplacement = 4;          // of them: longest way of a particle, float bits

#ifdef RILL_SLEEP
StructuredBuffer<uint> _RegionStates;       // [regions]
RWStructuredBuffer<uint> _RegionMotion;     // [regions * kMotionStride], see RestingRegions.compute; for stages that add or remove particles

uint RegionState(float3 start)
{
    return _RegionStates[RegionOf(start)];
}
#endif

// Whether a particle that started the substep here stays where it is.
bool Sleeps(float3 start)
{
#ifdef RILL_SLEEP
    return RegionState(start) != kAwake;
#else
    return false;
#endif
}

// Whether it needs no multiplier either.
bool SleepsDeeply(float3 start)
{
#ifdef RILL_SLEEP
    return RegionState(start) == kAsleep;
#else
    return false;
#endif
}

// A particle that came or went here is motion of the region, which the next substep sees.
void WakeRegion(float3 p)
{
#ifdef RILL_SLEEP
    InterlockedMax(_RegionMotion[RegionOf(p) * kMotionStride + kMaxDisplacement], asuint(1e6));
#endif
}

#endif
