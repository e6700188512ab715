// A particle of foam: spray in the air, foam on the water, a bubble in it. Made and moved by Foam.compute, drawn by what includes
// this. 32 bytes, in the domain's frame, lengths in d:
//
//   a.xyz  float bits, center at the newest state, d
//   a.w    float bits, age, s: foam ages with time, spray and bubbles a quarter as fast
//   b.xyz  float bits, velocity, d/s: drawn at a frame's time, its center is DrawnFoamPosition
//   b.w    bits 0-1 kind, 0 for none (nothing is to be drawn); 2-15 age at which it goes, in 1/64 s; 16-23 radius in 1/255 of
//          the largest; 24-31 a random number of its own, for its looks
//
// The buffer _FoamParticles has the particles in the order in which they came, without gaps. Its Arguments (Arguments.hlsl) tell
// how many: six vertices each, one instance in the first command and two in the third.
#ifndef RILL_FOAM_INCLUDED
#define RILL_FOAM_INCLUDED

#include "../Generated/Foam.hlsl"

static const float kFoamComes = 0.05;   // of its life, in which it appears
static const float kFoamGoes = 0.6;     // from which it fades

static const float kLifetimeUnit = 1.0 / 64.0;      // s
static const uint kMaxLifetime = 16383;             // units

uint FoamKind(FoamParticle particle)
{
    return particle.b.w & 3;
}

float3 FoamPosition(FoamParticle particle)
{
    return asfloat(particle.a.xyz);
}

float3 FoamVelocity(FoamParticle particle)
{
    return asfloat(particle.b.xyz);
}

// s
float FoamAge(FoamParticle particle)
{
    return asfloat(particle.a.w);
}

// s
float FoamLifetime(FoamParticle particle)
{
    return (particle.b.w >> 2 & 16383) * kLifetimeUnit;
}

// Fraction of the largest radius, 0 to 1.
float FoamSize(FoamParticle particle)
{
    return (particle.b.w >> 16 & 255) * (1.0 / 255.0);
}

// 0 to 1.
float FoamRandom(FoamParticle particle)
{
    return (particle.b.w >> 24) * (1.0 / 255.0);
}

// At a time after the newest state, s; the walls of the box end its path.
float3 DrawnFoamPosition(FoamParticle particle, float seconds, float3 domainSize)
{
    float3 position = FoamPosition(particle);
    return clamp(position + FoamVelocity(particle) * seconds, min(position, 0.0), max(position, domainSize));
}

// Radius of a particle if the largest has this radius.
float DrawnFoamRadius(FoamParticle particle, float largest)
{
    return largest * FoamSize(particle) * (FoamKind(particle) == kSpray ? 0.7 : 1.0);
}

// At its center, where it is that of a particle halfway through its life.
float DrawnFoamOpacity(FoamParticle particle, float opacity)
{
    float life = saturate(FoamAge(particle) / max(FoamLifetime(particle), 1e-3));
    return opacity * saturate(life / kFoamComes) * saturate((1.0 - life) / (1.0 - kFoamGoes));
}

// How much foam covers at a point, of whose surroundings it covers so much. rank: of the point, evenly spread over 0 to 1 among all; soft: how soft
// edges are, of what covers.
float CoveredByRank(float covered, float rank, float soft)
{
    soft = max(min(min(soft, covered), 1.0 - covered), 1e-3);
    return saturate((rank - (1.0 - covered)) / (2.0 * soft) + 0.5);
}

FoamParticle PackFoam(float3 position, float3 velocity, uint kind, float age, uint rest)
{
    FoamParticle particle;
    particle.a = uint4(asuint(position), asuint(age));
    particle.b = uint4(asuint(velocity), (rest & ~3u) | kind);
    return particle;
}

// Packs what is constant for its life, for PackFoam: lifetime in s; size and random from 0 to 1.
uint PackFoamRest(float lifetime, float size, float random)
{
    uint units = min(uint(lifetime / kLifetimeUnit + 0.5), kMaxLifetime);
    return units << 2 | uint(saturate(size) * 255.0 + 0.5) << 16 | uint(saturate(random) * 255.0 + 0.5) << 24;
}

#endif
