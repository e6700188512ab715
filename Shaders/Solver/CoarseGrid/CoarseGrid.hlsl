// The coarse grid of the two-level correction: cells of about four particle spacings, x first. Lengths in d.
#ifndef RILL_COARSE_GRID_INCLUDED
#define RILL_COARSE_GRID_INCLUDED

#include "../../Generated/CoarseGrid.hlsl"

// Flags of a cell, see _Surface in CoarseGrid.compute.
static const uint kAtSurface = 1;       // the cell or one beside it is active, not both
static const uint kNearSurface = 2;     // one of the 27 around the cell is at the surface
static const uint kActive = 4;          // in the projection of this substep
static const uint kBesideSolid = 8;     // one of the 27 is not all open
static const uint kSurfaceFlags = 15;

uint CoarseCell(float3 p)
{
    uint3 cell = min(uint3(max(p * _InverseCoarseSize, 0.0)), _CoarseCounts - 1);
    return (cell.z * _CoarseCounts.y + cell.y) * _CoarseCounts.x + cell.x;
}

uint3 CellCoordinates(uint cell, uint3 counts)
{
    return uint3(cell % counts.x, cell / counts.x % counts.y, cell / (counts.x * counts.y));
}

uint3 CellStrides(uint3 counts)
{
    return uint3(1, counts.x, counts.x * counts.y);
}

// Distance, in cells, of the free surface from where an active cell's potential stands, inverted: from how much water that cell and the
// inactive one beyond hold. With water below, 'deep', the potential stands at the cell's center; without, in the center of the water,
// since from its center a cell less than half full would have none: water of a few layers would feel no slope and rest in heaps.
float InverseSurfaceDistance(float fill, float beyond, bool deep)
{
    float height = fill + beyond;
    float distance = height - 0.5 * (deep ? 1.0 : min(height, 1.0));
    return 1.0 / clamp(distance, _MinSurfaceDistance, _MaxSurfaceDistance);
}

#endif
