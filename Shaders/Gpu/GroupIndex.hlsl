// The index of a thread group in a dispatch that is folded into two dimensions: as many groups as one dimension holds in each row.
#ifndef RILL_GROUP_INDEX_INCLUDED
#define RILL_GROUP_INDEX_INCLUDED

#include "../Generated/ThreadGroups.hlsl"

uint GroupIndex(uint3 group)
{
    return group.y * kMaxGroups + group.x;
}

#endif
