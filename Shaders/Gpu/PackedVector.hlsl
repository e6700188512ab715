// A vector in 32 bits, for what a neighbor needs of a particle only roughly: three signed mantissas of 9 bits and a shared
// exponent of 5. A component is off by at most 1/256 of the largest one, from 2^-24 to 2^7.
#ifndef RILL_PACKED_VECTOR_INCLUDED
#define RILL_PACKED_VECTOR_INCLUDED

static const int kMinExponent = -24;
static const int kMaxExponent = 7;

uint PackVector(float3 v)
{
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    // Exponent of the power of two above the largest component; it counts from 127 in the bits of a float.
    int exponent = clamp(int(asuint(largest) >> 23) - 126, kMinExponent, kMaxExponent);
    int3 mantissas = int3(clamp(round(v * exp2(8 - exponent)), -255.0, 255.0));
    uint3 bits = uint3(mantissas) & 511u;
    return uint(exponent - kMinExponent) << 27 | bits.x << 18 | bits.y << 9 | bits.z;
}

float3 UnpackVector(uint packed)
{
    int3 mantissas = int3(uint3(packed << 5, packed << 14, packed << 23)) >> 23;
    return float3(mantissas) * exp2(int(packed >> 27) + kMinExponent - 8);
}

#endif
