// Takes a particle out at the start of a step. Include after Solver.hlsl and RestingRegions.hlsl; _Positions and _Counters are writable.
#ifndef RILL_REMOVE_PARTICLE_INCLUDED
#define RILL_REMOVE_PARTICLE_INCLUDED

#include "RemovedMark.hlsl"

// Its position is NaN from here on. The sort counts every such as not finite, which is taken back in advance.
void Remove(uint i, float3 p)
{
    _Positions[i] = asfloat(kRemovedBits);
    InterlockedAdd(_Counters[kDrained], 1);
    InterlockedAdd(_Counters[kNonFinite], 0xFFFFFFFFu);
    WakeRegion(p);
}

#endif
