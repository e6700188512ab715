// The fluid's box as it is drawn, and the time of the frame.
#ifndef RILL_DRAWN_DOMAIN_INCLUDED
#define RILL_DRAWN_DOMAIN_INCLUDED

float4x4 _DomainToWorld;        // from the domain's frame in d to world, meters
float4x4 _WorldToDomain;
float4 _DrawnDomainSize;        // xyz, d
float4 _FrameLag;               // x: time of this frame since the newest state, substeps

// Particle spacing, m.
float Spacing()
{
    return length(float3(_DomainToWorld[0].x, _DomainToWorld[1].x, _DomainToWorld[2].x));
}

#endif
