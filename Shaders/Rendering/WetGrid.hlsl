// When water was last at each node of a grid over the fluid's box: see Wetness.compute. All in the domain's frame, d.
#ifndef RILL_WET_GRID_INCLUDED
#define RILL_WET_GRID_INCLUDED

float4 _WetGridSize;            // xyz: nodes along each axis; w: distance between them
float4 _WetGridOrigin;          // xyz: the first node, in the box's lowest corner or up to one distance beyond
float4 _WetGridShifted;         // xyz: how far what lies in it has been moved by all shifts

// Returns the index of a node.
uint WetNode(uint3 node)
{
    uint2 size = (uint2)_WetGridSize.xy;
    return (node.z * size.y + node.y) * size.x + node.x;
}

// Finds the lowest of the eight nodes around a point, and where it lies between them, 0 to 1. Beyond the grid it lies at its edge.
uint3 WetCell(float3 p, out float3 part)
{
    float3 last = _WetGridSize.xyz - 1.0, at = clamp((p - _WetGridOrigin.xyz) / _WetGridSize.w, 0.0, last), low = min(floor(at), last - 1.0);
    part = at - low;
    return (uint3)low;
}

// Returns a node's side of its cell.
uint3 WetCorner(uint corner)
{
    return uint3(corner & 1, corner >> 1 & 1, corner >> 2);
}

#endif
