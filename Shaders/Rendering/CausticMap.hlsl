// The light of the sun that has come through the water's surface, in layers below it: Caustics.compute fills them, Water.hlsl reads them. All in
// the domain's frame, d. Includes nothing.
//
// A texel of the map is a bundle of parallel rays before the water: its axes lie across the light. Layers are planes across _CausticUp, evenly
// from the mean height of the surface down to the lowest corner of the domain. In a layer, a texel holds how much light crosses the plane there, 1
// as without water, and that times the path through water up to there. Layers lie beside each other, row by row; below them, the
// first texel holds how far the first layer is above the last.
#ifndef RILL_CAUSTIC_MAP_INCLUDED
#define RILL_CAUSTIC_MAP_INCLUDED

float4 _CausticAxisX, _CausticAxisY;    // (p, 1) times these: x and y in the map, texels
float4 _CausticLight;       // xyz: unit, towards the light; w: number of layers, 0 without a map
float4 _CausticUp;          // xyz: unit; w: height of the last layer
float4 _CausticSize;        // xy: of a layer, texels; z: layers in a row; w: rows

float2 InCausticMap(float3 p)
{
    return float2(dot(_CausticAxisX, float4(p, 1.0)), dot(_CausticAxisY, float4(p, 1.0)));
}

// First texel of a layer.
uint2 CausticCorner(uint layer)
{
    uint columns = (uint)_CausticSize.z;
    return uint2(layer % columns, layer / columns) * (uint2)_CausticSize.xy;
}

uint2 CausticRangeTexel()
{
    return uint2(0, (uint)_CausticSize.y * (uint)_CausticSize.w);
}

float CausticHeight(float3 p)
{
    return dot(_CausticUp.xyz, p) - _CausticUp.w;
}

// Height of a layer above the last.
float CausticLayerHeight(uint layer, float range)
{
    return range * (1.0 - layer / max(_CausticLight.w - 1.0, 1.0));
}

#endif
