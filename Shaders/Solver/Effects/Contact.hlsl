// The nearest collider of each particle, as the surface reads it. Include Solver.hlsl and SurfaceParticle.hlsl first, and declare
// _Workspace. After the two lists of planes there, each as long as the capacity, each particle has
//   uint2: x the collider's normal at the particle, see PackNormal; y float bits of its distance, at most kContactReach
#ifndef RILL_CONTACT_INCLUDED
#define RILL_CONTACT_INCLUDED

static const float kContactReach = 1.6;     // d: what is further away mirrors no neighbor

// byte in _Workspace
uint ContactAt(uint i)
{
    return kPlaneBytes * (2 * _Capacity + i);
}

// xyz normal, w distance
float4 ContactOf(uint i)
{
    uint2 contact = _Workspace.Load2(ContactAt(i));
    return float4(UnpackNormal(contact.x), asfloat(contact.y));
}

#endif
