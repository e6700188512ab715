// How far solid colliders close the faces and fill the cells of the coarse grid, and how they move there. Include after
// CoarseGrid.hlsl. Without WITH_COLLIDERS all is open, and nothing is read.
#ifndef RILL_COARSE_COLLIDERS_INCLUDED
#define RILL_COARSE_COLLIDERS_INCLUDED

static const float kMinOpen = 0.25;       // of a cell's volume: less has no room for a layer of particles
static const float kFaceSteps = 1023.0;     // of the open fraction of a face
static const float kCenterSteps = 1022.0;   // even: 0 is one of them
static const float kVolumeSteps = 4095.0;
static const uint kRoomy = 6;               // links of a cell, see PackOpen
static const uint kSolid = 7;

#ifdef WITH_COLLIDERS

StructuredBuffer<uint2> _OpenFractions;        // [cells], see PackFaces and PackOpen
StructuredBuffer<uint4> _OpenCenters;       // [cells], see PackCenter: x of what is open of the cell, yzw of what is open of its low faces
StructuredBuffer<float4> _ColliderFlow;        // [cells], xyz displacement of the solid at the cell's low faces along their axes, d

uint2 OpenBits(uint cell)
{
    return _OpenFractions[cell];
}

float3 ColliderFlow(uint cell)
{
    return _ColliderFlow[cell].xyz;
}

#else

uint2 OpenBits(uint cell)
{
    return uint2(0x3FFFFFFFu, 0xFFFu | kRoomy << 21 | 1u << 24);
}

float3 ColliderFlow(uint cell)
{
    return 0.0;
}

#endif

// Open fractions of a cell's low faces, in one word.
uint PackFaces(float3 open)
{
    uint3 steps = uint3(saturate(open) * kFaceSteps + 0.5);
    return steps.x | steps.y << 10 | steps.z << 20;
}

// Center of what is open, from that of the cell or the face, in sides of the cell.
uint PackCenter(float3 offset)
{
    uint3 steps = uint3(clamp(offset, -0.5, 0.5) * kCenterSteps + (0.5 * kCenterSteps + 0.5));
    return steps.x | steps.y << 10 | steps.z << 20;
}

float3 UnpackCenter(uint packed)
{
    return (float3(packed & 1023u, packed >> 10 & 1023u, packed >> 20 & 1023u) - 0.5 * kCenterSteps) / kCenterSteps;
}

// The open fraction of a cell's volume, the collider nearest to it and its link, in one word. A link is kRoomy for a cell with room for
// water of its own; in less, 2 axis + 1 towards the next cell and 2 axis towards the one before, with whose water it is filled and
// moves; kSolid where there is none. See IsClear and HasSurface.
uint PackOpen(float volume, uint owner, uint link, bool clear, bool surface)
{
    return uint(saturate(volume) * kVolumeSteps + 0.5) | (owner & 0x1FFu) << 12 | link << 21 | (clear ? 1u << 24 : 0u) | (surface ? 1u << 25 : 0u);
}

// The second word of a cell, which is clear only where what else counts is so too.
uint ClearIf(uint word, bool other)
{
    return other ? word : word & ~(1u << 24);
}

// The collider nearest to a cell that is not all open, from its words.
uint OwnerOf(uint2 bits)
{
    return bits.y >> 12 & 0x1FFu;
}

uint CellLink(uint2 bits)
{
    return bits.y >> 21 & 7u;
}

// Whether no solid reaches into a cell or those beside it.
bool IsClear(uint2 bits)
{
    return (bits.y >> 24 & 1u) != 0;
}

// Whether the solids in a cell have one surface, or at least one side.
bool HasSurface(uint2 bits)
{
    return bits.y >> 25 != 0;
}

// Open fraction of a cell's low face along an axis, from its words or their first.
float OpenFace(uint faces, uint axis)
{
    return (faces >> (10 * axis) & 1023u) * (1.0 / kFaceSteps);
}

float OpenFace(uint2 bits, uint axis)
{
    return OpenFace(bits.x, axis);
}

float OpenVolume(uint2 bits)
{
    return (bits.y & 4095u) * (1.0 / kVolumeSteps);
}

// From a cell to the one whose water fills it, in cells.
float3 RoomStep(uint2 bits)
{
    uint link = CellLink(bits);
    float3 step = float3(link >> 1 == 0, link >> 1 == 1, link >> 1 == 2);
    return link < kRoomy ? ((link & 1) != 0 ? step : -step) : 0.0;
}

// The cell whose water fills a cell: itself, or where it has no room the one that it is linked to.
uint RoomCell(uint cell)
{
#ifdef WITH_COLLIDERS
    uint link = CellLink(OpenBits(cell));
    if (link < kRoomy)
    {
        uint stride = CellStrides(_CoarseCounts)[link >> 1];
        cell = (link & 1) != 0 ? cell + stride : cell - stride;
    }
#endif
    return cell;
}

#endif
