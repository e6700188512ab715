// Density that colliders add to a sorted particle. Include after Solver.hlsl.
#ifndef RILL_COLLIDER_DENSITY_INCLUDED
#define RILL_COLLIDER_DENSITY_INCLUDED

StructuredBuffer<float4> _Boundary;     // [kSorted], see Colliders.compute
StructuredBuffer<float> _ContactOffsets;        // [kSorted]

void AddColliders(uint i, inout float density, inout float3 gradient)
{
    if (_ContactOffsets[i] != kFar)
        AddBoundary(_Boundary[i], density, gradient);
}

#endif
