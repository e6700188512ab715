// Rotations as quaternions of length 1, xyzw.
#ifndef RILL_ROTATIONS_INCLUDED
#define RILL_ROTATIONS_INCLUDED

float3 Rotate(float4 q, float3 v)
{
    return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v);
}

float3 Unrotate(float4 q, float3 v)
{
    return Rotate(float4(-q.xyz, q.w), v);
}

#endif
