// Ripples smaller than the particles, as slopes of the water's face: random vectors on a lattice that the flow carries along. There are two patterns
// at a time; each is carried for a while, fades, and comes back as another one, so that no flow draws it out for long (Max and Becker 1996). Water
// that stands still has none.
//
//   _Ripples    x largest slope, rms of each direction, 0 for none; y time of the frame in lives of a pattern; z life of a pattern, substeps;
//               w substeps in which water goes one spacing that has the highest ripples
//   _RippleUp   xyz up, in the domain's frame
#ifndef RILL_RIPPLES_INCLUDED
#define RILL_RIPPLES_INCLUDED

#include "../Gpu/Hash.hlsl"

float4 _Ripples;
float4 _RippleUp;

static const float kRippleLength = 1.1;         // of the longer of two octaves, d; the other has half of it
static const float kLongRipples = 0.8;          // slope of the longer one, so that the squares of both sum up to 1
static const float kRipplesBegin = 0.1;         // of the speed that has the highest
static const float kRipplesOnWalls = 0.3;       // height of those on water that stands upright
static const float kLostTexels = 3.0, kKeptTexels = 6.0;    // of a length: up to here ripples are roughness, from here on slopes

// Returns three random numbers from 0 to 1 for a corner of the lattice.
float3 RandomAt(int3 corner, uint pattern)
{
    uint hash = Hash(asuint(corner.x) * 73856093u ^ asuint(corner.y) * 19349663u ^ asuint(corner.z) * 83492791u, pattern);
    return float3(uint3(hash >> 20, hash >> 10, hash) & 1023u) / 1023.0;
}

// Returns the vector of a corner, whose components have a mean of 0 and a variance of 1.
float3 SlopeAt(int3 corner, uint pattern)
{
    return (RandomAt(corner, pattern) * 2.0 - 1.0) * 1.7320508;
}

// Returns that of any point, with the same mean and variance everywhere.
float3 SlopeBetween(float3 p, uint pattern)
{
    float3 low = floor(p), f = p - low;
    f = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    float3 sum = 0.0;
    float squares = 0.0;
    [loop]
    for (uint i = 0; i < 8; i++)
    {
        uint3 at = uint3(i, i >> 1, i >> 2) & 1u;
        float3 parts = at == 1u ? f : 1.0 - f;
        float weight = parts.x * parts.y * parts.z;
        sum += weight * SlopeAt(int3(low) + int3(at), pattern);
        squares += weight * weight;
    }
    return sum * rsqrt(squares);
}

// Slope of the water's face, in the domain's frame, across the normal. p: d; chord: displacement in the last substep, d; texel: its width there, d;
// lost: variance of each direction of what is too small for it.
float3 RippleSlope(float3 p, float3 normal, float3 chord, float texel, out float lost)
{
    float upright = lerp(kRipplesOnWalls, 1.0, abs(dot(normal, _RippleUp.xyz)));
    float height = _Ripples.x * smoothstep(kRipplesBegin, 1.0, length(chord) * _Ripples.w) * upright;
    float3 slope = 0.0;
    lost = 0.0;
    if (height > 0.0)
    {
        [loop]
        for (uint octave = 0; octave < 2; octave++)
        {
            float wavelength = kRippleLength * exp2(-float(octave)), own = octave == 0 ? kLongRipples : sqrt(1.0 - kLongRipples * kLongRipples);
            float kept = saturate((wavelength / texel - kLostTexels) / (kKeptTexels - kLostTexels));
            float3 both = 0.0;
            float squares = 0.0;
            [loop]
            for (uint i = 0; i < 2; i++)
            {
                float lives = _Ripples.y + 0.5 * i, age = frac(lives), weight = 1.0 - abs(2.0 * age - 1.0);
                both += weight * SlopeBetween((p - chord * (_Ripples.z * (age - 0.5))) / wavelength, uint(int(floor(lives))) * 4u + octave * 2u + i);
                squares += weight * weight;
            }
            slope += height * own * kept * both * rsqrt(squares);
            lost += height * height * own * own * (1.0 - kept * kept);
        }
    }
    return slope - normal * dot(slope, normal);
}

#endif
