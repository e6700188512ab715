// Which regions of the box sleep: cubes of 8 spacings whose water has come to rest. Include after Solver.hlsl.
#ifndef RILL_RESTING_REGIONS_INCLUDED
#define RILL_RESTING_REGIONS_INCLUDED

#include "../../Generated/RestingRegions.hlsl"

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

static const uint kMaxDisplacement = 4;          // of the words of its motion: longest displacement of a particle, float bits

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
