// The water around a point, summed by a group of threads: density, velocity and phases. Include after the buffers of Queries.compute.
#ifndef RILL_WATER_AROUND_INCLUDED
#define RILL_WATER_AROUND_INCLUDED

static const float kReachMargin = 1.0;          // d
static const uint kRowLanes = 8;                // threads of a row of cells around a point
static const float kPhaseScale = 1024.0;        // steps of a weight
static const float kHalfDensity = 0.5;          // where the surface is, of rest
static const float kMinOpen = 0.1;              // of the kernel's ball, within the walls: in a corner it is an eighth

static const uint kMaxSums = 4;
static const uint kParts = 8;
static const uint kPart = kProbeGroup / kParts;     // values of a part
groupshared float g_Values[kMaxSums * kParts * (kPart + 1)];        // a word after each part, so that threads read from different banks
groupshared float g_Parts[kMaxSums * kParts];
groupshared float g_Sums[kMaxSums];
groupshared uint g_Phases[kPhases];

uint PhaseOf(uint i)
{
#ifdef RILL_TAGS
    return min(_Tags[i] >> kTagPhaseShift, kPhases - 1);
#else
    return 0;
#endif
}

void SetValue(uint thread, uint quantity, float value)
{
    g_Values[quantity * kParts * (kPart + 1) + thread + thread / kPart] = value;
}

void SetValues(uint thread, uint quantity, float3 value)
{
    SetValue(thread, quantity, value.x);
    SetValue(thread, quantity + 1, value.y);
    SetValue(thread, quantity + 2, value.z);
}

// Sums over the threads, in an order that is always the same. All threads come here.
void SumValues(uint thread, uint count)
{
    GroupMemoryBarrierWithGroupSync();
    for (uint part = thread; part < count * kParts; part += kProbeGroup)
    {
        float sum = 0.0;
        for (uint k = 0; k < kPart; k++)
            sum += g_Values[part * (kPart + 1) + k];
        g_Parts[part] = sum;
    }
    GroupMemoryBarrierWithGroupSync();
    if (thread < count)
    {
        float sum = 0.0;
        for (uint k = 0; k < kParts; k++)
            sum += g_Parts[thread * kParts + k];
        g_Sums[thread] = sum;
    }
    GroupMemoryBarrierWithGroupSync();
}

// Sum of the threads' values. All threads come here.
float3 SumThreads(uint thread, float3 value)
{
    SetValues(thread, 0, value);
    SumValues(thread, 3);
    return float3(g_Sums[0], g_Sums[1], g_Sums[2]);
}

float4 SumThreads(uint thread, float4 value)
{
    SetValues(thread, 0, value.xyz);
    SetValue(thread, 3, value.w);
    SumValues(thread, 4);
    return float4(g_Sums[0], g_Sums[1], g_Sums[2], g_Sums[3]);
}

// Fraction of the kernel's ball that the walls leave to water.
float OpenPart(float3 p)
{
    float wall;
    float3 wallGradient;
    WallDensity(p, wall, wallGradient);
    return max(1.0 - wall, kMinOpen);
}

// Sums over the water around a point: w the density without its scale, xyz velocity times it.
void AddNear(inout float4 sum, float3 p, bool ofPhases, uint i)
{
    float3 difference = PositionOf(i) - p;
    float weight = Poly6(dot(difference, difference));
    if (weight <= 0.0)
        return;
    sum += weight * float4(_Velocities[i].xyz, 1.0);
    if (ofPhases)
        InterlockedAdd(g_Phases[PhaseOf(i)], uint(weight * kPhaseScale));
}

float4 SumNear(uint thread, float3 p, bool ofPhases)
{
    float4 sum = 0.0;
    float reach = kSupport + kReachMargin;
    uint4 rows = RowsWithin(p, reach);
    uint2 counts = rows.zw - rows.xy + 1;
    for (uint row = thread / kRowLanes; row < counts.x * counts.y; row += kProbeGroup / kRowLanes)
    {
        uint2 range = SortedRange(p, reach * reach, rows.x + row % counts.x, rows.y + row / counts.x);
        for (uint i = range.x + thread % kRowLanes; i < range.y; i += kRowLanes)
            AddNear(sum, p, ofPhases, i);
    }
    for (uint late = FirstUnsorted() + thread; late < _Counters[kAlive]; late += kProbeGroup)
        AddNear(sum, p, ofPhases, late);
    return sum;
}

// Phase of most of the water that was summed.
uint DominantPhase()
{
    uint phase = 0;
    for (uint other = 1; other < kPhases; other++)
        phase = g_Phases[other] > g_Phases[phase] ? other : phase;
    return phase;
}

#endif
