// How far solid obstacles close the faces and fill the cells of the coarse grid, and how they move there. Include after
// CoarseGrid.hlsl. Without SOLIDS all is open, and nothing is read.
#ifndef RILL_COARSE_SOLIDS_INCLUDED
#define RILL_COARSE_SOLIDS_INCLUDED

static const uint kRays = 4;                // through a face: its open share is a number of quarters
static const float kLeastOpen = 0.25;       // share of a cell's volume: in less there is no room for a layer of particles, and it is solid

#ifdef SOLIDS

StructuredBuffer<uint> _OpenShares;         // [cells], see PackOpen
StructuredBuffer<float4> _SolidFlow;        // [cells], xyz displacement of the solid at the cell's low faces along their axes, d; w see PackNormal

uint OpenBits(uint cell)
{
    return _OpenShares[cell];
}

float4 SolidFlow(uint cell)
{
    return _SolidFlow[cell];
}

#else

uint OpenBits(uint cell)
{
    return 0xFFu | kRays << 8 | kRays << 11 | kRays << 14;
}

float4 SolidFlow(uint cell)
{
    return 0.0;
}

#endif

// Rays through the low faces that are open, the open share of the cell's volume, and the collider nearest to it, in one word.
uint PackOpen(uint3 rays, float volume, uint owner)
{
    return uint(saturate(volume) * 255.0 + 0.5) | rays.x << 8 | rays.y << 11 | rays.z << 14 | (owner & 0x1FFu) << 17;
}

// A direction as a whole number below 2^24, which a float holds exactly: its octahedron unfolded to a square of 4095 x 4095 steps. 0 for none.
float PackNormal(float3 n)
{
    float size = dot(abs(n), 1.0);
    if (size == 0.0)
        return 0.0;
    float2 square = n.xy / size;
    if (n.z < 0.0)
        square = (1.0 - abs(square.yx)) * (square >= 0.0 ? 1.0 : -1.0);
    float2 steps = floor(saturate(0.5 * square + 0.5) * 4094.0 + 0.5);
    return 1.0 + steps.x + 4095.0 * steps.y;
}

float3 UnpackNormal(float packed)
{
    float row = floor((packed - 1.0) / 4095.0);
    float2 square = float2(packed - 1.0 - 4095.0 * row, row) / 2047.0 - 1.0;
    float3 n = float3(square, 1.0 - dot(abs(square), 1.0));
    if (n.z < 0.0)
        n.xy = (1.0 - abs(n.yx)) * (n.xy >= 0.0 ? 1.0 : -1.0);
    return packed > 0.0 ? normalize(n) : 0.0;
}

// The collider nearest to a cell that is not all open, from its word.
uint SolidOwner(uint bits)
{
    return bits >> 17;
}

// Open share of a cell's low face along an axis, from its word.
float OpenFace(uint bits, uint axis)
{
    return (bits >> (8 + 3 * axis) & 7u) * (1.0 / kRays);
}

float OpenVolume(uint bits)
{
    return (bits & 255u) * (1.0 / 255.0);
}

#endif
