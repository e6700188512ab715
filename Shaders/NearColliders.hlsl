// The lists of particles that a collider may touch in a substep: of the ways before the sort, and of the passes after it. The second
// takes the place of the first.
#ifndef RILL_NEAR_COLLIDERS_INCLUDED
#define RILL_NEAR_COLLIDERS_INCLUDED

// Of _NearCounts, = NearColliders in NearColliders.cs; their dispatch arguments lie 16 bytes apart in the same order.
static const uint kPaths = 0;
static const uint kPasses = 1;

#endif
