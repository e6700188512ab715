// Rectangles over the tiles of a camera's picture that show the water or its spray. Include after View.hlsl and SurfaceView.hlsl.
//
//   _WaterTiles   in  uint, tiles that show water, as many places as there are tiles; then those that show spray
#ifndef RILL_WATER_TILE_INCLUDED
#define RILL_WATER_TILE_INCLUDED

#include "SurfaceRectangle.hlsl"
#include "TileGrid.hlsl"

StructuredBuffer<uint> _WaterTiles;

SurfaceVaryings VertexOfTile(uint vertex, uint instance, uint list)
{
    uint2 tiles = TilesOnPicture();
    uint tile = _WaterTiles[list * tiles.x * tiles.y + vertex / 6];
    // Tiles side by side have exactly the same corners.
    float2 corner = RectangleCorner(vertex, 0.0, 1.0) + float2(tile % max(tiles.x, 1u), tile / max(tiles.x, 1u));
    float2 picture = (corner * kTile + _FoamWindow.xy) * _FoamSize.zw * 2.0 - 1.0;
    return SurfaceCorner(clamp(picture, _PictureBounds.xy, _PictureBounds.zw), instance);
}

SurfaceVaryings WaterVertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
{
    return VertexOfTile(vertex, instance, 0);
}

SurfaceVaryings SprayVertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
{
    return VertexOfTile(vertex, instance, 1);
}

#endif
