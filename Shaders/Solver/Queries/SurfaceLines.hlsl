// Density along a line, in chunks of kSamples samples, each found by a group of threads. Include after WaterAround.hlsl.
#ifndef RILL_SURFACE_LINES_INCLUDED
#define RILL_SURFACE_LINES_INCLUDED

static const uint kAtOnce = 2;                  // particles that a thread has in flight
static const uint kTubeRowLanes = 2;            // threads of a row along a tube
static const float kSampleStep = 0.5;           // of the density along the line, d
static const float kChunkLength = kSampleStep * (kSamples - 1);     // neighboring chunks have a sample in common
static const uint kSegments = 4;                // of a chunk's tube, each searched by kSegmentLanes threads
static const uint kSegmentLanes = kProbeGroup / kSegments;
static const float kSegmentLength = (kChunkLength + 2.0 * kSupport) / kSegments;
static const float kColumnScale = 1048576.0;    // steps of a density
static const uint kRingSamples = 15;            // of a column, see SurfaceColumns.hlsl
static const uint kNone = 0xFFFFFFFFu;
static const uint kListCapacity = 768;          // particles in the tubes of a group; more are summed where they are met

groupshared uint g_ListCount;
groupshared float2 g_List[kListCapacity];        // x position along the line, d, and y squared distance from it, d^2, of what lies in a tube
groupshared uint g_ListSlots[kListCapacity];     // column of each
groupshared uint g_Column[kSamples];
groupshared float g_Densities[kSamples];
groupshared uint g_Ring[kGroupColumns * kRingSamples];
groupshared uint g_First;           // sample that the surface is above

// Particles from one on, with what is beyond the last of them nowhere: all are in flight at once.
void LoadParticles(uint first, uint end, out float3 particles[kAtOnce])
{
    [unroll]
    for (uint k = 0; k < kAtOnce; k++)
    {
        particles[k] = PositionOf(min(first + k, end - 1));
        particles[k] = first + k < end ? particles[k] : kNowhere;
    }
}

// Adds a particle to the samples of the line or of a column, 'along' from the first of which it lies. Sums are integers: their order does
// not matter.
void AddToSamples(uint slot, bool isRing, float along, float asideSquared)
{
    uint count = isRing ? kRingSamples : kSamples;
    int first = max(int(ceil((along - kSupport) / kSampleStep)), 0);
    int last = min(int(floor((along + kSupport) / kSampleStep)), int(count) - 1);
    for (int k = first; k <= last; k++)
    {
        float between = k * kSampleStep - along;
        uint weight = uint(_DensityScale * Poly6(asideSquared + between * between) * kColumnScale);
        if (isRing)
            InterlockedAdd(g_Ring[slot * kRingSamples + k], weight);
        else
            InterlockedAdd(g_Column[k], weight);
    }
}

// Takes a particle that lies in the tube around a line, 'begin' to 'end' along it from 'start'. Few do, and each reaches many samples: they
// are listed, and the group's threads share them out.
void ListInTube(uint slot, bool isRing, float3 start, float3 direction, float begin, float end, float3 particle)
{
    float3 away = particle - start;
    float along = dot(away, direction);
    float asideSquared = dot(away, away) - along * along;
    if (asideSquared >= kSupportSquared || along < begin || along >= end)
        return;
    uint at;
    InterlockedAdd(g_ListCount, 1, at);
    if (at < kListCapacity)
    {
        g_List[at] = float2(along, asideSquared);
        g_ListSlots[at] = slot;
    }
    else
        AddToSamples(slot, isRing, along, asideSquared);
}

// All threads come here.
void AddListed(uint thread, bool isRing)
{
    GroupMemoryBarrierWithGroupSync();
    uint count = min(g_ListCount, kListCapacity);
    for (uint i = thread; i < count; i += kProbeGroup)
        AddToSamples(g_ListSlots[i], isRing, g_List[i].x, g_List[i].y);
    GroupMemoryBarrierWithGroupSync();
}

// Lists what lies around a chunk of a line, whose first sample is at 'start'. A segment has threads of its own, and rows of cells that are
// empty cost it two reads.
void AddChunk(uint thread, float3 start, float3 direction)
{
    uint segment = thread / kSegmentLanes;
    uint lane = thread % kSegmentLanes;
    float begin = segment * kSegmentLength - kSupport;
    float3 center = start + (begin + 0.5 * kSegmentLength) * direction;
    float reach = sqrt(0.25 * kSegmentLength * kSegmentLength + kSupportSquared) + kReachMargin;
    if (all(center > -reach) && all(center < _DomainSize + reach))
    {
        uint4 rows = RowsWithin(center, reach);
        uint2 counts = rows.zw - rows.xy + 1;
        for (uint row = lane / kTubeRowLanes; row < counts.x * counts.y; row += kSegmentLanes / kTubeRowLanes)
        {
            uint2 range = SortedRange(center, reach * reach, rows.x + row % counts.x, rows.y + row / counts.x);
            for (uint i = range.x + lane % kTubeRowLanes * kAtOnce; i < range.y; i += kTubeRowLanes * kAtOnce)
            {
                float3 particles[kAtOnce];
                LoadParticles(i, range.y, particles);
                [unroll]
                for (uint k = 0; k < kAtOnce; k++)
                    ListInTube(0, false, start, direction, begin, begin + kSegmentLength, particles[k]);
            }
        }
    }
    for (uint late = FirstUnsorted() + thread; late < _Counters[kAlive]; late += kProbeGroup)
        ListInTube(0, false, start, direction, -kSupport, kChunkLength + kSupport, PositionOf(late));
}

// Density relative to rest at a sample of the chunk, at p.
float DensityOf(uint sample, float3 p)
{
    return g_Column[sample] / (kColumnScale * OpenPart(p));
}

// The range in which a line is in the box, along it from p: it is there where x < y.
float2 RangeInBox(float3 p, float3 direction)
{
    float3 slant = abs(direction) > 1e-6 ? direction : 1e-6;
    float3 ends = ((direction > 0.0 ? _DomainSize : 0.0) - p) / slant;
    float3 starts = ((direction > 0.0 ? 0.0 : _DomainSize) - p) / slant;
    bool3 isBeside = p < 0.0 || p > _DomainSize;
    ends = abs(direction) > 1e-6 ? ends : isBeside ? -1e9 : 1e9;
    starts = abs(direction) > 1e-6 ? starts : -1e9;
    return float2(max(starts.x, max(starts.y, starts.z)), min(ends.x, min(ends.y, ends.z)));
}

#endif
