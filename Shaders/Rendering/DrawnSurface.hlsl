// The ellipsoids of the water's surface at the time of the frame, in the world: they go on along their chords, as the particles of
// DrawnParticles.hlsl do.
//
//   _SurfaceParticles  in  see SurfaceParticle.hlsl
#ifndef RILL_DRAWN_SURFACE_INCLUDED
#define RILL_DRAWN_SURFACE_INCLUDED

#include "Ellipsoid.hlsl"
#include "SurfaceParticle.hlsl"

StructuredBuffer<SurfaceParticle> _SurfaceParticles;

float4x4 _DomainToWorld;        // from the domain's frame in d to world, meters
float4 _FrameLag;               // x: time of this frame since the newest state, substeps
float4 _DrawnDomainSize;        // xyz, d

// chord: displacement in the last substep, d, in the domain's frame.
Ellipsoid DrawnEllipsoid(uint i, out float3 chord)
{
    float3 center;
    float3x3 axes;
    uint index;
    UnpackSurface(_SurfaceParticles[i], center, axes, index, chord);
    center = clamp(center + chord * _FrameLag.x, min(center, 0.0), max(center, _DrawnDomainSize.xyz));
    Ellipsoid e;
    e.center = mul(_DomainToWorld, float4(center, 1.0)).xyz;
    e.a = mul((float3x3)_DomainToWorld, axes[0]);
    e.b = mul((float3x3)_DomainToWorld, axes[1]);
    e.c = mul((float3x3)_DomainToWorld, axes[2]);
    return e;
}

Ellipsoid DrawnEllipsoid(uint i)
{
    float3 chord;
    return DrawnEllipsoid(i, chord);
}

#endif
