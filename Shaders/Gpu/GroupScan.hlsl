// Sum over the values of the threads before one, in a group of kGroup. Include after it is declared.
#ifndef RILL_GROUP_SCAN_INCLUDED
#define RILL_GROUP_SCAN_INCLUDED

static const uint kScanRow = 8;     // threads of a row

groupshared uint g_Scanned[kGroup];
groupshared uint g_ScannedRows[kGroup / kScanRow];

// Every thread of the group must call it. By rows: more additions than in a tree, but few waits for the other threads.
uint SumBefore(uint value, uint thread, out uint total)
{
    uint row = thread / kScanRow;
    g_Scanned[thread] = value;
    GroupMemoryBarrierWithGroupSync();
    uint before = 0;
    uint inRow = 0;
    [unroll]
    for (uint column = 0; column < kScanRow; column++)
    {
        uint other = g_Scanned[row * kScanRow + column];
        before += column < thread % kScanRow ? other : 0;
        inRow += other;
    }
    if (thread % kScanRow == 0)
        g_ScannedRows[row] = inRow;
    GroupMemoryBarrierWithGroupSync();
    total = 0;
    [unroll]
    for (uint r = 0; r < kGroup / kScanRow; r++)
    {
        uint other = g_ScannedRows[r];
        before += r < row ? other : 0;
        total += other;
    }
    return before;
}

#endif
