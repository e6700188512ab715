// The coarse grid of the two-level correction: cells of about four particle spacings, x first. Lengths in d.
#ifndef RILL_COARSE_GRID_INCLUDED
#define RILL_COARSE_GRID_INCLUDED

// = CoarseConstants in CoarseConstants.cs, member by member; as raw as RillSolver.
cbuffer RillCoarse
{
    uint4 _CoarseCountsAndTotal;
    float4 _InverseCoarseSizeAndActiveCount;
    float4 _CouplingAndScreening;
    float _InverseVolume;       // 1/d^3
    float _NegativeFraction;       // of a small negative density error that the projection takes up
    float _MaxFlow;             // longest displacement of the projection, d
    float _MaxPush;             // longest displacement of the density correction, d
    uint _LevelCount;           // levels of the V-cycle below the grid itself
    uint _FirstTailLevel;       // the first of those that one thread group does together
    float _MinSurfaceDistance;  // nearest and furthest that the free surface lies from the water's middle, cells
    float _MaxSurfaceDistance;
    uint4 _Levels[8];           // cells along x, y, z and index of the first; [0] is the grid itself
};

#define _CoarseCounts (_CoarseCountsAndTotal.xyz)       // cells along x, y, z
#define _CoarseTotal (_CoarseCountsAndTotal.w)          // their product
#define _InverseCoarseSize (_InverseCoarseSizeAndActiveCount.xyz)       // 1/d
#define _ActiveCount (_InverseCoarseSizeAndActiveCount.w)               // particles that make a cell active: two layers across it
#define _Coupling (_CouplingAndScreening.xyz)           // 1/size^2 along each axis, 1/d^2
#define _Screening (_CouplingAndScreening.w)            // 1/l^2, 1/d^2

static const float kInactive = 1e30;    // right-hand side of a cell that is not solved for: its potential is 0

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
// inactive one beyond hold. With water below, 'deep', the potential stands at the cell's centre; without, in the middle of the water,
// since from its centre a cell less than half full would have none: water of a few layers would feel no slope and rest in heaps.
float InverseSurfaceDistance(float fill, float beyond, bool deep)
{
    float height = fill + beyond;
    float distance = height - 0.5 * (deep ? 1.0 : min(height, 1.0));
    return 1.0 / clamp(distance, _MinSurfaceDistance, _MaxSurfaceDistance);
}

#endif
