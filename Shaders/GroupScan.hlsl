// Sum over the values of the threads before one, in a group of 128. Include after kGroup is declared.
#ifndef RILL_GROUP_SCAN_INCLUDED
#define RILL_GROUP_SCAN_INCLUDED

groupshared uint g_Scanned[128];

// Every thread of the group must call it.
uint SumBefore(uint value, uint thread, out uint total)
{
    g_Scanned[thread] = value;
    GroupMemoryBarrierWithGroupSync();
    uint sum = value;
    for (uint reach = 1; reach < 128; reach *= 2)
    {
        uint before = thread >= reach ? g_Scanned[thread - reach] : 0;
        GroupMemoryBarrierWithGroupSync();
        sum += before;
        g_Scanned[thread] = sum;
        GroupMemoryBarrierWithGroupSync();
    }
    total = g_Scanned[127];
    return sum - value;
}

#endif
