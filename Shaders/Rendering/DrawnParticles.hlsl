// Positions at which particles are drawn: at the time of the frame, which lies between fixed steps. A particle goes on along the chord of the
// last substep, for the time by which the newest state lags the frame. (Its velocity would be another path once viscosity
// has acted on it.) The path ends at the walls of the domain. Lengths in d, in the domain's frame.
//
//   _Positions       [kAlive]  in   float4, xyz position, d
//   _StartPositions  [kMoved]  in   float4, xyz position at the start of the last substep, d
//   _Velocities      [kAlive]  in   float4, xyz velocity, d/s; w density relative to rest
//   _Counters        [kCounterCount] in   uint, see Generated/Counters.hlsl
#ifndef RILL_DRAWN_PARTICLES_INCLUDED
#define RILL_DRAWN_PARTICLES_INCLUDED

#include "../Generated/Counters.hlsl"

static const float kWallDistance = 0.5;     // of a particle's center, as in the solver

StructuredBuffer<float4> _Positions;
StructuredBuffer<float4> _StartPositions;
StructuredBuffer<float4> _Velocities;
StructuredBuffer<uint> _Counters;

float4 _FrameLag;               // time of this frame, x, and of the frame before, z, since the newest state in substeps; y, w the same in s
float4 _DrawnDomainSize;        // xyz, d

// substeps, seconds: the same time since the newest state, in substeps and in s.
float3 PositionAfter(uint i, float substeps, float seconds)
{
    float3 position = _Positions[i].xyz;
    if (seconds == 0.0)
        return position;
    // Particles that were added since the last step have no chord yet.
    float3 path = i < _Counters[kMoved] ? (position - _StartPositions[i].xyz) * substeps : _Velocities[i].xyz * seconds;
    return clamp(position + path, min(position, kWallDistance), max(position, _DrawnDomainSize.xyz - kWallDistance));
}

// At the time of this frame.
float3 DrawnPosition(uint i)
{
    return PositionAfter(i, _FrameLag.x, _FrameLag.y);
}

// At the time of the frame before, along the same chord: what motion vectors need.
float3 LastDrawnPosition(uint i)
{
    return PositionAfter(i, _FrameLag.z, _FrameLag.w);
}

#endif
