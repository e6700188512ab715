// Marks the tiles of a camera's picture in which there is something to draw, by groups of threads that each lie in one tile, and lists them, so that
// draws cover no more than those. See WaterTiles.cs.
//
//   _TileMarks   out  uint, [tiles] for the water, then [tiles] for its spray, x first: 1 where a tile shows some of it in any eye
#ifndef RILL_TILE_MARKS_INCLUDED
#define RILL_TILE_MARKS_INCLUDED

#include "TileGrid.hlsl"

RWStructuredBuffer<uint> _TileMarks;

groupshared uint groupShows;

// By all threads of a group. shows: whether there is something in the thread's texel; tile: of the group; list: 0 for the water, 1 for its spray.
void MarkTile(bool shows, uint2 tile, uint list, uint thread)
{
    if (thread == 0)
        groupShows = 0;
    GroupMemoryBarrierWithGroupSync();
    if (shows)
        InterlockedOr(groupShows, 1u);
    GroupMemoryBarrierWithGroupSync();
    uint2 tiles = TilesOnPicture();
    if (thread == 0 && groupShows != 0)
        _TileMarks[(list * tiles.y + tile.y) * tiles.x + tile.x] = 1;
}

#endif
