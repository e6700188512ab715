// Looks up the displacement that the coarse grid gives a particle. Include after CoarseGrid.hlsl.
#ifndef RILL_COARSE_DISPLACEMENT_INCLUDED
#define RILL_COARSE_DISPLACEMENT_INCLUDED

StructuredBuffer<float4> _Displacements;    // [coarse cells], xyz at the cell's center, d

// The eight cells whose centers are around a point, as four rows of two; beyond the outermost centers the outermost cells.
struct CornerCells
{
    int3 low, high;
    float3 fraction;
};

CornerCells CellsAround(float3 p)
{
    float3 position = p * _InverseCoarseSize - 0.5;
    float3 lower = floor(position);
    int3 last = int3(_CoarseCounts) - 1;
    CornerCells cells;
    cells.fraction = position - lower;
    cells.low = clamp(int3(lower), 0, last);
    cells.high = clamp(int3(lower) + 1, 0, last);
    return cells;
}

// Indices of a row's two cells, 0 to 3, and in 'weight' what the row counts; the second cell of it counts fraction.x.
int2 CornerRow(CornerCells cells, int row, out float weight)
{
    bool upperY = (row & 1) != 0;
    bool upperZ = (row & 2) != 0;
    weight = (upperY ? cells.fraction.y : 1.0 - cells.fraction.y) * (upperZ ? cells.fraction.z : 1.0 - cells.fraction.z);
    int y = upperY ? cells.high.y : cells.low.y;
    int z = upperZ ? cells.high.z : cells.low.z;
    return (z * int(_CoarseCounts.y) + y) * int(_CoarseCounts.x) + int2(cells.low.x, cells.high.x);
}

// Trilinear between the centers, constant beyond the outermost ones, and no longer than 'longest'.
float3 CoarseDisplacement(float3 p, float longest)
{
    CornerCells cells = CellsAround(p);
    float3 sum = 0.0;
    [unroll]
    for (int row = 0; row < 4; row++)
    {
        float weight;
        int2 pair = CornerRow(cells, row, weight);
        sum += weight * lerp(_Displacements[pair.x].xyz, _Displacements[pair.y].xyz, cells.fraction.x);
    }
    float lengthSquared = dot(sum, sum);
    return lengthSquared > longest * longest ? sum * (longest * rsqrt(lengthSquared)) : sum;
}

static const float kAlone = 0.3;        // density relative to rest of a particle with a neighbor or two
static const float kCovered = 0.55;     // and of one on an edge of water at rest

// Displacement of a particle by the projection; velocity.w is its density. Displacements continue around the water, for particles between
// its last cells' centers and its surface; spray there is pressed by nothing, and would hover where they cancel gravity.
float3 ProjectedDisplacement(float3 p, float4 velocity)
{
    return saturate((velocity.w - kAlone) / (kCovered - kAlone)) * CoarseDisplacement(AlongFlow(p, velocity.xyz), _MaxFlow);
}

#endif
