// Tables with an entry for each pair of phases: two rows for each phase, of its pairs with phases 0 to 3 and with phases 4 to 7.
#ifndef RILL_PHASE_PAIRS_INCLUDED
#define RILL_PHASE_PAIRS_INCLUDED

float PairEntry(float4 low, float4 high, uint other)
{
    float4 row = other < 4 ? low : high;
    return row[other & 3];
}

#endif
