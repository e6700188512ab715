// Walks the grid cells within reach of a point as rows along x: each row is one contiguous range of sorted particles.
// Rows beyond the reach are skipped and the others cut to it, so that small cells cost little more tests than the
// sphere needs. Include after _CellStarts is declared.
#ifndef RILL_GRID_ROWS_INCLUDED
#define RILL_GRID_ROWS_INCLUDED

// Cells in y and z that a ball around p touches: lowest in xy, highest (inclusive) in zw.
uint4 RowsWithin(float3 p, float reach)
{
    uint2 last = _CellCounts.yz - 1;
    uint2 low = min(uint2(max((p.yz - reach) * _InverseCellSize.yz, 0.0)), last);
    uint2 high = min(uint2(max((p.yz + reach) * _InverseCellSize.yz, 0.0)), last);
    return uint4(low, high);
}

// Distance of coordinate x from the slab of cells numbered 'cell', each 'size' wide; 0 inside.
float SlabDistance(float x, uint cell, float size)
{
    float low = cell * size;
    return max(max(low - x, x - low - size), 0.0);
}

// Sorted particles [x, y) of the row (y, z) from x 'low' to 'high', by whole cells.
uint2 RowPart(float low, float high, uint y, uint z)
{
    uint last = _CellCounts.x - 1;
    uint first = min(uint(max(low * _InverseCellSize.x, 0.0)), last);
    uint end = min(uint(max(high * _InverseCellSize.x, 0.0)), last);
    uint row = (z * _CellCounts.y + y) * _CellCounts.x;
    return uint2(_CellStarts[row + first], _CellStarts[row + end + 1]);
}

// Sorted particles [x, y) of the row (y, z) within reach of p; an empty range if the row is out of reach.
uint2 RowRange(float3 p, float reachSquared, uint y, uint z)
{
    float dy = SlabDistance(p.y, y, _CellSize.y);
    float dz = SlabDistance(p.z, z, _CellSize.z);
    float left = reachSquared - dy * dy - dz * dz;
    if (left <= 0.0)
        return 0;

    float reach = sqrt(left);
    return RowPart(p.x - reach, p.x + reach, y, z);
}

#endif
