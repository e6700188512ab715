// Counts particles into the cells of the grid, which begins their sort. Include after Solver.hlsl; _Counters is writable.
#ifndef RILL_CELL_COUNT_INCLUDED
#define RILL_CELL_COUNT_INCLUDED

RWStructuredBuffer<uint> _CellHistogram;    // [cells + 1], particles in a cell
RWStructuredBuffer<uint2> _CellRanks;       // [kAlive], cell and arrival number in it, or kCulled

static const uint kCulled = 0xFFFFFFFFu;

// Returns where a particle would go without the constraint (Macklin and Mueller 2013, algorithm 1, lines 1-4).
float3 Predict(float3 p, float3 velocity)
{
    return p + velocity * _TimeStep + _GravityStep;
}

// Whether the position is finite: one that is not has no cell, and its particle is left out of the sort and so of the simulation.
bool CountInCell(uint i, float3 predicted)
{
    uint2 cellAndRank = uint2(kCulled, 0);
    bool isFinite = IsFinite(predicted);
    if (isFinite)
    {
        cellAndRank.x = CellIndex(ClampToDomain(predicted));
        InterlockedAdd(_CellHistogram[cellAndRank.x], 1, cellAndRank.y);
    }
    _CellRanks[i] = cellAndRank;
    return isFinite;
}

// Counts as part of a step, which reports particles that are left out.
void CountInStep(uint i, float3 predicted)
{
    if (!CountInCell(i, predicted))
        InterlockedAdd(_Counters[kNonFinite], 1);
}

#endif
