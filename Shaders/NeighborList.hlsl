// The neighbor lists: built once a substep within the list radius, read by every pass.
//
// Entries lie in blocks of four. Block b of particle i lies at (i / 32) * 32 * blocks + b * 32 + i % 32: the blocks of 32
// particles are adjacent, so that a wave reads whole cache lines, and four neighbors are under way at a time. One Direct3D
// resource ends at 2 GB; with RILL_TWO_LISTS the particles from _FirstListParticles on have theirs in a second buffer.
#ifndef RILL_NEIGHBOR_LIST_INCLUDED
#define RILL_NEIGHBOR_LIST_INCLUDED

#ifdef RILL_BUILD_LIST
#define RILL_LIST RWStructuredBuffer<uint4>
#else
#define RILL_LIST StructuredBuffer<uint4>
#endif

RILL_LIST _Neighbors;           // [_FirstListParticles * _NeighborCapacity / 4], sorted particle indices
#ifdef RILL_TWO_LISTS
RILL_LIST _MoreNeighbors;
#endif

uint NeighborBase(uint i)
{
#ifdef RILL_TWO_LISTS
    if (i >= _FirstListParticles)
        i -= _FirstListParticles;
#endif
    return (i >> 5) * (_NeighborCapacity * 8) + (i & 31);
}

// Neighbors k to k + 3; k a multiple of 4. Those beyond the count are not neighbors.
uint4 NeighborBlock(uint i, uint base, uint k)
{
#ifdef RILL_TWO_LISTS
    if (i >= _FirstListParticles)
        return _MoreNeighbors[base + k * 8];
#endif
    return _Neighbors[base + k * 8];
}

// From a neighbor to a particle; of what is no neighbor, out of every kernel's reach. So all four of a block are fetched
// without a branch: the entries of a block that is not full are particles too.
float3 DifferenceIf(bool isNeighbor, float3 p, float3 other)
{
    return isNeighbor ? p - other : kSupport;
}

#ifdef RILL_BUILD_LIST
void StoreBlock(uint i, uint base, uint k, uint4 block)
{
#ifdef RILL_TWO_LISTS
    if (i >= _FirstListParticles)
    {
        _MoreNeighbors[base + k * 8] = block;
        return;
    }
#endif
    _Neighbors[base + k * 8] = block;
}

// Adds neighbor number 'count'; 'block' holds those since the last multiple of 4.
void AddNeighbor(uint i, uint base, inout uint4 block, uint count, uint neighbor)
{
    uint place = count & 3;
    block.x = place == 0 ? neighbor : block.x;
    block.y = place == 1 ? neighbor : block.y;
    block.z = place == 2 ? neighbor : block.z;
    block.w = neighbor;
    if (place == 3 && count < _NeighborCapacity)
        StoreBlock(i, base, count - 3, block);
}

// Stores a last block that is not full.
void EndNeighbors(uint i, uint base, uint4 block, uint count)
{
    if ((count & 3) != 0 && count < _NeighborCapacity)
        StoreBlock(i, base, count & ~3u, block);
}
#endif

#endif
