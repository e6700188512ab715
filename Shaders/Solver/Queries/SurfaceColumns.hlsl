// The slope of a surface: its heights in columns around a point of it, along a direction 'up' out of the water, and a plane through them.
// Include after SurfaceLines.hlsl.
#ifndef RILL_SURFACE_COLUMNS_INCLUDED
#define RILL_SURFACE_COLUMNS_INCLUDED

static const uint kColumns = kMaxTubes;
static const uint kRingColumns = kColumns / 2;  // of a ring around the center's
static const uint kColumnSamples = kMaxSamples / kColumns;
static const uint kColumnsAtOnce = 8;           // whose particles are listed at once
static const uint kColumnLanes = kProbeGroup / kColumnsAtOnce;      // threads of each
static const float kNearRing = 3.0;             // radius, d
static const float kFarRing = 6.0;
static const float kFolded = 1.6;
static const float kRingReach = 3.5;            // of heights that differ from the center's, d: kColumnSamples over twice that
static const float kRingMargin = 0.25;          // columns that come nearer to a wall are left out, d
static const float kMinSpread = 1.0;            // determinant of the columns' second moments, d^4
static const float kNoHeight = 1e9;
static const float kBeyondWalls = -1.0;

groupshared float3 g_ColumnPoints[kColumns];       // d
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

// Offset of a column from the center's. One that would be beyond a wall stands on the other side and further off: beside a wall there are
// then as many columns, as far apart.
float2 ColumnOffset(uint column, float3 center, float3 up)
{
    float turn = (column % kRingColumns + 0.5 * (column / kRingColumns)) * (6.2831853 / kRingColumns);
    float2 offset = (column < kRingColumns ? kNearRing : kFarRing) * float2(cos(turn), sin(turn));
    return IsInside(FromCenter(center, up, offset)) ? offset : -kFolded * offset;
}

float SampleHeight(uint k)
{
    return kRingReach - k * kSampleStep;
}

// Density at a sample of a column; below 0 beyond the walls.
float ColumnDensity(uint column, uint k, float3 up)
{
    float3 at = g_ColumnPoints[column] + SampleHeight(k) * up;
    if (!IsInside(g_ColumnPoints[column]) || !all(at > 0.0) || !all(at < _DomainSize))
        return kBeyondWalls;
    return g_Samples[column * kColumnSamples + k] / (kColumnScale * OpenPart(at));
}

// Height of the surface in a column over the center's, from its densities: of those in reach the nearest; kNoHeight for none.
float ColumnHeight(uint column)
{
    float found = kNoHeight;
    float above = 1.0;
    [unroll]
    for (uint k = 0; k < kColumnSamples; k++)
    {
        float density = g_Densities[column * kColumnSamples + k];
        bool isWithin = density >= 0.0;
        float crossing = SampleHeight(k) + kSampleStep * (density - kHalfDensity) / max(density - above, 1e-6);
        if (isWithin && density >= kHalfDensity && above < kHalfDensity && abs(crossing) < abs(found))
            found = crossing;
        above = isWithin ? density : 1.0;
    }
    return found;
}

// Finds the columns around a point of the surface, and the heights of the surface in them. All threads come here.
void FindColumns(uint thread, bool isAsked, float3 center, float3 up)
{
    TubeKind kind = TubesAlong(-up, kColumnSamples);
    if (thread < kColumns)
    {
        float2 offset = ColumnOffset(thread, center, up);
        float3 p = FromCenter(center, up, offset);
        g_Columns[thread] = float3(offset, kNoHeight);
        g_ColumnPoints[thread] = p;
        g_TubeStarts[thread] = p + kRingReach * up;
    }
    if (thread < kMaxSamples)
        g_Samples[thread] = 0;
    for (uint first = 0; first < kColumns; first += kColumnsAtOnce)
    {
        if (thread == 0)
            ClearLists();
        GroupMemoryBarrierWithGroupSync();
        uint column = first + thread / kColumnLanes;
        if (isAsked && IsInside(g_ColumnPoints[column]))
            ListPieces(kind, column, thread % kColumnLanes, kColumnLanes);
        AddListed(thread, kind);
    }
    if (isAsked && thread < kMaxSamples)
        g_Densities[thread] = ColumnDensity(thread / kColumnSamples, thread % kColumnSamples, up);
    GroupMemoryBarrierWithGroupSync();
    if (isAsked && thread < kColumns)
        g_Columns[thread].z = ColumnHeight(thread);
    GroupMemoryBarrierWithGroupSync();
}

// Normal of the plane through the columns' heights by least squares; 'otherwise' if too few have one.
float3 NormalOfColumns(float3 up, float3 otherwise)
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
