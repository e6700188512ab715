// Whether a collider is near a place: a bit for each one that comes near a cell within the substep. Include after Colliders.hlsl.
#ifndef RILL_COLLIDER_MASKS_INCLUDED
#define RILL_COLLIDER_MASKS_INCLUDED

StructuredBuffer<uint> _ColliderMasks;      // [cells * words], see ColliderCell

static const float kFar = 1.0;              // an inset that no particle has to keep
static const float kUnhinderedWay = 2.0;    // d: a way no longer than this, from where no collider is near, meets none; = what bins reach, less kWallInset

// Cells to look into along a way.
uint PlacesAlong(float3 way)
{
    return uint(length(way) * _InverseColliderCellSize) + 2;
}

// Bits of the colliders that come near a way from a.
uint NearWay(float3 a, float3 way, uint places, uint word)
{
    uint bits = 0;
    for (uint place = 0; place < places; place++)
        bits |= _ColliderMasks[ColliderCell(a + way * (place / (places - 1.0))) + word];
    return bits;
}

bool IsNear(float3 p)
{
    uint cell = ColliderCell(p);
    uint bits = 0;
    for (uint word = 0; word < _ColliderWords; word++)
        bits |= _ColliderMasks[cell + word];
    return bits != 0;
}

bool IsNearWay(float3 a, float3 way)
{
    uint places = PlacesAlong(way);
    uint bits = 0;
    for (uint word = 0; word < _ColliderWords; word++)
        bits |= NearWay(a, way, places, word);
    return bits != 0;
}

#endif
