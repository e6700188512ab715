// The neighbor lists: built once a substep within the list radius, read by every pass.
//
// Entries lie in blocks of four. Block b of particle i lies at (i / 32) * 32 * blocks + b * 32 + i % 32: the blocks of 32
// particles are adjacent, so that a wave reads whole cache lines, and four neighbors are in flight at a time. One Direct3D
// resource ends at 2 GB; with RILL_TWO_LISTS the particles from _FirstListParticles on have theirs in a second buffer.
#ifndef RILL_NEIGHBOR_LIST_INCLUDED
#define RILL_NEIGHBOR_LIST_INCLUDED

#include "../../Generated/NeighborList.hlsl"

// uint4 that each entry before takes: blocks of a particle lie kParticlesPerListBlock apart
static const uint kListStride = kParticlesPerListBlock / kBlockEntries;

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
    return i / kParticlesPerListBlock * (_NeighborCapacity * kListStride) + i % kParticlesPerListBlock;
}

// Neighbors k to k + 3; k a multiple of 4. The rest of a particle's last block is the particle itself.
uint4 NeighborBlock(uint i, uint base, uint k)
{
#ifdef RILL_TWO_LISTS
    if (i >= _FirstListParticles)
        return _MoreNeighbors[base + k * kListStride];
#endif
    return _Neighbors[base + k * kListStride];
}

// Visits the neighbors of particle i as j, up to END_NEIGHBORS: four at a time, so that what is fetched of them is in flight together.
// 'count' is their number, _NeighborCounts[i]. What fills up the last block is i itself: see OwnEntries.
#define FOR_NEIGHBORS(i, count, j) \
    { \
        uint listBase = NeighborBase(i); \
        for (uint k = 0; k < count; k += kBlockEntries) \
        { \
            uint4 block = NeighborBlock(i, listBase, k); \
            [unroll] \
            for (uint e = 0; e < kBlockEntries; e++) \
            { \
                uint j = block[e];
#define END_NEIGHBORS } } }

// The same, with the list's next block in flight as well: for a loop that waits for more than positions of its neighbors. It gains
// nothing elsewhere and costs registers.
#define FOR_NEIGHBORS_AHEAD(i, count, j) \
    { \
        uint listBase = NeighborBase(i); \
        uint4 next = NeighborBlock(i, listBase, 0); \
        for (uint k = 0; k < count; k += kBlockEntries) \
        { \
            uint4 block = next; \
            next = NeighborBlock(i, listBase, k + kBlockEntries < count ? k + kBlockEntries : k); \
            [unroll] \
            for (uint e = 0; e < kBlockEntries; e++) \
            { \
                uint j = block[e];

// How often a list names its own particle, to fill its last block: all four of a block are added without asking, and what the
// particle added to itself is taken off the sums.
uint OwnEntries(uint count)
{
    return (0u - count) & 3u;
}

#ifdef RILL_BUILD_LIST
void StoreBlock(uint i, uint base, uint k, uint4 block)
{
#ifdef RILL_TWO_LISTS
    if (i >= _FirstListParticles)
    {
        _MoreNeighbors[base + k * kListStride] = block;
        return;
    }
#endif
    _Neighbors[base + k * kListStride] = block;
}

// Adds neighbor number 'count'; 'block' holds the last four, the new one last: moving them all takes no test of its slot.
void AddNeighbor(uint i, uint base, inout uint4 block, uint count, uint neighbor)
{
    block = uint4(block.yzw, neighbor);
    if ((count & 3) == 3 && count < _NeighborCapacity)
        StoreBlock(i, base, count - 3, block);
}

// Stores a last block that is not full: its one, two or three neighbors, then the particle itself.
void EndNeighbors(uint i, uint base, uint4 block, uint count)
{
    uint last = count & 3;
    if (last != 0 && count < _NeighborCapacity)
        StoreBlock(i, base, count & ~3u, last == 1 ? uint4(block.w, i, i, i) : last == 2 ? uint4(block.zw, i, i) : uint4(block.yzw, i));
}
#endif

#endif
