// Factor of the coarse grid's displacement of a particle, as the last velocity update left it; 1 where all have one density.
// Include after Solver.hlsl, with _Counters.
#ifndef RILL_COARSE_SLIP_INCLUDED
#define RILL_COARSE_SLIP_INCLUDED

#ifdef RILL_MATERIALS

StructuredBuffer<float> _Slips;     // [kMoved], see PhaseSlip.hlsl

float SlipOf(uint i)
{
    return i < _Counters[kMoved] ? _Slips[i] : 1.0;
}

#else

float SlipOf(uint i)
{
    return 1.0;
}

#endif

#endif
