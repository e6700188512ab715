// Random bits of whole numbers, the same on every device.
#ifndef RILL_HASH_INCLUDED
#define RILL_HASH_INCLUDED

// "lowbias32" of Wellons 2018, "Prospecting for Hash Functions".
uint Hash(uint x)
{
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    x ^= x >> 16;
    return x;
}

uint Hash(uint a, uint b)
{
    return Hash(a ^ Hash(b + 0x9E3779B9u));
}

uint Hash(uint a, uint b, uint c)
{
    return Hash(a ^ Hash(b, c));
}

// From 0 to below 1.
float UnitFloat(uint hash)
{
    return (hash >> 8) * (1.0 / 16777216.0);
}

// Returns a unit vector, each direction as likely as any. first, second: hashes.
float3 UnitVector(uint first, uint second)
{
    float z = 2.0 * UnitFloat(first) - 1.0, angle = 6.2831853 * UnitFloat(second), ring = sqrt(max(1.0 - z * z, 0.0));
    return float3(ring * cos(angle), ring * sin(angle), z);
}

#endif
