// Foam on water as a web: it lies along the borders of cells, fine lines where it is thin, holes where it is thick, and the flow carries it along as
// it does ripples. On the mean over the water it covers as much as it is told to.
#ifndef RILL_FOAM_WEB_INCLUDED
#define RILL_FOAM_WEB_INCLUDED

#include "Ripples.hlsl"
#include "Foam.hlsl"

static const float kFineWeb = 0.38;         // width of the finer cells, of the others
static const float kFinePart = 0.42;        // of the web, that they make
static const float kSeenWeb = 3.0;          // texels from center to center, up to which a mean is seen
static const float kWebLife = 2.0;          // of a pattern, of a ripple's
// Turns the lattice against the axes: in a plane along it, as still water is, borders between cells are rarer or more frequent than in space.
static const float3x3 kTilt = { 0.5999, -0.5938, 0.5363, 0.7526, 0.6462, -0.1264, -0.2715, 0.4794, 0.8345 };
static const float kSoftWeb = 0.15;         // how soft edges are, of what covers

// Rank of a sum of two numbers that are evenly spread over 0 to 1, among all such sums: evenly spread too. part: weight of the second.
float RankOfSum(float first, float second, float part)
{
    float large = max(part, 1.0 - part), small = max(min(part, 1.0 - part), 1e-4), sum = lerp(first, second, part);
    float low = min(sum, 1.0 - sum), rank = low < small ? low * low / (2.0 * small * large) : (low - 0.5 * small) / large;
    return sum < 0.5 ? rank : 1.0 - rank;
}

// How near a point is to a border between cells (Worley 1996), as the part of all points that are farther: evenly spread over 0 to 1.
float RankOnBorders(float3 at, uint pattern)
{
    int3 first = int3(floor(at));
    float2 nearest = 8.0;
    [loop]
    for (uint i = 0; i < 27; i++)
    {
        int3 cell = first + int3(uint3(i % 3, i / 3 % 3, i / 9)) - 1;
        float3 offset = cell + RandomAt(cell, pattern) - at;
        float squared = dot(offset, offset);
        nearest = squared < nearest.x ? float2(squared, nearest.x) : float2(nearest.x, min(nearest.y, squared));
    }
    float beyond = sqrt(nearest.y) - sqrt(nearest.x);
    return exp(-beyond * (3.95 + beyond * (2.15 + 3.14 * beyond)));      // fitted to 60,000 points, within 0.002
}

// How much foam covers at a point, if around it it covers that much. p: d; chord: displacement in the last substep, d; cell: width of the larger
// cells, d; texels: the same on the picture.
float InWeb(float covered, float3 p, float3 chord, float cell, float texels)
{
    float shown = saturate(texels / kSeenWeb - 1.0);
    if (shown <= 0.0)
        return covered;
    float part = kFinePart * saturate(kFineWeb * texels / kSeenWeb - 1.0);
    float2 ranks = 0.0;
    [loop]
    for (uint i = 0; i < 2; i++)
    {
        float lives = _Ripples.y / kWebLife + 0.5 * i, age = frac(lives);
        uint pattern = uint(int(floor(lives))) * 4u + 2u * i;
        float3 at = mul(kTilt, p - chord * (_Ripples.z * kWebLife * (age - 0.5))) / cell;
        float rank = RankOnBorders(at, pattern);
        if (part > 0.0)
            rank = RankOfSum(rank, RankOnBorders(at / kFineWeb, pattern + 1u), part);
        ranks = i == 0 ? float2(rank, 0.0) : float2(ranks.x, rank);
    }
    float rank = RankOfSum(ranks.y, ranks.x, 1.0 - abs(2.0 * frac(_Ripples.y / kWebLife) - 1.0));
    return lerp(covered, CoveredByRank(covered, rank, kSoftWeb), shown);
}

#endif
