// The slope of a surface: its heights in columns around a point of it, along a direction 'up' out of the water, and a plane through them.
// Include after SurfaceLines.hlsl.
#ifndef RILL_SURFACE_COLUMNS_INCLUDED
#define RILL_SURFACE_COLUMNS_INCLUDED

static const uint kRingColumns = kColumns / 2;  // of a ring around the center's
static const uint kRingLanes = kProbeGroup / kGroupColumns;     // threads of a column
static const uint kColumnGroups = kColumns / kGroupColumns;
static const float kNearRing = 3.0;             // radius, d
static const float kFarRing = 6.0;
static const float kFolded = 1.6;
static const float kRingReach = 3.5;            // of heights that differ from the center's, d: kRingSamples over twice that
static const float kRingMargin = 0.25;          // columns that come nearer to a wall are left out, d
static const float kMinSpread = 1.0;            // determinant of the columns' second moments, d^4
static const float kNoHeight = 1e9;
static const float kBeyondWalls = -1.0;

groupshared float g_RingDensities[kGroupColumns * kRingSamples];
groupshared float3 g_Columns[kColumns];     // xy offset from the center's, z height over it, d

// Two directions across 'up' and each other, length 1.
void Across(float3 up, out float3 x, out float3 y)
{
    x = normalize(cross(up, abs(up.x) < 0.7 ? float3(1.0, 0.0, 0.0) : float3(0.0, 1.0, 0.0)));
    y = cross(up, x);
}

float3 FromCenter(float3 center, float3 up, float2 offset)
{
    float3 x, y;
    Across(up, x, y);
    return center + offset.x * x + offset.y * y;
}

bool IsInside(float3 p)
{
    return all(p > kRingMargin) && all(p < _DomainSize - kRingMargin);
}

// Of a column from the center's. One that would be beyond a wall stands on the other side and further off: beside a wall there are
// then as many columns, as far apart.
float2 RingOffset(uint column, float3 center, float3 up)
{
    float turn = (column % kRingColumns + 0.5 * (column / kRingColumns)) * (6.2831853 / kRingColumns);
    float2 offset = (column < kRingColumns ? kNearRing : kFarRing) * float2(cos(turn), sin(turn));
    return IsInside(FromCenter(center, up, offset)) ? offset : -kFolded * offset;
}

float3 RingPoint(uint column, float3 center, float3 up)
{
    return FromCenter(center, up, RingOffset(column, center, up));
}

float RingHeight(uint k)
{
    return kRingReach - k * kSampleStep;
}

// Densities along the columns of a group, from kRingReach above the center to as much below.
void AddRings(uint thread, uint firstColumn, float3 center, float3 up)
{
    uint slot = thread / kRingLanes;
    uint lane = thread % kRingLanes;
    float3 p = RingPoint(firstColumn + slot, center, up);
    if (!IsInside(p))
        return;
    float tube = kRingReach + kSupport;         // length of each half of it
    float reach = sqrt(0.25 * tube * tube + kSupportSquared) + kReachMargin;
    float from = lane < kRingLanes / 2 ? -kSupport : kRingReach;       // below its first sample; half of the threads search each
    float3 start = p + kRingReach * up;
    float3 middle = start - (from + 0.5 * tube) * up;
    uint4 rows = RowsWithin(middle, reach);
    uint2 counts = rows.zw - rows.xy + 1;
    uint rowLane = lane % (kRingLanes / 2);
    for (uint row = rowLane / kTubeRowLanes; row < counts.x * counts.y; row += kRingLanes / 2 / kTubeRowLanes)
    {
        uint2 range = SortedRange(middle, reach * reach, rows.x + row % counts.x, rows.y + row / counts.x);
        for (uint i = range.x + rowLane % kTubeRowLanes * kAtOnce; i < range.y; i += kTubeRowLanes * kAtOnce)
        {
            float3 particles[kAtOnce];
            LoadParticles(i, range.y, particles);
            [unroll]
            for (uint k = 0; k < kAtOnce; k++)
                ListInTube(slot, true, start, -up, from, from + tube, particles[k]);
        }
    }
    for (uint late = FirstUnsorted() + lane; late < _Counters[kAlive]; late += kRingLanes)
        ListInTube(slot, true, start, -up, -kSupport, 2.0 * kRingReach + kSupport, PositionOf(late));
}

// Density at a sample of a column; below 0 beyond the walls.
float RingDensity(uint slot, uint k, uint column, float3 center, float3 up)
{
    float3 p = RingPoint(column, center, up);
    float3 at = p + RingHeight(k) * up;
    if (!IsInside(p) || !all(at > 0.0) || !all(at < _DomainSize))
        return kBeyondWalls;
    return g_Ring[slot * kRingSamples + k] / (kColumnScale * OpenPart(at));
}

// Height of the surface in a column over the center's, from its densities: of those in reach the nearest; kNoHeight for none.
float RingHeightOf(uint slot)
{
    float found = kNoHeight;
    float above = 1.0;
    [unroll]
    for (uint k = 0; k < kRingSamples; k++)
    {
        float density = g_RingDensities[slot * kRingSamples + k];
        bool isWithin = density >= 0.0;
        float crossing = RingHeight(k) + kSampleStep * (density - kHalfDensity) / max(density - above, 1e-6);
        if (isWithin && density >= kHalfDensity && above < kHalfDensity && abs(crossing) < abs(found))
            found = crossing;
        above = isWithin ? density : 1.0;
    }
    return found;
}

// Height of the surface in a thread's column of a group, of which 'firstColumn' is the first; kNoHeight where it is not asked for. All
// threads come here, the first kGroupColumns for an answer.
float FindRingHeight(uint thread, bool isAsked, uint firstColumn, float3 center, float3 up)
{
    uint slot = min(thread / kRingSamples, kGroupColumns - 1), k = thread % kRingSamples;
    if (isAsked && thread < kGroupColumns * kRingSamples)
        g_RingDensities[thread] = RingDensity(slot, k, firstColumn + slot, center, up);
    GroupMemoryBarrierWithGroupSync();
    float height = kNoHeight;
    if (isAsked && thread < kGroupColumns)
        height = RingHeightOf(thread);
    return height;
}

// Of the plane through the columns' heights by least squares; 'otherwise' where too few have one.
float3 NormalOfRing(float3 up, float3 otherwise)
{
    uint column;
    float count = 1.0;      // the probe's own column, at 0
    float3 mean = 0.0;
    for (column = 0; column < kColumns; column++)
    {
        bool isFound = g_Columns[column].z < kNoHeight;
        count += isFound ? 1.0 : 0.0;
        mean += isFound ? g_Columns[column] : 0.0;
    }
    mean /= count;
    float2 squares = mean.xy * mean.xy, slope = mean.xy * mean.z;
    float mixed = mean.x * mean.y;
    for (column = 0; column < kColumns; column++)
    {
        float3 away = g_Columns[column].z < kNoHeight ? g_Columns[column] - mean : 0.0;
        squares += away.xy * away.xy;
        mixed += away.x * away.y;
        slope += away.xy * away.z;
    }
    float determinant = squares.x * squares.y - mixed * mixed;
    if (determinant < kMinSpread)
        return otherwise;
    slope = float2(squares.y * slope.x - mixed * slope.y, squares.x * slope.y - mixed * slope.x) / determinant;
    float3 x, y;
    Across(up, x, y);
    return normalize(up - slope.x * x - slope.y * y);
}

#endif
