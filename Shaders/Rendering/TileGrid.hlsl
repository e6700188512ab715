// The grid of tiles over a camera's picture, see WaterTiles.cs. Include after SurfaceView.hlsl.
#ifndef RILL_TILE_GRID_INCLUDED
#define RILL_TILE_GRID_INCLUDED

#include "../Generated/WaterTiles.hlsl"

uint2 TilesOnPicture()
{
    return (uint2(_FoamWindow.zw) + kTile - 1) / kTile;
}

#endif
