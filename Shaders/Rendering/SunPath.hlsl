// How much water the light of the sun has passed. A map of it lies across the light, see WaterShadow.compute. All in the domain's frame, d.
#ifndef RILL_SUN_PATH_INCLUDED
#define RILL_SUN_PATH_INCLUDED

#include "MeshField.hlsl"

float4 _SunAxisX, _SunAxisY;        // (p, 1) times these: x and y in the map, texels
float4 _SunLight;                   // xyz: unit, towards the light; w 0 without a map
float4 _SunSize;                    // xy: texels

static const uint kMaxStretches = 6;

// x where light comes into water first, along the light from the domain's origin, and y how far it goes there; z, w the same of whatever water comes
// after that, w 0 where there is none.
float4 TraceSun(float3 from, float3 along)
{
    float4 path = 0.0;
    float3 wall;
    float t = 0.0, end = BoxExit(from, along, wall), origin = dot(from, along);
    float side = MeshDistance(from) > 0.0 ? 1.0 : -1.0;
    bool isDone = false;
    [loop]
    for (uint i = 0; i < 2 * kMaxStretches && !isDone; i++)
    {
        bool found;
        float reach = MarchMesh(from, along, side, t, end, found);
        if (side > 0.0)
        {
            if (path.y == 0.0)
                path.xy = float2(origin + t, reach - t);
            else
            {
                path.z = path.w == 0.0 ? origin + t : path.z;
                path.w += reach - t;
            }
        }
        isDone = !found;
        side = -side;
        t = reach;
    }
    return path;
}

#endif
