// The slope of a surface: its heights in columns around a point of it, along a direction 'up' out of the water, and a plane through them.
// Include after SurfaceLines.hlsl.
#ifndef RILL_SURFACE_COLUMNS_INCLUDED
#define RILL_SURFACE_COLUMNS_INCLUDED

static const uint kRingColumns = kColumns / 2;  // of a ring around the center's
static const float kNearRing = 3.0;             // radius, d
static const float kFarRing = 6.0;
static const float kFolded = 1.6;
static const float kRingReach = 3.5;            // of heights that differ from the center's, d: kRingSamples over twice that
static const float kRingMargin = 0.25;          // columns that come nearer to a wall are left out, d
static const float kMinSpread = 1.0;            // determinant of the columns' second moments, d^4
static const float kNoHeight = 1e9;

groupshared float3 g_Columns[kColumns];     // xy offset from the center's, d, kNowhere for one that is left out; z height over it, d

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
// then as many columns, as far apart. kNowhere where that is beyond a wall too.
float2 RingOffset(uint column, float3 center, float3 up)
{
    float turn = (column % kRingColumns + 0.5 * (column / kRingColumns)) * (6.2831853 / kRingColumns);
    float2 offset = (column < kRingColumns ? kNearRing : kFarRing) * float2(cos(turn), sin(turn));
    if (IsInside(FromCenter(center, up, offset)))
        return offset;
    return IsInside(FromCenter(center, up, -kFolded * offset)) ? -kFolded * offset : kNowhere;
}

// Lists a particle, 'away' from the center, for each column whose tube it is in.
void ListInColumns(float3 away, float3 up, float3 x, float3 y)
{
    float along = kRingReach - dot(away, up);
    if (along < -kSupport || along >= 2.0 * kRingReach + kSupport)
        return;
    float2 offset = float2(dot(away, x), dot(away, y));
    for (uint column = 0; column < kColumns; column++)
    {
        float2 aside = offset - g_Columns[column].xy;
        float asideSquared = dot(aside, aside);
        if (asideSquared < kSupportSquared)
            List(column, true, along, asideSquared);
    }
}

// Lists what lies around the columns, from kRingReach above the center to as much below: in the part of a ball that a slab of that height
// cuts out.
void AddRings(uint thread, float3 center, float3 up)
{
    float widestSquared = 0.0;
    for (uint column = 0; column < kColumns; column++)
    {
        float2 offset = g_Columns[column].xy;
        float offsetSquared = dot(offset, offset);
        widestSquared = offset.x > kNowhere ? max(widestSquared, offsetSquared) : widestSquared;
    }
    float aside = sqrt(widestSquared) + kSupport, half = kRingReach + kSupport;
    float reach = sqrt(aside * aside + half * half) + kReachMargin;
    float3 x, y;
    Across(up, x, y);
    uint4 rows = RowsWithin(center, reach);
    uint2 counts = rows.zw - rows.xy + 1;
    for (uint row = thread / kTubeRowLanes; row < counts.x * counts.y; row += kProbeGroup / kTubeRowLanes)
    {
        uint2 at = rows.xy + uint2(row % counts.x, row / counts.x);
        uint2 range = SortedRange(center, reach * reach, at.x, at.y);
        for (uint i = range.x + thread % kTubeRowLanes * kAtOnce; i < range.y; i += kTubeRowLanes * kAtOnce)
        {
            float3 particles[kAtOnce];
            LoadParticles(i, range.y, particles);
            [unroll]
            for (uint k = 0; k < kAtOnce; k++)
                ListInColumns(particles[k] - center, up, x, y);
        }
    }
    for (uint late = FirstUnsorted() + thread; late < _Counters[kAlive]; late += kProbeGroup)
        ListInColumns(PositionOf(late) - center, up, x, y);
}

float RingHeight(uint k)
{
    return kRingReach - k * kSampleStep;
}

// Density at a sample of a column; below 0 where that is beyond a wall.
float RingDensity(uint column, uint k, float3 center, float3 up)
{
    float3 p = FromCenter(center, up, g_Columns[column].xy) + RingHeight(k) * up;
    bool isWithin = all(p > 0.0) && all(p < _DomainSize);
    return isWithin ? g_Weights[column * kRingSamples + k] / (kColumnScale * OpenPart(p)) : -1.0;
}

// Height of the surface in a column over the center's: of those in reach the nearest; kNoHeight for none.
float RingHeightOf(uint column)
{
    float found = kNoHeight;
    float above = 1.0;
    for (uint k = 0; k < kRingSamples; k++)
    {
        float density = g_Densities[column * kRingSamples + k];
        bool isWithin = density >= 0.0;
        float crossing = RingHeight(k) + kSampleStep * (density - kHalfDensity) / max(density - above, 1e-6);
        if (isWithin && density >= kHalfDensity && above < kHalfDensity && abs(crossing) < abs(found))
            found = crossing;
        above = isWithin ? density : 1.0;
    }
    return found;
}

// Finds the surface in all columns around a point of it, where it is asked for. All threads come here.
void FindColumns(uint thread, bool isAsked, float3 center, float3 up)
{
    ClearSamples(thread);
    if (thread < kColumns)
        g_Columns[thread] = float3(RingOffset(thread, center, up), kNoHeight);
    GroupMemoryBarrierWithGroupSync();
    if (isAsked)
        AddRings(thread, center, up);
    AddListed(thread, true);
    if (isAsked && thread < kColumns * kRingSamples)
        g_Densities[thread] = RingDensity(thread / kRingSamples, thread % kRingSamples, center, up);
    GroupMemoryBarrierWithGroupSync();
    if (isAsked && thread < kColumns && g_Columns[thread].x > kNowhere)
        g_Columns[thread].z = RingHeightOf(thread);
    GroupMemoryBarrierWithGroupSync();
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
