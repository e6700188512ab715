// Sums over the particles of a coarse cell, exact and independent of their order: integers, 64 bits each.
// Include after RWStructuredBuffer<uint> _Bins is declared: particles of a cell, then sums of three components.
#ifndef RILL_COARSE_BINS_INCLUDED
#define RILL_COARSE_BINS_INCLUDED

#include "../../Generated/CoarseBins.hlsl"
#include "../../Gpu/GroupRuns.hlsl"

static const uint kNoCell = kNoRun;
static const float kMinError = -0.1;         // more dilute particles are spray
static const float kMaxError = 8.0;
static const float kErrorScale = 65536.0;       // steps of a binned density error

groupshared uint3 g_Values[kGroup];

// A sum of 64 bits in two words. The values are not negative.
void AddWide(uint at, uint value)
{
    uint before;
    InterlockedAdd(_Bins[at], value, before);
    if (before + value < before)
        InterlockedAdd(_Bins[at + 1], 1);
}

float WideSum(uint at)
{
    return _Bins[at + 1] * 4294967296.0 + _Bins[at];
}

// All threads of a group come here; kNoCell adds nothing.
void AddRuns(uint thread, uint cell, uint3 value, uint components)
{
    g_Values[thread] = value;
    if (!StartsRun(thread, cell))
        return;

    uint3 sum = value;
    uint count = 1;
    FOR_REST_OF_RUN(thread, cell, next)
        sum += g_Values[next];
        count++;
    END_RUN
    uint bin = cell * kBinStride;
    InterlockedAdd(_Bins[bin], count);
    AddWide(bin + 1, sum.x);
    if (components > 1)
    {
        AddWide(bin + 3, sum.y);
        AddWide(bin + 5, sum.z);
    }
}

uint BinnedError(float error)
{
    return uint((clamp(error, kMinError, kMaxError) - kMinError) * kErrorScale + 0.5);
}

#endif
