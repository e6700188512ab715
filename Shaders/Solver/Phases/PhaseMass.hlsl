// Masses and viscosities of particles where phases are of several materials (RILL_MATERIALS), relative to the heaviest and the most viscous
// phase. Elsewhere all are 1, and nothing is read. Include after Solver.hlsl.
//
//   _Tags            [particles]  in   uint, see ParticleTags.hlsl, in the order of the kernel's particles
#ifndef RILL_PHASE_MASS_INCLUDED
#define RILL_PHASE_MASS_INCLUDED

#ifdef RILL_MATERIALS

#include "../../Generated/Phases.hlsl"
#include "../../Generated/ParticleTags.hlsl"

StructuredBuffer<uint> _Tags;

float4 PhaseRow(uint i)
{
    return _Phases[min(_Tags[i] >> kTagPhaseShift, kMaxPhase)];
}

float RelativeMass(uint i)
{
    return PhaseRow(i).x;
}

float InverseMass(uint i)
{
    return PhaseRow(i).y;
}

// Friction and cohesion of a particle, see GrainFriction.compute; both 0 for a liquid.
float2 GrainRow(uint i)
{
    return _Walls[min(_Tags[i] >> kTagPhaseShift, kMaxPhase)].yz;
}

// Whether two particles are of materials that mix.
bool AreMixing(uint i, uint j)
{
    return ((uint)PhaseRow(i).w >> (_Tags[j] >> kTagPhaseShift) & 1) != 0;
}

// Viscosity with which a particle is braked by a wall, over its mass.
float OwnViscosity(uint i)
{
    float4 row = PhaseRow(i);
    return row.z * row.y;
}

// Viscosity with which another particle brakes it, over its mass: layers of both that shear in series, as at an interface.
float PairViscosity(uint i, uint j)
{
    float4 row = PhaseRow(i);
    float other = PhaseRow(j).z;
    return 2.0 * row.z * other / max(row.z + other, 1e-12) * row.y;
}

#else

float OwnViscosity(uint i)
{
    return 1.0;
}

float PairViscosity(uint i, uint j)
{
    return 1.0;
}

float RelativeMass(uint i)
{
    return 1.0;
}

float InverseMass(uint i)
{
    return 1.0;
}

#endif

// Mass with which two particles resist what pushes them apart, twice the reduced one: 1 for a pair of equals of mass 1.
float PairMass(uint i, uint j)
{
    float own = RelativeMass(i);
    float other = RelativeMass(j);
    return 2.0 * own * other / (own + other);
}

// Part of a difference between two particles that the first one gives up: 1 for equals, and momentum is kept.
float MassFraction(uint i, uint j)
{
    float other = RelativeMass(j);
    return 2.0 * other / (RelativeMass(i) + other);
}

#endif
