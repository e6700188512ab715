// Filters by hand, as a linear sampler that clamps does: for textures of 32-bit floats, which Metal, WebGPU and many Androids do not
// filter. Includes nothing.
#ifndef RILL_FILTERING_INCLUDED
#define RILL_FILTERING_INCLUDED

// place: 0 to 1 over the texture.
float LoadTrilinear(Texture3D<float> field, float3 position)
{
    uint3 size;
    field.GetDimensions(size.x, size.y, size.z);
    float3 at = clamp(position * size - 0.5, 0.0, size - 1.0);
    int3 a = int3(at), b = min(a + 1, int3(size) - 1);
    float3 part = at - a;
    float4 row = lerp(
        float4(field.Load(int4(a, 0)), field.Load(int4(a.x, b.y, a.z, 0)), field.Load(int4(a.xy, b.z, 0)), field.Load(int4(a.x, b.yz, 0))),
        float4(field.Load(int4(b.x, a.yz, 0)), field.Load(int4(b.xy, a.z, 0)), field.Load(int4(b.x, a.y, b.z, 0)), field.Load(int4(b, 0))), part.x);
    float2 plane = lerp(row.xz, row.yw, part.y);
    return lerp(plane.x, plane.y, part.z);
}

#endif
