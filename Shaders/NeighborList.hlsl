// The neighbor lists: built once a substep within the list radius, read by every pass.
//
// Entry k of particle i lies at (i / 32) * 32 * capacity + k * 32 + i % 32: the k-th entries of 32 particles are
// adjacent, so that a wave reads whole cache lines. One Direct3D resource ends at 2 GB; with RILL_TWO_LISTS the
// particles from _FirstListParticles on have theirs in a second buffer.
#ifndef RILL_NEIGHBOR_LIST_INCLUDED
#define RILL_NEIGHBOR_LIST_INCLUDED

#ifdef RILL_BUILD_LIST
#define RILL_LIST RWStructuredBuffer<uint>
#else
#define RILL_LIST StructuredBuffer<uint>
#endif

RILL_LIST _Neighbors;           // [_FirstListParticles * _NeighborCapacity], sorted particle indices
#ifdef RILL_TWO_LISTS
RILL_LIST _MoreNeighbors;
#endif

uint NeighborBase(uint i)
{
#ifdef RILL_TWO_LISTS
    if (i >= _FirstListParticles)
        i -= _FirstListParticles;
#endif
    return (i >> 5) * (_NeighborCapacity * 32) + (i & 31);
}

uint Neighbor(uint i, uint base, uint k)
{
#ifdef RILL_TWO_LISTS
    if (i >= _FirstListParticles)
        return _MoreNeighbors[base + k * 32];
#endif
    return _Neighbors[base + k * 32];
}

#ifdef RILL_BUILD_LIST
void StoreNeighbor(uint i, uint base, uint k, uint neighbor)
{
#ifdef RILL_TWO_LISTS
    if (i >= _FirstListParticles)
    {
        _MoreNeighbors[base + k * 32] = neighbor;
        return;
    }
#endif
    _Neighbors[base + k * 32] = neighbor;
}
#endif

#endif
