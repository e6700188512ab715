// Bins: which colliders come near a cell of a few spacings within the substep. Include after Solver.hlsl and Colliders.hlsl.
#ifndef RILL_COLLIDER_BINS_INCLUDED
#define RILL_COLLIDER_BINS_INCLUDED

StructuredBuffer<uint> _ColliderMasks;      // [cells * words], a bit for each collider

// d: no further than this from where no collider is near, none is met; = what bins reach, less kContactOffset
static const float kBroadphaseMargin = 2.0;

uint ColliderCell(float3 p)
{
    uint3 cell = min(uint3(max(p * _InverseColliderCellSize, 0.0)), _ColliderCells - 1);
    return ((cell.z * _ColliderCells.y + cell.y) * _ColliderCells.x + cell.x) * _ColliderWords;
}

// Visits the colliders near a cell that ColliderCell gave, by their index, up to END_COLLIDERS.
#define FOR_COLLIDERS(cell, index) \
    for (uint word = 0; word < _ColliderWords; word++) \
    { \
        for (uint bits = _ColliderMasks[cell + word]; bits != 0; bits &= bits - 1) \
        { \
            uint index = word * 32 + firstbitlow(bits);

// Loops over the colliders near any of 'samples' points, at least two, from the start to the end of a path.
#define FOR_COLLIDERS_ALONG(start, path, samples, index) \
    for (uint word = 0; word < _ColliderWords; word++) \
    { \
        uint near = 0; \
        for (uint part = 0; part < samples; part++) \
            near |= _ColliderMasks[ColliderCell(start + path * (part / (samples - 1.0))) + word]; \
        for (uint bits = near; bits != 0; bits &= bits - 1) \
        { \
            uint index = word * 32 + firstbitlow(bits);

#define END_COLLIDERS } }

// Whether a collider comes near the cell of p within the substep. Most water is far from all of them and is done with this.
bool IsNear(float3 p)
{
    uint cell = ColliderCell(p);
    uint bits = 0;
    for (uint word = 0; word < _ColliderWords; word++)
        bits |= _ColliderMasks[cell + word];
    return bits != 0;
}

// Whether a collider comes near a path.
bool MayHit(float3 from, float3 to)
{
    float3 path = to - from;
    uint parts = uint(length(path) / (2.0 * kBroadphaseMargin)) + 1;
    bool isNear = false;
    for (uint part = 0; part <= parts && !isNear; part++)
        isNear = IsNear(from + path * (part / float(parts)));
    return isNear;
}

#endif
