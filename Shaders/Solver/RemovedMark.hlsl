// Mark in the position of a particle that was removed and is yet to be left out by the sort.
#ifndef RILL_REMOVED_MARK_INCLUDED
#define RILL_REMOVED_MARK_INCLUDED

static const uint kRemovedBits = 0x7fc00000u;       // no number

// Tests a position as it is stored: w of all others is 0.
bool IsMarkedRemoved(float4 position)
{
    return asuint(position.w) == kRemovedBits;
}

#endif
