// The grid of smoke: the cells of a CoarseGrid, x first, with velocities at their faces (Harlow and Welch 1965) and air at their centers.
// Coordinates g are in cells, from the box's lowest corner.
//
//   _Flow    [3, nodes]     float, d/s: of axis a at the low face of node's cell; nodes are one more than cells along each axis
//   _Air     [2, cells]     float: kHeat, temperature above that of the fresh air, K; kDensity, extinction of light by smoke, 1/m
#ifndef RILL_SMOKE_GRID_INCLUDED
#define RILL_SMOKE_GRID_INCLUDED

#include "../../Generated/Smoke.hlsl"

static const uint kHeat = 0;
static const uint kDensity = 1;

uint3 NodeCounts()
{
    return _CoarseCounts + 1;
}

uint NodeTotal()
{
    uint3 counts = NodeCounts();
    return counts.x * counts.y * counts.z;
}

uint FaceIndex(uint axis, uint3 node)
{
    return axis * NodeTotal() + dot(node, CellStrides(NodeCounts()));
}

uint CellAt(uint3 coordinates)
{
    return dot(coordinates, CellStrides(_CoarseCounts));
}

float3 UnitAxis(uint axis)
{
    return float3(axis == 0, axis == 1, axis == 2);
}

// Center of the low face of a node's cell along an axis.
float3 FaceCenter(uint axis, uint3 node)
{
    return node + 0.5 - 0.5 * UnitAxis(axis);
}

// Whether a node's low face along an axis is one of the grid.
bool IsFace(uint axis, uint3 node)
{
    uint3 end = _CoarseCounts + uint3(UnitAxis(axis));
    return all(node < end);
}

// Whether smoke leaves freely through a side of the box.
bool IsOpenSide(uint axis, bool isHigh)
{
    return (_OpenSides >> (2 * axis + (isHigh ? 1 : 0)) & 1) != 0;
}

// Whether a point lies beyond an open side: the air there is fresh and at rest. If it came in as it flows inside, it would drive itself.
bool IsFresh(float3 g)
{
    bool isFresh = false;
    [unroll]
    for (uint axis = 0; axis < 3; axis++)
        isFresh = isFresh || g[axis] < 0.0 && IsOpenSide(axis, false) || g[axis] > float(_CoarseCounts[axis]) && IsOpenSide(axis, true);
    return isFresh;
}

#ifdef READS_FLOW
StructuredBuffer<float> _Flow;

float FlowAt(uint axis, float3 g)
{
    float3 at = clamp(g - 0.5 + 0.5 * UnitAxis(axis), 0.0, float3(_CoarseCounts) - 1.0 + UnitAxis(axis));
    uint3 low = uint3(at), high = min(low + 1, _CoarseCounts - 1 + uint3(UnitAxis(axis)));
    float3 part = at - low;
    float2 rows[2];
    [unroll]
    for (uint z = 0; z < 2; z++)
    {
        uint k = z == 0 ? low.z : high.z;
        float2 left = float2(_Flow[FaceIndex(axis, uint3(low.x, low.y, k))], _Flow[FaceIndex(axis, uint3(low.x, high.y, k))]);
        float2 right = float2(_Flow[FaceIndex(axis, uint3(high.x, low.y, k))], _Flow[FaceIndex(axis, uint3(high.x, high.y, k))]);
        rows[z] = lerp(left, right, part.x);
    }
    float2 plane = lerp(rows[0], rows[1], part.z);
    return lerp(plane.x, plane.y, part.y);
}

float3 FlowAt(float3 g)
{
    return float3(FlowAt(0, g), FlowAt(1, g), FlowAt(2, g));
}

// Velocity at a cell's center, d/s.
float3 CellFlow(uint3 cell)
{
    float3 flow = 0.0;
    [unroll]
    for (uint axis = 0; axis < 3; axis++)
        flow += UnitAxis(axis) * (0.5 * (_Flow[FaceIndex(axis, cell)] + _Flow[FaceIndex(axis, cell + uint3(UnitAxis(axis)))]));
    return flow;
}
#endif

#ifdef READS_AIR
StructuredBuffer<float> _Air;

float2 AirAt(uint3 cell)
{
    uint at = CellAt(cell);
    return float2(_Air[kHeat * _CoarseTotal + at], _Air[kDensity * _CoarseTotal + at]);
}

// Temperature and smoke at a point; beyond an open side the air is fresh.
float2 AirAt(float3 g)
{
    if (IsFresh(g))
        return 0.0;
    float3 at = clamp(g - 0.5, 0.0, float3(_CoarseCounts) - 1.0);
    uint3 low = uint3(at), high = min(low + 1, _CoarseCounts - 1);
    float3 part = at - low;
    float2 sum = 0.0;
    [unroll]
    for (uint corner = 0; corner < 8; corner++)
    {
        bool3 isHigh = bool3((corner & 1) != 0, (corner & 2) != 0, (corner & 4) != 0);
        float3 weights = isHigh ? part : 1.0 - part;
        sum += weights.x * weights.y * weights.z * AirAt(isHigh ? high : low);
    }
    return sum;
}
#endif

#endif
