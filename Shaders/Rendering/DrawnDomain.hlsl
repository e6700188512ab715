// The fluid's box as it is drawn.
#ifndef RILL_DRAWN_DOMAIN_INCLUDED
#define RILL_DRAWN_DOMAIN_INCLUDED

float4x4 _DomainToWorld;        // from the domain's frame in d to world, meters
float4x4 _WorldToDomain;
float4 _DrawnDomainSize;        // xyz, d

#endif
