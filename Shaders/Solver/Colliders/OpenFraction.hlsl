// Fraction of the domain that colliders leave to the fluid. Include after Solver.hlsl.
//
//   _ColliderVolume    [1]          uint, fraction of the domain that they take, in steps of 1 / kColliderVolumeSteps
#ifndef RILL_OPEN_FRACTION_INCLUDED
#define RILL_OPEN_FRACTION_INCLUDED

static const float kColliderVolumeSteps = 1073741824.0;    // 2^30: a sum over at most 2^17 cells, each rounded, fits

#if defined(WITH_COLLIDERS)

StructuredBuffer<uint> _ColliderVolume;

float OpenFraction()
{
    return 1.0 - _ColliderVolume[0] / kColliderVolumeSteps;
}

#else

float OpenFraction()
{
    return 1.0;
}

#endif

#endif
