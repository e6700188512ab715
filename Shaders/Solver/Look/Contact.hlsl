// Where the nearest collider is, for each particle, as the surface reads it. Include SurfaceParticle.hlsl first.
//
//   _Contacts   [kMoved]  uint2: x the collider's normal at the particle, see PackNormal; y float bits of its distance, at most kContactReach
#ifndef RILL_CONTACT_INCLUDED
#define RILL_CONTACT_INCLUDED

static const float kContactReach = 1.6;     // d: what is further away mirrors no neighbor

#ifdef FIND_CONTACTS
RWStructuredBuffer<uint2> _Contacts;
#else
StructuredBuffer<uint2> _Contacts;
#endif

// xyz normal, w distance
float4 UnpackContact(uint2 contact)
{
    return float4(UnpackNormal(contact.x), asfloat(contact.y));
}

#endif
