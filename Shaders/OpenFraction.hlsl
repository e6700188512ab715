// What colliders leave of the domain to the fluid. Include after Solver.hlsl.
//
//   _SolidVolume    [1]          uint, fraction of the domain that they take, in steps of 1 / kSolidVolumeSteps
#ifndef RILL_OPEN_FRACTION_INCLUDED
#define RILL_OPEN_FRACTION_INCLUDED

static const float kSolidVolumeSteps = 1073741824.0;    // 2^30: a sum over at most 2^17 cells, each rounded, fits

#if defined(BESIDE) || defined(SOLIDS)

StructuredBuffer<uint> _SolidVolume;

float OpenFraction()
{
    return 1.0 - _SolidVolume[0] / kSolidVolumeSteps;
}

#else

float OpenFraction()
{
    return 1.0;
}

#endif

#endif
