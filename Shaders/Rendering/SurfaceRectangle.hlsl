// One rectangle over what the water's box covers on the picture, for passes that read the surface's textures. Include after View.hlsl
// and SurfaceView.hlsl.
#ifndef RILL_SURFACE_RECTANGLE_INCLUDED
#define RILL_SURFACE_RECTANGLE_INCLUDED

struct SurfaceVaryings
{
    float4 clip : SV_Position;
    float4 picture : TEXCOORD0;     // xy
    RILL_VIEW_OUTPUT
};

SurfaceVaryings SurfaceCorner(float2 picture, uint instance)
{
    SurfaceVaryings result = (SurfaceVaryings)0;
    bool drawn = SelectView(instance);
    PassViewOn(result);
    result.clip = kNowhere;
    if (!drawn)
        return result;

    // Through a point of the world: whatever side the pipeline calls up, and into whatever part of its target.
    SurfaceRay ray = RayThrough(picture, eyeIndex);
    result.clip = WorldToClip(ray.origin + ray.direction * FromSurfaceDepth(0.5, eyeIndex));
    result.clip.z = 0.5 * result.clip.w;        // whatever an oblique near plane makes of it
    result.picture = float4(picture, 0.0, 0.0);
    return result;
}

SurfaceVaryings SurfaceVertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
{
    return SurfaceCorner(RectangleCorner(vertex, _PictureBounds.xy, _PictureBounds.zw), instance);
}

#endif
