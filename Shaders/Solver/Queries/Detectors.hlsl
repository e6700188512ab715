// The kernel of detectors, see Queries.compute.

static const uint kParticlesPerGroup = kGroup * kParticlesPerThread;
static const float kMaxSpeed = 8191.0;      // d/s: what is faster counts as that, so that a group's sum fits 32 bits
static const float kBeyondAll = 3e38;       // d
static const uint kCopies = 8;              // of a group's sums, so that threads add to different ones
static const uint kGroupSums = kDetectorWords / 2;

static const uint kBounds = 6;              // of a box: its low corner, and what its high one is below 0
static const uint kBoundStride = kGroup + 1;    // so that threads read from different banks
static const uint kBoundParts = 16;

groupshared float g_Bounds[kBounds * kBoundStride];
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

// Lowest of each bound over the group's threads, which then is the first. All threads come here.
void FoldBounds(uint thread)
{
    GroupMemoryBarrierWithGroupSync();
    if (thread < kBounds * kBoundParts)
    {
        uint at = thread / kBoundParts * kBoundStride + thread % kBoundParts;
        float lowest = g_Bounds[at];
        for (uint i = kBoundParts; i < kGroup; i += kBoundParts)
            lowest = min(lowest, g_Bounds[at + i]);
        g_Bounds[at] = lowest;
    }
    GroupMemoryBarrierWithGroupSync();
    if (thread < kBounds)
    {
        float lowest = g_Bounds[thread * kBoundStride];
        for (uint part = 1; part < kBoundParts; part++)
            lowest = min(lowest, g_Bounds[thread * kBoundStride + part]);
        g_Bounds[thread * kBoundStride] = lowest;
    }
    GroupMemoryBarrierWithGroupSync();
}

float3 BoundsFrom(uint first)
{
    return float3(g_Bounds[first * kBoundStride], g_Bounds[(first + 1) * kBoundStride], g_Bounds[(first + 2) * kBoundStride]);
}

[numthreads(kGroup, 1, 1)]
void Detect(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint first = group.x * kParticlesPerGroup + thread;
    uint end = min(_Counters[kAlive], (group.x + 1) * kParticlesPerGroup);
    float3 positions[kParticlesPerThread];
    float3 velocities[kParticlesPerThread];
    float3 low = kBeyondAll, high = -kBeyondAll;
    [unroll]
    for (uint j = 0; j < kParticlesPerThread; j++)
    {
        uint i = first + j * kGroup;
        float3 p = i < end ? _Positions[i].xyz : kNowhere;
        float3 v = i < end ? _Velocities[i].xyz : 0.0;
        bool isFinite = IsFinite(p) && IsFinite(v) && i < end;
        positions[j] = isFinite ? p : kNowhere;
        velocities[j] = clamp(v, -kMaxSpeed, kMaxSpeed);
        low = isFinite ? min(low, p) : low;
        high = isFinite ? max(high, p) : high;
    }
    [unroll]
    for (uint axis = 0; axis < 3; axis++)
    {
        g_Bounds[axis * kBoundStride + thread] = low[axis];
        g_Bounds[(3 + axis) * kBoundStride + thread] = -high[axis];
    }
    if (thread == 0)
        g_Hits = 0;
    FoldBounds(thread);

    if (thread < _DetectorCount)
    {
        DetectorRegion asked = _Detectors[_FirstDetector + thread];
        if (all(BoundsFrom(0) <= asked.high) && all(-BoundsFrom(3) >= asked.low))
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
