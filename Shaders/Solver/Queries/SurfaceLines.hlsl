// Density along a line, in chunks of kSamples samples, each found by a group of threads. Chunks without a particle around them are left
// out: a look at the cells tells which. Include after WaterAround.hlsl.
#ifndef RILL_SURFACE_LINES_INCLUDED
#define RILL_SURFACE_LINES_INCLUDED

static const uint kAtOnce = 8;                  // particles that a thread has in flight
static const uint kTubeRowLanes = 2;            // threads of a row along a tube
static const float kSampleStep = 0.5;           // of the density along the line, d
static const float kChunkLength = kSampleStep * (kSamples - 1);     // neighboring chunks have a sample in common
static const uint kSegments = 4;                // of a chunk's tube, each searched by kSegmentLanes threads
static const uint kSegmentLanes = kProbeGroup / kSegments;
static const float kSegmentLength = (kChunkLength + 2.0 * kSupport) / kSegments;
static const uint kMarked = 32;                 // chunks that are marked at once: a bit each
static const uint kMarkLanes = kProbeGroup / (kMarked * kSegments);
static const float kColumnScale = 1048576.0;    // steps of a density
static const uint kRingSamples = 15;            // of a column, see SurfaceColumns.hlsl
static const uint kNone = 0xFFFFFFFFu;
static const uint kListCapacity = 1152;         // particles in the tubes of a group; more are summed where they are met
static const uint kSlotBits = 4;                // of what is listed: the column
static const float kAsideScale = 67108864.0;    // steps of a squared distance, below kSupportSquared = 4, in the other bits

groupshared uint g_ListCount;
groupshared float g_ListAlong[kListCapacity];   // position along the line of what lies in a tube, d
groupshared uint g_ListAside[kListCapacity];    // squared distance from it << kSlotBits | column
groupshared uint g_Weights[kColumns * kRingSamples];       // of the weights at each sample, of each column or of the line
groupshared float g_Densities[kColumns * kRingSamples];
groupshared uint g_First;           // sample that the surface is above
groupshared uint g_Chunks;          // a bit for each chunk that particles may lie around

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
void AddToSamples(bool isRing, float along, uint aside)
{
    uint count = isRing ? kRingSamples : kSamples;
    uint at = isRing ? (aside & ((1u << kSlotBits) - 1)) * kRingSamples : 0;
    float asideSquared = (aside >> kSlotBits) / kAsideScale;
    int first = max(int(ceil((along - kSupport) / kSampleStep)), 0);
    int last = min(int(floor((along + kSupport) / kSampleStep)), int(count) - 1);
    for (int k = first; k <= last; k++)
    {
        float between = k * kSampleStep - along;
        InterlockedAdd(g_Weights[at + k], uint(_DensityScale * Poly6(asideSquared + between * between) * kColumnScale));
    }
}

// Takes a particle in the tube around a line or column. Few are, and each reaches many samples: they are listed, and the group's threads
// share them out.
void List(uint column, bool isRing, float along, float asideSquared)
{
    uint aside = uint(asideSquared * kAsideScale) << kSlotBits | column;
    uint at;
    InterlockedAdd(g_ListCount, 1, at);
    if (at < kListCapacity)
    {
        g_ListAlong[at] = along;
        g_ListAside[at] = aside;
    }
    else
        AddToSamples(isRing, along, aside);
}

// All threads come here.
void AddListed(uint thread, bool isRing)
{
    GroupMemoryBarrierWithGroupSync();
    uint count = min(g_ListCount, kListCapacity);
    for (uint i = thread; i < count; i += kProbeGroup)
        AddToSamples(isRing, g_ListAlong[i], g_ListAside[i]);
    GroupMemoryBarrierWithGroupSync();
}

// Clears sums and list. All threads come here, and a barrier has to follow.
void ClearSamples(uint thread)
{
    if (thread < kColumns * kRingSamples)
        g_Weights[thread] = 0;
    if (thread == 0)
        g_ListCount = 0;
}

// Where the tube around a segment of a chunk begins along the line, from the chunk's first sample.
float SegmentBegin(uint segment)
{
    return segment * kSegmentLength - kSupport;
}

static const float kSegmentReach = sqrt(0.25 * kSegmentLength * kSegmentLength + kSupportSquared) + kReachMargin;

// The ball around a segment of a chunk whose first sample is at 'start': its center, and the rows of cells that it touches.
bool FindSegment(uint segment, float3 start, float3 direction, out float3 center, out uint4 rows)
{
    center = start + (SegmentBegin(segment) + 0.5 * kSegmentLength) * direction;
    rows = RowsWithin(center, kSegmentReach);
    return all(center > -kSegmentReach) && all(center < _DomainSize + kSegmentReach);
}

// Whether a particle is in the tube around a line; 'along' it from start.
bool IsInTube(float3 particle, float3 start, float3 direction, out float along, out float asideSquared)
{
    float3 away = particle - start;
    along = dot(away, direction);
    asideSquared = max(dot(away, away) - along * along, 0.0);
    return asideSquared < kSupportSquared;
}

// Lists what lies around a chunk of a line, whose first sample is at 'start'. A segment has threads of its own, and rows of cells that are
// empty cost it two reads.
void AddChunk(uint thread, float3 start, float3 direction)
{
    uint segment = thread / kSegmentLanes;
    uint lane = thread % kSegmentLanes;
    float begin = SegmentBegin(segment);
    float along, asideSquared;
    float3 center;
    uint4 rows;
    if (FindSegment(segment, start, direction, center, rows))
    {
        uint2 counts = rows.zw - rows.xy + 1;
        for (uint row = lane / kTubeRowLanes; row < counts.x * counts.y; row += kSegmentLanes / kTubeRowLanes)
        {
            uint2 range = SortedRange(center, kSegmentReach * kSegmentReach, rows.x + row % counts.x, rows.y + row / counts.x);
            for (uint i = range.x + lane % kTubeRowLanes * kAtOnce; i < range.y; i += kTubeRowLanes * kAtOnce)
            {
                float3 particles[kAtOnce];
                LoadParticles(i, range.y, particles);
                [unroll]
                for (uint k = 0; k < kAtOnce; k++)
                    if (IsInTube(particles[k], start, direction, along, asideSquared) && along >= begin && along < begin + kSegmentLength)
                        List(0, false, along, asideSquared);
            }
        }
    }
    for (uint late = FirstUnsorted() + thread; late < _Counters[kAlive]; late += kProbeGroup)
        if (IsInTube(PositionOf(late), start, direction, along, asideSquared) && along >= -kSupport && along < kChunkLength + kSupport)
            List(0, false, along, asideSquared);
}

// Marks in g_Chunks which of kMarked chunks of a line particles may lie around; the first begins at 'start'.
void MarkChunks(uint thread, float3 start, float3 direction)
{
    uint chunk = thread / (kMarkLanes * kSegments);
    float3 center;
    uint4 rows;
    if (FindSegment(thread / kMarkLanes % kSegments, start + chunk * kChunkLength * direction, direction, center, rows))
    {
        uint2 counts = rows.zw - rows.xy + 1;
        uint found = 0;
        for (uint row = thread % kMarkLanes; row < counts.x * counts.y; row += kMarkLanes)
        {
            uint2 range = SortedRange(center, kSegmentReach * kSegmentReach, rows.x + row % counts.x, rows.y + row / counts.x);
            found |= range.y - range.x;
        }
        if (found != 0)
            InterlockedOr(g_Chunks, 1u << chunk);
    }
    for (uint late = FirstUnsorted() + thread; late < _Counters[kAlive]; late += kProbeGroup)
    {
        float along, asideSquared;
        if (!IsInTube(PositionOf(late), start, direction, along, asideSquared))
            continue;
        int first = max(int(floor((along - kSupport) / kChunkLength)) - 1, 0);
        int last = min(int(floor((along + kSupport) / kChunkLength)), int(kMarked) - 1);
        for (int near = first; near <= last; near++)
            InterlockedOr(g_Chunks, 1u << near);
    }
}

// Density relative to rest at a sample of the chunk, at p.
float DensityOf(uint sample, float3 p)
{
    return g_Weights[sample] / (kColumnScale * OpenPart(p));
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
