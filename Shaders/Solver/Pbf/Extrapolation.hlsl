// Change of a velocity beyond that along the last path, see VelocityExtrapolation.cs. Include after Solver.hlsl and PackedVector.hlsl.
//
//   _Means  [kSorted]  i/o  uint4, float xyz mean velocity of a particle's neighborhood along its path in a substep, d/s; w its change
//                           since the substep before, d/s, packed, its bits turned by kNoChange: 0 without a mean
#ifndef RILL_EXTRAPOLATION_INCLUDED
#define RILL_EXTRAPOLATION_INCLUDED

static const uint kNoChange = 0x04020100u;      // no packed vector has these bits
static const float kSteady = 2.0;   // of a change over the last one: up to that all of it is taken to last

RWStructuredBuffer<uint4> _Means;
float _ChangeScale;                 // of a change of velocity in this substep, 1 unless the substep's length or the extrapolation is new
float _LastChangeScale;             // of that in the last one

// How much of a change is taken to last: of one like the last change all, of one that is new or turns back none, since impacts
// would bounce and noise would grow.
float SteadyFraction(float3 change, float3 last)
{
    return saturate(kSteady * dot(change, last) / max(dot(change, change), 1e-20)) * saturate(2.0 - length(change) / _MaxExtrapolation);
}

// A fraction of the change of the mean velocity once more, as the acceleration goes on. What is new or awake again has none: it gets
// what gravity gives.
float3 Extrapolate(uint i, float3 mean)
{
    uint4 last = _Means[i];
    float3 change = _GravityStep * (_InverseTimeStep / _AccelerationFraction);
    float fraction = 1.0;
    if (last.w != 0)
    {
        change = _ChangeScale * (mean - asfloat(last.xyz));
        fraction = SteadyFraction(change, _LastChangeScale * UnpackVector(last.w ^ kNoChange));
    }
    _Means[i] = uint4(asuint(mean), PackVector(change) ^ kNoChange);
    return _Extrapolation * fraction * change;
}

#endif
