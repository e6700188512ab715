// The kernels of rays and of balls that are cast, see Queries.compute.
//
//   _Rays    [rays]          in   see Generated/Queries.hlsl
//   _Lines   [_LineCount]    in   uint, ray << kLineShift | number of the line
//
// SearchLines finds where a line enters or leaves the water; the nearest counts. A ball is as many lines from the half of it that is ahead: it
// touches the water where the first of them enters. AnswerRays finds the water there.

StructuredBuffer<RayQuery> _Rays;
StructuredBuffer<uint> _Lines;
uint _LineCount;
uint _FirstRayWord;

static const float kGoldenAngle = 2.3999632;
static const float kLevel = 0.7;            // cosine from gravity up to which columns stand along it
static const float kSlopeStep = 0.1;        // of the fraction that walls leave, d
static const float kWallReach = 0.1;        // d: water as dense as kWallDensity so near to a wall ends there, and has no surface
static const float kWallDensity = 0.75;
static const float kBeyond = 1e-3;          // d
static const float kBeyondWall = -1.0;      // instead of the density of a sample outside the box

groupshared uint g_StartsInWater;
groupshared uint g_Densest;
groupshared uint g_Touching;

// A point of 'count' on a sphere or, of the half of it ahead, on a hemisphere: evenly spread along a spiral. Length 1.
float3 OnSphere(uint number, uint count, float3 ahead, bool isHalf)
{
    float part = (number + 0.5) / count;
    float along = isHalf ? 1.0 - part : 1.0 - 2.0 * part;
    float aside = sqrt(max(1.0 - along * along, 0.0));
    float3 x, y;
    Across(ahead, x, y);
    return along * ahead + aside * (cos(number * kGoldenAngle) * x + sin(number * kGoldenAngle) * y);
}

// From the ray to one of its lines, d.
float3 LineOffset(RayQuery ray, uint number)
{
    return ray.radius * OnSphere(number, ray.lines, ray.direction, true);
}

bool IsInBox(float3 p)
{
    return all(p >= -kBeyond) && all(p <= _DomainSize + kBeyond);
}

// By one thread.
float DensityAt(float3 p)
{
    float sum = 0.0;
    float reach = kSupport + kReachMargin;
    uint4 rows = RowsWithin(p, reach);
    for (uint z = rows.y; z <= rows.w; z++)
        for (uint y = rows.x; y <= rows.z; y++)
        {
            uint2 range = SortedRange(p, reach * reach, y, z);
            for (uint i = range.x; i < range.y; i++)
            {
                float3 away = PositionOf(i) - p;
                sum += Poly6(dot(away, away));
            }
        }
    for (uint late = FirstUnsorted(); late < _Counters[kAlive]; late++)
    {
        float3 away = PositionOf(late) - p;
        sum += Poly6(dot(away, away));
    }
    return _DensityScale * sum / OpenPart(p);
}

// Gradient of the sum that w of SumNear is, a thread's part of it.
float3 SumSlope(uint thread, float3 p)
{
    float3 sum = 0.0;
    float reach = kSupport + kReachMargin;
    uint4 rows = RowsWithin(p, reach);
    uint2 counts = rows.zw - rows.xy + 1;
    for (uint row = thread / kRowLanes; row < counts.x * counts.y; row += kProbeGroup / kRowLanes)
    {
        uint2 range = SortedRange(p, reach * reach, rows.x + row % counts.x, rows.y + row / counts.x);
        for (uint i = range.x + thread % kRowLanes; i < range.y; i += kRowLanes)
        {
            float3 away = PositionOf(i) - p;
            float left = max(kSupportSquared - dot(away, away), 0.0);
            sum += 6.0 * left * left * away;
        }
    }
    for (uint late = FirstUnsorted() + thread; late < _Counters[kAlive]; late += kProbeGroup)
    {
        float3 away = PositionOf(late) - p;
        float left = max(kSupportSquared - dot(away, away), 0.0);
        sum += 6.0 * left * left * away;
    }
    return sum;
}

float3 SlopeOfOpenPart(float3 p)
{
    float3 x = float3(kSlopeStep, 0.0, 0.0), y = x.yxz, z = x.yzx;
    return float3(OpenPart(p + x) - OpenPart(p - x), OpenPart(p + y) - OpenPart(p - y), OpenPart(p + z) - OpenPart(p - z))
        / (2.0 * kSlopeStep);
}

// Normal of the wall that p is at, out of the box; 0 for none.
float3 NormalOfWall(float3 p)
{
    float3 above = _DomainSize - p;
    float nearest = min(min(min(p.x, p.y), p.z), min(min(above.x, above.y), above.z));
    if (nearest > kWallReach)
        return 0.0;
    float3 low = p <= nearest ? 1.0 : 0.0, high = above <= nearest ? 1.0 : 0.0;
    return normalize(high - low + 1e-6);
}

// Along which the columns around a hit stand.
float3 ColumnAxis(float3 normal)
{
    return dot(normal, _Up.xyz) > kLevel ? _Up.xyz : normal;
}

// Distances are 0 or more, and the nearest has the highest bits of these; 0 is none.
uint Nearness(float distance)
{
    return ~asuint(distance);
}

// Each line has _GroupsPerLine groups.
[numthreads(kProbeGroup, 1, 1)]
void SearchLines(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint number = group.z * kMaxGroups + group.x;
    bool isLine = number < _LineCount;
    uint packed = _Lines[min(number, _LineCount - 1)];
    uint rayIndex = packed >> kLineShift;
    RayQuery ray = _Rays[rayIndex];
    float3 origin = ray.origin + LineOffset(ray, packed & ((1u << kLineShift) - 1));
    float2 range = RangeInBox(origin, ray.direction);
    float begin = max(range.x, 0.0);
    TubeKind kind = TubesAlong(ray.direction, kSamples);
    uint k = min(thread, kSamples - 1);
    if (thread == 0)
        g_First = kNone;
    [loop]
    for (uint i = 0; i < _ChunksPerGroup; i++)
    {
        uint chunk = i * _GroupsPerLine + group.y;
        float first = begin + chunk * kChunkLength;
        BeginChunk(thread, rayIndex, origin + first * ray.direction);
        GroupMemoryBarrierWithGroupSync();
        bool isNeeded = isLine && g_First == kNone && first <= min(range.y, ray.maxDistance) && g_Found <= Nearness(first);
        if (isNeeded)
            ListPieces(kind, 0, thread, kProbeGroup);
        AddListed(thread, kind);
        float along = first + k * kSampleStep;
        float density = kBeyondWall;
        if (isNeeded && along <= range.y)
            density = DensityOf(k, origin + along * ray.direction);
        if (thread < kSamples)
            g_Densities[thread] = density;
        GroupMemoryBarrierWithGroupSync();

        // The first sample of a chunk is the last of the one before, which finds a hit there; that of the line is at its start or at a wall.
        float before = g_Densities[max(k, 1) - 1];
        bool isWet = density >= kHalfDensity;
        bool wasWet = k > 0 ? before >= kHalfDensity : !(chunk == 0 && range.x > 0.0) && isWet;
        float change = density - before;
        change = abs(change) > 1e-6 ? change : 1e-6;
        float crossing = along - kSampleStep * (1.0 - saturate((kHalfDensity - before) / change));
        crossing = k == 0 ? begin : density == kBeyondWall ? range.y : crossing;
        bool isWanted = (ray.crossings & (isWet ? kCrossingEnter : kCrossingLeave)) != 0;
        bool isFound = isNeeded && thread < kSamples && isWet != wasWet && isWanted && crossing <= ray.maxDistance;
        if (isFound)
            InterlockedMin(g_First, k);
        GroupMemoryBarrierWithGroupSync();
        if (isFound && k == g_First)
            InterlockedMax(_Found[rayIndex], Nearness(crossing));
    }
}

// A group finds for each ray the water where it hits it, and the slope of the surface there.
[numthreads(kProbeGroup, 1, 1)]
void AnswerRays(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    RayQuery ray = _Rays[group.x];
    uint at = _FirstRayWord + group.x * kRayWords;
    uint found = _Found[group.x];
    float distance = found != 0 ? asfloat(~found) : 0.0;
    bool isBall = ray.radius > 0.0;
    if (thread == 0)
    {
        g_StartsInWater = 0;
        g_Densest = 0;
        g_Touching = kNone;
    }
    if (thread < kPhases)
        g_Phases[thread] = 0;
    GroupMemoryBarrierWithGroupSync();

    // For a ball a thread samples a point on it, and one for each line where it touches: all threads together ask for a ray's start.
    float4 near = 0.0;
    if (!isBall && IsInBox(ray.origin))
        near = SumNear(thread, ray.origin, false);
    near = SumThreads(thread, near);
    float density = 0.0;
    if (isBall)
    {
        float3 start = ray.origin + ray.radius * OnSphere(thread, kProbeGroup, ray.direction, false);
        if (IsInBox(start) && DensityAt(start) >= kHalfDensity)
            g_StartsInWater = 1;
        float3 touch = ray.origin + distance * ray.direction + LineOffset(ray, min(thread, ray.lines - 1));
        if (found != 0 && thread < ray.lines && IsInBox(touch))
            density = DensityAt(touch);
        InterlockedMax(g_Densest, asuint(density));
    }
    else if (thread == 0 && _DensityScale * near.w / OpenPart(ray.origin) >= kHalfDensity)
        g_StartsInWater = 1;
    GroupMemoryBarrierWithGroupSync();
    if (thread < ray.lines && asuint(density) == g_Densest)
        InterlockedMin(g_Touching, thread);
    GroupMemoryBarrierWithGroupSync();

    // A ball that is in water enters none.
    bool isHit = found != 0 && !(isBall && g_StartsInWater != 0);
    float3 p = clamp(ray.origin + distance * ray.direction + LineOffset(ray, g_Touching), 0.0, _DomainSize);
    near = 0.0;
    float3 slope = 0.0;
    if (isHit)
    {
        near = SumNear(thread, p, true);
        slope = SumSlope(thread, p);
    }
    near = SumThreads(thread, near);
    slope = SumThreads(thread, slope);
    float open = OpenPart(p);
    float3 outward = near.w * SlopeOfOpenPart(p) - open * slope;
    float length2 = dot(outward, outward);
    float3 normal = length2 > 0.0 ? outward * rsqrt(max(length2, 1e-30)) : -ray.direction;
    float3 wall = NormalOfWall(p);
    bool isAtWall = any(wall != 0.0) && _DensityScale * near.w / open > kWallDensity;
    bool isAtSurface = isHit && !isAtWall;
    float3 axis = ColumnAxis(normal);
    FindColumns(thread, isAtSurface, p, axis);
    if (thread != 0)
        return;
    if (isAtSurface)
        normal = NormalOfColumns(axis, normal);
    StoreFloat(at + kRayDistance, distance);
    StoreVector(at + kRayPoint, p);
    StoreVector(at + kRayNormal, isAtWall ? wall : normal);
    StoreVector(at + kRayVelocity, near.xyz / max(near.w, 1e-9));
    _Results[at + kRayPhase] = DominantPhase();
    _Results[at + kRayFlags] = (isHit ? kRayHit : 0) | (g_StartsInWater != 0 ? kRayStartsInWater : 0) | (isAtSurface ? kRayAtSurface : 0);
    _Found[group.x] = 0;
}
