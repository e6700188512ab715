// The kernel of detectors, see Queries.compute.

static const uint kParticlesPerGroup = kGroup * kParticlesPerThread;
static const float kMaxSpeed = 8191.0;      // d/s: what is faster counts as that, so that a group's sum fits 32 bits
static const uint kCopies = 8;              // of a group's sums, so that threads add to different ones
static const uint kGroupSums = kDetectorWords / 2;

groupshared uint g_Low[3];
groupshared uint g_High[3];
groupshared uint g_Hits;            // a bit for each detector that the group may have particles in
groupshared int g_Totals[kMaxDetectors * kGroupSums * kCopies];

#ifdef MESH
#include "../../Gpu/Filtering.hlsl"

Texture3D<float> _Field;        // distance, m of the mesh's frame
#endif

// Fraction of a particle's cube that is in the shape: of a box along its axes exactly, else by the distance of its center.
float FractionInside(DetectorRegion detector, float3 p)
{
    float3 local = Unrotate(detector.rotation, p - detector.center);
#ifdef MESH
    float3 reach = max(abs(detector.size) - detector.halfVoxel, 0.0);
    float3 held = clamp(local, -reach, reach);        // beyond the field its distance grows by that to it
    float distanceToMesh = LoadTrilinear(_Field, 0.5 + 0.5 * held / detector.size) * detector.fieldUnit;
    return saturate(0.5 - distanceToMesh - length(local - held));
#else
    if (detector.shape == kBox)
    {
        float3 inside = saturate(min(local + 0.5, detector.size) - max(local - 0.5, -detector.size));
        return inside.x * inside.y * inside.z;
    }
    // A sphere is a capsule without a straight part. Of a curved surface a cube's part is less than the distance says.
    float aside = local.y - clamp(local.y, -detector.size.y, detector.size.y);
    float distance = length(float3(local.x, aside, local.z)) - detector.size.x;
    float curvature = (aside != 0.0 || detector.size.y <= 0.0 ? 2.0 : 1.0) / max(detector.size.x, 0.25);
    return saturate(0.5 - distance - curvature / 24.0);
#endif
}

void AddTotal(uint detector, uint sum, uint thread, int value)
{
    InterlockedAdd(g_Totals[(detector * kGroupSums + sum) * kCopies + thread % kCopies], value);
}

// Two's complement of 64 bits, low word first.
void AddResult(uint at, int value)
{
    uint before;
    InterlockedAdd(_Results[at], uint(value), before);
    uint high = (value < 0 ? 0xFFFFFFFFu : 0u) + (before + uint(value) < before ? 1 : 0);
    if (high != 0)
        InterlockedAdd(_Results[at + 1], high);
}

[numthreads(kGroup, 1, 1)]
void Detect(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint first = group.x * kParticlesPerGroup + thread;
    uint end = min(_Counters[kAlive], (group.x + 1) * kParticlesPerGroup);
    if (thread < 3)
    {
        g_Low[thread] = 0xFFFFFFFFu;
        g_High[thread] = 0;
    }
    if (thread == 0)
        g_Hits = 0;
    GroupMemoryBarrierWithGroupSync();

    float3 positions[kParticlesPerThread];
    float3 velocities[kParticlesPerThread];
    float3 low = 3e38, high = -1.0;
    [unroll]
    for (uint j = 0; j < kParticlesPerThread; j++)
    {
        uint i = first + j * kGroup;
        float3 p = i < end ? _Positions[i].xyz : kNowhere;
        float3 v = i < end ? _Velocities[i].xyz : 0.0;
        bool isFinite = IsFinite(p) && IsFinite(v) && i < end;
        positions[j] = isFinite ? p : kNowhere;
        velocities[j] = clamp(v, -kMaxSpeed, kMaxSpeed);
        low = isFinite ? min(low, max(p, 0.0)) : low;
        high = isFinite ? max(high, max(p, 0.0)) : high;
    }
    if (high.x >= 0.0)
    {
        for (uint axis = 0; axis < 3; axis++)       // bits of floats that are not negative are in their order
        {
            InterlockedMin(g_Low[axis], asuint(low[axis]));
            InterlockedMax(g_High[axis], asuint(high[axis]));
        }
    }
    GroupMemoryBarrierWithGroupSync();

    if (thread < _DetectorCount)
    {
        float3 groupLow = asfloat(uint3(g_Low[0], g_Low[1], g_Low[2])), groupHigh = asfloat(uint3(g_High[0], g_High[1], g_High[2]));
        DetectorRegion asked = _Detectors[_FirstDetector + thread];
        if (g_Low[0] <= g_High[0] && all(groupLow <= asked.high) && all(groupHigh >= asked.low))
            InterlockedOr(g_Hits, 1u << thread);
    }
    GroupMemoryBarrierWithGroupSync();

    uint hits = g_Hits;
    for (uint clearing = hits; clearing != 0; clearing &= clearing - 1)
        for (uint word = thread; word < kGroupSums * kCopies; word += kGroup)
            g_Totals[firstbitlow(clearing) * kGroupSums * kCopies + word] = 0;
    GroupMemoryBarrierWithGroupSync();

    // A thread sums its particles first: the fewer additions to the group's totals.
    [loop]
    for (uint left = hits; left != 0; left &= left - 1)
    {
        uint detector = firstbitlow(left);
        DetectorRegion region = _Detectors[_FirstDetector + detector];
        int3 momentum = 0;
        int volume = 0;
        [unroll]
        for (uint k = 0; k < kParticlesPerThread; k++)
        {
            if (!all(positions[k] >= region.low) || !all(positions[k] <= region.high))
                continue;
            float inside = FractionInside(region, positions[k]);
            momentum += int3(round(velocities[k] * inside * kVelocityScale));
            volume += int(round(inside * kVolumeScale));
#ifdef RILL_TAGS
            AddTotal(detector, 3 + PhaseOf(first + k * kGroup), thread, int(round(inside * kVolumeScale)));
#endif
        }
        if (volume == 0)
            continue;
        AddTotal(detector, 0, thread, momentum.x);
        AddTotal(detector, 1, thread, momentum.y);
        AddTotal(detector, 2, thread, momentum.z);
#ifndef RILL_TAGS
        AddTotal(detector, 3, thread, volume);
#endif
    }
    GroupMemoryBarrierWithGroupSync();

    for (uint sum = thread; sum < _DetectorCount * kGroupSums; sum += kGroup)
    {
        if ((hits >> (sum / kGroupSums) & 1) == 0)
            continue;
        int total = 0;
        for (uint copy = 0; copy < kCopies; copy++)
            total += g_Totals[sum * kCopies + copy];
        if (total != 0)
            AddResult(_FirstDetectorWord + 2 * sum, total);
    }
}
