// The pattern of holes in a shadow map by which water lets a part of the light through.
#ifndef RILL_SHADOW_PATTERN_INCLUDED
#define RILL_SHADOW_PATTERN_INCLUDED

// A 4 by 4 pattern of thresholds (Bayer 1973), between 0 and 1.
float Threshold(uint2 pixel)
{
    static const uint4 kRows[4] = { uint4(0, 8, 2, 10), uint4(12, 4, 14, 6), uint4(3, 11, 1, 9), uint4(15, 7, 13, 5) };
    uint4 row = kRows[pixel.y & 3];
    uint x = pixel.x & 3;
    return ((x == 0 ? row.x : x == 1 ? row.y : x == 2 ? row.z : row.w) + 0.5) / 16.0;
}

#endif
