// Surface tension as an attraction of pairs within each pass of the density constraint, and that of walls: what lies behind one attracts
// like the fluid itself, times the fraction that the contact angle leaves (Young-Dupre). Two liquids attract each other by what their tensions
// and the one between them leave, see SurfaceTension.cs. Include after Solver.hlsl and PhaseMass.hlsl.
#ifndef RILL_SURFACE_TENSION_INCLUDED
#define RILL_SURFACE_TENSION_INCLUDED

float _PairAttraction;      // c_f sigma dt^2 / (rho d^3) of a pass: displacement of a pair by f = 1, d; of phases, with the largest sigma
float _WallAttraction;      // the same of a wall: times what the contact angle leaves; of the fluid's own material

#ifdef RILL_MATERIALS

#include "../Phases/PhasePairs.hlsl"

// Attraction of two particles, relative to that of the phase with the largest surface tension.
float RelativeAttraction(uint i, uint j)
{
    uint phase = min(_Tags[i] >> kTagPhaseShift, kMaxPhase);
    return PairEntry(_LowAttractions[phase], _HighAttractions[phase], _Tags[j] >> kTagPhaseShift);
}

float WallAttraction(uint i)
{
    return _PairAttraction * _Walls[min(_Tags[i] >> kTagPhaseShift, kMaxPhase)].x;
}

#else

float RelativeAttraction(uint i, uint j)
{
    return 1.0;
}

float WallAttraction(uint i)
{
    return _WallAttraction;
}

#endif

// f(r) = r^3 (1 - r/h)^2 over r, for a pair that is 1/'inverse' apart; 0 from the support on and for a pair at one position.
float PairAttraction(float distanceSquared, float inverse)
{
    float left = max(1.0 - distanceSquared * inverse / kSupport, 0.0);
    return distanceSquared * left * left;
}

// Attraction of the half space behind a plane at distance s: pi times the integral of f(r) (r^2 - s^2) from s to h.
float PlaneAttraction(float s)
{
    s = clamp(s, 0.0, kSupport);
    float y = s * s;
    return 3.14159265 * max(8.0 / 21.0 - y * (4.0 / 15.0 - y * y * (1.0 / 12.0 - s * (2.0 / 35.0 - s / 96.0))), 0.0);
}

// Displacement by the domain's walls in a pass, d. Of a plane acts what does not lie behind another one too, as in WallDensity.
float3 DomainAttraction(float3 p, float wallAttraction)
{
    float3 above = _DomainSize - p;
    if (wallAttraction == 0.0 || all(p >= kSupport) && all(above >= kSupport))
        return 0.0;
    float3 pull, free;
    [unroll]
    for (uint axis = 0; axis < 3; axis++)
    {
        float low, high, slope;
        HalfSpace(p[axis], low, slope);
        HalfSpace(above[axis], high, slope);
        free[axis] = (1.0 - low) * (1.0 - high);
        pull[axis] = PlaneAttraction(above[axis]) - PlaneAttraction(p[axis]);
    }
    return wallAttraction * pull * float3(free.y * free.z, free.x * free.z, free.x * free.y);
}

#endif
