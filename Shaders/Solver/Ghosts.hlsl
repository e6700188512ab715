// A ghost is a copy of a neighbor's particle that takes part in the steps of one frame, so that a fluid feels what is beyond its side of
// a connection. It belongs to the neighbor: no drain takes it, and it is neither counted nor drawn.
#ifndef RILL_GHOSTS_INCLUDED
#define RILL_GHOSTS_INCLUDED

static const uint kFirstGhost = 0x80000000u;        // particles get ids below this

bool IsGhost(uint id)
{
    return id >= kFirstGhost;
}

#endif
