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

// The eight values around a point: at the corners of a box from low to high, in which the point lies at part.
struct Corners
{
    uint3 low, high;
    float3 part;
};

// at: the point, where the values have whole numbers; last: the greatest of them.
Corners CornersAround(float3 at, float3 last)
{
    at = clamp(at, 0.0, last);
    Corners corners;
    corners.low = uint3(at);
    corners.high = min(corners.low + 1, uint3(last));
    corners.part = at - corners.low;
    return corners;
}

// Faces along an axis.
Corners FacesAround(uint axis, float3 g)
{
    return CornersAround(g - 0.5 + 0.5 * UnitAxis(axis), float3(_CoarseCounts) - 1.0 + UnitAxis(axis));
}

// Centers of cells.
Corners CellsAround(float3 g)
{
    return CornersAround(g - 0.5, float3(_CoarseCounts) - 1.0);
}

bool3 IsHighCorner(uint corner)
{
    return bool3((corner & 1) != 0, (corner & 2) != 0, (corner & 4) != 0);
}

uint3 CornerOf(Corners corners, uint corner)
{
    return IsHighCorner(corner) ? corners.high : corners.low;
}

float WeightOf(Corners corners, uint corner)
{
    float3 weights = IsHighCorner(corner) ? corners.part : 1.0 - corners.part;
    return weights.x * weights.y * weights.z;
}

#ifdef READS_FLOW
StructuredBuffer<float> _Flow;

float FlowAt(uint axis, float3 g)
{
    Corners faces = FacesAround(axis, g);
    uint3 low = faces.low, high = faces.high;
    float3 part = faces.part;
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
    Corners cells = CellsAround(g);
    float2 sum = 0.0;
    [unroll]
    for (uint corner = 0; corner < 8; corner++)
        sum += WeightOf(cells, corner) * AirAt(CornerOf(cells, corner));
    return sum;
}
#endif

#endif
