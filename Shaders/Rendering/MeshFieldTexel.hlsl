// Positions of bricks in the texture of the field from which the water's mesh was found, for writers and readers. Includes nothing of
// Unity's.
#ifndef RILL_MESH_FIELD_TEXEL_INCLUDED
#define RILL_MESH_FIELD_TEXEL_INCLUDED

#include "../Generated/SurfaceMesh.hlsl"

// A brick holds its nodes and the first of the bricks beyond, so that a filtered fetch never needs two bricks.
uint3 MeshFieldTexel(uint brick)
{
    return (kBrick + 1) * uint3(brick % kFieldBricks, brick / kFieldBricks % kFieldBricks, brick / (kFieldBricks * kFieldBricks));
}

#endif
