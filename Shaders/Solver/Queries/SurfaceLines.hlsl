// Density along a line, in chunks of kSamples samples, by a group of threads that searches every _GroupsPerLine-th chunk of it, one after the
// other, until it has found something. Include after Tubes.hlsl.
#ifndef RILL_SURFACE_LINES_INCLUDED
#define RILL_SURFACE_LINES_INCLUDED

static const float kChunkLength = kSampleStep * (kSamples - 1);     // neighboring chunks have a sample in common
static const uint kNone = 0xFFFFFFFFu;

groupshared float g_Densities[kMaxSamples];
groupshared uint g_First;           // sample at which this group has found something; kNone so far
groupshared uint g_Found;           // what all groups have found so far

uint _GroupsPerLine;
uint _ChunksPerGroup;       // the same of all: no group may leave before a barrier

// Begins a chunk whose first sample is at 'start'. A barrier follows, and then any thread knows what was found for what is asked so far.
void BeginChunk(uint thread, uint asked, float3 start)
{
    if (thread == 0)
    {
        uint found;
        InterlockedMax(_Found[asked], 0u, found);     // a load might give what this multiprocessor has read before
        g_Found = found;
        g_TubeStarts[0] = start;
        ClearLists();
    }
    if (thread < kSamples)
        g_Samples[thread] = 0;
}

// Density relative to rest at a sample of the chunk, at p.
float DensityOf(uint sample, float3 p)
{
    return g_Samples[sample] / (kColumnScale * OpenPart(p));
}

// The range in which a line is in the box, along it from p: it is there where x < y.
float2 RangeInBox(float3 p, float3 direction)
{
    float3 slant = abs(direction) > 1e-6 ? direction : 1e-6;
    float3 ends = ((direction > 0.0 ? _DomainSize : 0.0) - p) / slant;
    float3 starts = ((direction > 0.0 ? 0.0 : _DomainSize) - p) / slant;
    bool3 isOutside = p < 0.0 || p > _DomainSize;
    ends = abs(direction) > 1e-6 ? ends : isOutside ? -1e9 : 1e9;
    starts = abs(direction) > 1e-6 ? starts : -1e9;
    return float2(max(starts.x, max(starts.y, starts.z)), min(ends.x, min(ends.y, ends.z)));
}

#endif
