// How far solid obstacles close the faces and fill the cells of the coarse grid, and how they move there. Include after
// CoarseGrid.hlsl. Without SOLIDS all is open, and nothing is read.
#ifndef RILL_COARSE_SOLIDS_INCLUDED
#define RILL_COARSE_SOLIDS_INCLUDED

static const uint kRays = 4;                // through a face: its open share is a number of quarters
static const float kLeastOpen = 0.25;       // share of a cell's volume: in less there is no room for a layer of particles, and it is solid

#ifdef SOLIDS

StructuredBuffer<uint> _OpenShares;         // [cells], see PackOpen
StructuredBuffer<float4> _SolidFlow;        // [cells], xyz displacement of the solid at the cell's low faces along their axes, d
StructuredBuffer<float4> _SolidSurfaces;    // [cells], xyz normal of the solid in the cell, 0 for none; w displacement of the solid along it, d

uint OpenBits(uint cell)
{
    return _OpenShares[cell];
}

float3 SolidFlow(uint cell)
{
    return _SolidFlow[cell].xyz;
}

#else

uint OpenBits(uint cell)
{
    return 0xFFu | kRays << 8 | kRays << 11 | kRays << 14;
}

float3 SolidFlow(uint cell)
{
    return 0.0;
}

#endif

// Rays through the low faces that are open, the open share of the cell's volume, and the collider nearest to it, in one word.
uint PackOpen(uint3 rays, float volume, uint owner)
{
    return uint(saturate(volume) * 255.0 + 0.5) | rays.x << 8 | rays.y << 11 | rays.z << 14 | (owner & 0x1FFu) << 17;
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
