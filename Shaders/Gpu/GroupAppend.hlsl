// Room in a list for what the threads of a group have found, with one atomic for all of them. Before it is included there must be
// RILL_APPEND_COUNT, the number of elements in the list so far.
#ifndef RILL_GROUP_APPEND_INCLUDED
#define RILL_GROUP_APPEND_INCLUDED

groupshared uint g_Appended;
groupshared uint g_FirstSlot;

// Room for what each thread of the group has found: the first of its slots. By all threads of a group.
uint Append(uint thread, uint count)
{
    if (thread == 0)
        g_Appended = 0;
    GroupMemoryBarrierWithGroupSync();
    uint rank = 0;
    if (count > 0)
        InterlockedAdd(g_Appended, count, rank);
    GroupMemoryBarrierWithGroupSync();
    if (thread == 0 && g_Appended > 0)     // most groups find nothing, and would all wait for one counter
        InterlockedAdd(RILL_APPEND_COUNT, g_Appended, g_FirstSlot);
    GroupMemoryBarrierWithGroupSync();
    return g_FirstSlot + rank;
}

#endif
