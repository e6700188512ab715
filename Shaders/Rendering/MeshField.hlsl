// The field from which the water's mesh was found: about the distance to its surface, d, above 0 in water, up to 2. Nodes lie in bricks of
// 4 x 4 x 4; where the surface is not near, a brick is one word.
//
//   _MeshTop     in  a word for each brick of the domain, x first: 0 all air, 1 all water, else 2 + its index in _MeshField
//   _MeshField   in  Texture3D, 5 x 5 x 5 texels a brick: its nodes and the first of those beyond; node i lies at (i - 0.5) _MeshCell
#ifndef RILL_MESH_FIELD_INCLUDED
#define RILL_MESH_FIELD_INCLUDED

#include "DrawnDomain.hlsl"
#include "MeshFieldTexel.hlsl"

StructuredBuffer<uint> _MeshTop;
Texture3D<float> _MeshField;
SamplerState rill_field_linear_clamp_sampler;
float _MeshCell;                // distance between nodes, d
float4 _MeshBricks;             // xyz
float4 _MeshFieldTexel;         // xyz: 1 / size of _MeshField

static const float kMeshFar = 2.0;          // what the field holds at most, d
static const float kMeshSafety = 0.85;      // of the distance that the field gives: it is not exact
static const float kMeshMinStep = 0.5;      // cells
static const uint kMeshSteps = 96, kMeshRefinements = 5;

uint MeshBrick(int3 brick)
{
    int3 size = int3(_MeshBricks.xyz);
    brick = clamp(brick, 0, size - 1);
    return _MeshTop[(brick.z * size.y + brick.y) * size.x + brick.x];
}

float UniformBrick(uint entry)
{
    return entry == 1 ? kMeshFar : -kMeshFar;
}

float MeshNode(int3 node)
{
    uint entry = MeshBrick(node >> 2);
    return entry < 2 ? UniformBrick(entry) : _MeshField.Load(int4(MeshFieldTexel(entry - 2) + (uint3(node) & 3), 0));
}

// The last node that lies in the domain, along each axis; the first is 1.
float3 LastMeshNode()
{
    return max(ceil(_DrawnDomainSize.xyz / _MeshCell + 0.5) - 1.0, 2.0);
}

// A point of the domain, d, in nodes; as if the field went on unchanged from the last node to the walls.
float3 InMeshNodes(float3 p)
{
    return clamp(p / _MeshCell + 0.5, 1.0, LastMeshNode());
}

// Between eight nodes, in whatever bricks they are.
float BetweenNodes(int3 low, float3 part)
{
    float4 near = float4(MeshNode(low), MeshNode(low + int3(1, 0, 0)), MeshNode(low + int3(0, 1, 0)), MeshNode(low + int3(1, 1, 0)));
    float4 far = float4(MeshNode(low + int3(0, 0, 1)), MeshNode(low + int3(1, 0, 1)), MeshNode(low + int3(0, 1, 1)), MeshNode(low + 1));
    float4 plane = lerp(near, far, part.z);
    float2 row = lerp(plane.xz, plane.yw, part.x);
    return lerp(row.x, row.y, part.y);
}

// At a point of the domain, d. isUniform: whether it lies between nodes of one brick that is all air or all water.
float MeshDistance(float3 p, out bool isUniform)
{
    float3 at = InMeshNodes(p);
    int3 low = int3(min(floor(at), LastMeshNode() - 1.0)), brick = low >> 2;
    uint entry = MeshBrick(brick);
    isUniform = entry < 2 && all((low & 3) < 3);
    float value = UniformBrick(entry);
    if (entry >= 2)
    {
        float3 texel = MeshFieldTexel(entry - 2) + (at - 4.0 * brick) + 0.5;
        value = _MeshField.SampleLevel(rill_field_linear_clamp_sampler, texel * _MeshFieldTexel.xyz, 0);
    }
    else if (!isUniform)
        value = BetweenNodes(low, at - low);
    return value;
}

float MeshDistance(float3 p)
{
    bool isUniform;
    return MeshDistance(p, isUniform);
}

// Returns the distance in full precision: filters resolve a position between two nodes to 1/256.
float PreciseMeshDistance(float3 p)
{
    float3 at = InMeshNodes(p);
    int3 low = int3(min(floor(at), LastMeshNode() - 1.0));
    return BetweenNodes(low, at - low);
}

// Unit normal out of the water, in the domain's frame. isPrecise: to far less than a degree.
float3 MeshNormal(float3 p, bool isPrecise)
{
    float h = 0.75 * _MeshCell;
    float3 uphill = 0.0;
    [loop]
    for (uint i = 0; i < 6; i++)
    {
        uint axis = i >> 1;
        float3 offset = float3(axis == 0, axis == 1, axis == 2) * ((i & 1) != 0 ? -h : h);
        uphill += offset * (isPrecise ? PreciseMeshDistance(p + offset) : MeshDistance(p + offset));
    }
    float squared = dot(uphill, uphill);
    return squared > 1e-12 ? -uphill * rsqrt(squared) : float3(0.0, 1.0, 0.0);
}

float3 MeshNormal(float3 p)
{
    return MeshNormal(p, false);
}

// Returns where a ray leaves the domain's box, d, and the wall there: its normal points out. For a point beyond it, the box ahead counts.
float BoxExit(float3 from, float3 along, out float3 wall)
{
    float3 safe = abs(along) > 1e-7 ? along : 1e-7;
    float3 reach = ((safe > 0.0 ? _DrawnDomainSize.xyz : 0.0) - from) / safe;
    float exit = min(reach.x, min(reach.y, reach.z));
    wall = reach.x <= exit ? float3(sign(safe.x), 0.0, 0.0) : reach.y <= exit ? float3(0.0, sign(safe.y), 0.0) : float3(0.0, 0.0, sign(safe.z));
    return max(exit, 0.0);
}

// Returns where a ray enters the domain's box, d: 0 inside; below 0 if it misses.
float BoxEntry(float3 from, float3 along)
{
    float3 safe = abs(along) > 1e-7 ? along : 1e-7;
    float3 a = -from / safe, b = (_DrawnDomainSize.xyz - from) / safe;
    float3 low = min(a, b), high = max(a, b);
    float entry = max(max(low.x, low.y), max(low.z, 0.0)), exit = min(high.x, min(high.y, high.z));
    return entry <= exit ? entry : -1.0;
}

// How far a ray goes between the nodes of the brick that it is in, d.
float BrickReach(float3 p, float3 along)
{
    float3 at = InMeshNodes(p), low = floor(at * 0.25) * 4.0;
    float3 safe = abs(along) > 1e-7 ? along : 1e-7;
    float3 reach = ((safe > 0.0 ? low + 3.0 : low) - at) / safe;
    return max(min(reach.x, min(reach.y, reach.z)), 0.0) * _MeshCell;
}

// Along a ray through water (side 1) or air (side -1), d, to where that ends, at most to `end`; the ray may begin a little on the other side.
// found: whether it ends before.
float MarchMesh(float3 from, float3 along, float side, float begin, float end, out bool found)
{
    float t = begin, low = begin, high = end, atLow = 0.0, atHigh = 0.0;
    bool isIn = false, isRefining = false, isDone = begin >= end;
    uint refined = 0;
    found = false;
    [loop]
    for (uint i = 0; i < kMeshSteps && !isDone; i++)
    {
        float3 p = from + along * t;
        bool isUniform;
        float value = side * MeshDistance(p, isUniform);
        bool isAcross = value <= 0.0;
        if (isAcross && (isIn || t - begin > 1.5 * _MeshCell))
        {
            high = t;
            atHigh = value;
            isDone = !isIn;
            isRefining = found = true;
        }
        else if (!isAcross)
        {
            isIn = true;
            low = t;
            atLow = value;
        }
        if (isRefining)
        {
            // By the secant, but never so near to an end that the other stays.
            float part = atLow / max(atLow - atHigh, 1e-6);
            isDone = isDone || refined == kMeshRefinements;
            t = isIn ? lerp(low, high, isDone ? saturate(part) : clamp(part, 0.1, 0.9)) : t;
            refined++;
        }
        else
        {
            isDone = t >= end;
            float step = max(value * kMeshSafety, kMeshMinStep * _MeshCell);
            if (isUniform && value > 0.0)
                step = max(step, BrickReach(p, along));
            t = min(t + step, end);
        }
    }
    return found ? t : end;
}

#endif
