// The kernels that sum over the particles of each phase, see Statistics.compute.

#include "../../Generated/ParticleTags.hlsl"

#ifdef PHASES

StructuredBuffer<uint> _Tags;
RWStructuredBuffer<float> _PhasePartials;

groupshared uint g_Phases[kGroup];
groupshared float g_Terms[kPhaseQuantityCount * kGroup];

void SetTerm(uint thread, uint quantity, float value)
{
    g_Terms[quantity * kGroup + thread] = value;
}

[numthreads(kGroup, 1, 1)]
void MeasurePhases(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint slot = ParticleIndex(group, thread);
    g_Phases[thread] = kPhaseSums;      // none
    if (slot < _Counters[kSorted])
    {
        uint i = _Order[slot].x;
        float3 p = _Positions[i].xyz;
        float3 v = _Velocities[i].xyz;
        g_Phases[thread] = _Tags[i] >> kTagPhaseShift;
        SetTerm(thread, kPhaseCount, 1.0);
        SetTerm(thread, kPhaseSpeedSquared, dot(v, v));
        for (uint axis = 0; axis < 3; axis++)
        {
            SetTerm(thread, kPhasePosition + axis, p[axis]);
            SetTerm(thread, kPhaseVelocity + axis, v[axis]);
        }
    }
    GroupMemoryBarrierWithGroupSync();

    for (uint sum = thread; sum < kPhaseSums; sum += kGroup)
    {
        uint phase = sum / kPhaseQuantityCount;
        uint quantity = sum % kPhaseQuantityCount;
        float total = 0.0;
        for (uint other = 0; other < kGroup; other++)
            total += g_Phases[other] == phase ? g_Terms[quantity * kGroup + other] : 0.0;
        _PhasePartials[GroupIndex(group) * kPhaseSums + sum] = total;
    }
}

#else

StructuredBuffer<float> _PhasePartials;

// A group for each sum.
[numthreads(kReducers, 1, 1)]
void ReducePhases(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint rows = (_Counters[kSorted] + kGroup - 1) / kGroup;
    float total = 0.0;
    for (uint row = thread; row < rows; row += kReducers)
        total += _PhasePartials[row * kPhaseSums + group.x];
    Fold(thread, total, true);
    if (thread == 0)
        _Statistics[kFirstPhaseSum + group.x] = asuint(g_Sums[0]);
}

#endif
