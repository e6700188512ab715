// Reactions on colliders: sums of the displacements that they give to it, and their moments. Exact and independent of
// their order: integers, 64 bits each. Include after Colliders.hlsl and RWStructuredBuffer<uint> _Reactions is declared.
#ifndef RILL_REACTIONS_INCLUDED
#define RILL_REACTIONS_INCLUDED

#include "../../Generated/Reactions.hlsl"

static const float kReactionRange = 100.0;      // d: a longer displacement of a particle counts as that
static const float kForceRange = 16384.0;       // d: a larger contribution of a cell counts as that

void AddSigned(uint at, int value)
{
    uint before;
    InterlockedAdd(_Reactions[at], uint(value), before);
    uint carry = before + uint(value) < before ? 1 : 0;
    uint high = (value < 0 ? 0xFFFFFFFFu : 0u) + carry;
    if (high != 0)
        InterlockedAdd(_Reactions[at + 1], high);
}

// Returns what the fluid gained at p, in displacements of one particle, and its moment about the collider's position; kNoCollider for an
// owner that does not want to know.
uint Reaction(uint owner, float3 p, float3 gain, float range, out int3 sum, out int3 moment)
{
    moment = 0;
    sum = 0;
    if (owner == kNoCollider)
        return kNoCollider;
    Collider collider = _Colliders[owner];
    float lengthSquared = dot(gain, gain);
    if (lengthSquared > range * range)
        gain *= range * rsqrt(lengthSquared);
    sum = int3(round(gain * kReactionScale));
    moment = int3(round(cross((p - collider.position) / collider.momentArm, gain) * kReactionScale));
    return (collider.flags & kReacts) != 0 && lengthSquared > 0.0 ? owner : kNoCollider;
}

void StoreReaction(uint owner, int3 sum, int3 moment, uint count)
{
    uint at = owner * kReactionStride;
    for (uint axis = 0; axis < 3; axis++)
    {
        AddSigned(at + 2 * axis, sum[axis]);
        AddSigned(at + 6 + 2 * axis, moment[axis]);
    }
    InterlockedAdd(_Reactions[at + 12], count);
}

#ifdef RILL_CELL_REACTIONS

// Adds the reaction of a cell of the coarse grid.
void AddCellReaction(uint owner, float3 p, float3 gain)
{
    int3 sum, moment;
    owner = Reaction(owner, p, gain, kForceRange, sum, moment);
    if (owner != kNoCollider)
        StoreReaction(owner, sum, moment, 0);
}

#else

#include "../../Gpu/GroupRuns.hlsl"

groupshared int3 g_Sums[kGroup];
groupshared int3 g_Moments[kGroup];

// Adds the reaction of a particle. All threads of a group come here; 'owner' is kNoCollider where there is nothing to add.
void AddReaction(uint thread, uint owner, float3 p, float3 gain)
{
    int3 sum, moment;
    owner = Reaction(owner, p, gain, kReactionRange, sum, moment);
    g_Sums[thread] = sum;
    g_Moments[thread] = moment;
    if (!StartsRun(thread, owner == kNoCollider ? kNoRun : owner))
        return;

    uint count = 1;
    FOR_REST_OF_RUN(thread, owner, next)
        sum += g_Sums[next];
        moment += g_Moments[next];
        count++;
    END_RUN
    StoreReaction(owner, sum, moment, count);
}

#endif

#endif
