// Random numbers of foam: from the seed, the id of the fluid's particle and the number of the step alone, so that a run repeats.
#ifndef RILL_FOAM_RANDOM_INCLUDED
#define RILL_FOAM_RANDOM_INCLUDED

#include "../../Gpu/Hash.hlsl"

uint _FoamSeed;

uint FoamHash(uint id, uint step)
{
    return Hash(_FoamSeed, id, step);
}

// Further numbers of the same hash.
uint FoamNext(inout uint hash)
{
    hash = Hash(hash + 0x9E3779B9u);
    return hash;
}

#endif
