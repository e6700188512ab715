// Mean velocity and fill of blocks of the cells in which the fluid lies sorted: each takes whole rows of them, in their order, so that a run
// repeats bit for bit. Include after Solver.hlsl and where _CellStarts and _Velocities are declared.
#ifndef RILL_FLUID_CELLS_INCLUDED
#define RILL_FLUID_CELLS_INCLUDED

// Returns xyz mean velocity, d/s; w fill relative to rest, at most 1.
float4 FluidCell(uint3 block, uint3 cellsPerBlock)
{
    uint3 first = block * cellsPerBlock;
    uint3 end = min(first + cellsPerBlock, _CellCounts);
    float3 sum = 0.0;
    uint count = 0;
    for (uint z = first.z; z < end.z; z++)
    {
        for (uint y = first.y; y < end.y; y++)
        {
            uint row = (z * _CellCounts.y + y) * _CellCounts.x;
            uint last = _CellStarts[row + end.x];
            for (uint i = _CellStarts[row + first.x]; i < last; i++)
            {
                sum += _Velocities[i].xyz;
                count++;
            }
        }
    }
    float3 inside = min(end * _CellSize, _DomainSize) - first * _CellSize;
    float volume = max(inside.x * inside.y * inside.z, 1e-3);
    return float4(count > 0 ? sum / count : 0.0, min(count / volume, 1.0));
}

#endif
