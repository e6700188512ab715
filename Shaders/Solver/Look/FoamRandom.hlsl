// Random numbers of foam: from the seed, the id of the fluid's particle and the number of the step alone, so that a run repeats.
#ifndef RILL_FOAM_RANDOM_INCLUDED
#define RILL_FOAM_RANDOM_INCLUDED

uint _FoamSeed;

uint FoamMix(uint x)
{
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    x ^= x >> 16;
    return x;
}

uint FoamHash(uint id, uint step)
{
    return FoamMix(_FoamSeed ^ FoamMix(id ^ FoamMix(step + 0x9E3779B9u)));
}

// Further numbers of the same hash.
uint FoamNext(inout uint hash)
{
    hash = FoamMix(hash + 0x9E3779B9u);
    return hash;
}

// From 0 to below 1.
float FoamUnit(uint hash)
{
    return (hash >> 8) * (1.0 / 16777216.0);
}

#endif
