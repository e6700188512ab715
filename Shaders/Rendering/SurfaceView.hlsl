// The views that the water's surface is drawn for: one camera, one or two eyes. Its own matrices, so that its textures can be
// filled outside the pipeline's passes. Positions on the picture are -1 to 1 with y up; textures begin at the bottom of the picture.
//
// Depth in the surface's textures is the device's with 1 at the near plane, 0 at the far plane and 0 without water.
// Planes are linear in it on the picture, with perspective and without. Where the camera's near plane is oblique, as that of a planar
// mirror, it is still the depth of a straight one: the scene's is another, and what the oblique plane cuts off is left out.
#ifndef RILL_SURFACE_VIEW_INCLUDED
#define RILL_SURFACE_VIEW_INCLUDED

#include "Platform.hlsl"
#include "../Generated/SurfaceView.hlsl"

uint _SurfaceEye;                   // that a pass draws for

static const float kNothing = 1e5;     // m: further than any water

struct SurfaceRay
{
    float3 origin;          // world
    float3 direction;       // of length 1 along the view: a distance along the ray is the depth in the view, m
};

SurfaceRay RayThrough(float2 picture, uint eye)
{
    SurfaceRay ray;
    ray.origin = _RayOrigin[eye].xyz + _RayOriginX[eye].xyz * picture.x + _RayOriginY[eye].xyz * picture.y;
    ray.direction = _RayDirection[eye].xyz + _RayDirectionX[eye].xyz * picture.x + _RayDirectionY[eye].xyz * picture.y;
    return ray;
}

// Half the width and height of the picture, m: at a depth of 1 m with perspective, at any without.
float2 PictureScale(uint eye)
{
    return float2(length(_RayOriginX[eye].xyz + _RayDirectionX[eye].xyz), length(_RayOriginY[eye].xyz + _RayDirectionY[eye].xyz));
}

// Height of a texel at a depth along the view, both in m. size: of its texture's grid over the picture, see Generated/SurfaceView.hlsl.
float TexelHeight(float4 size, float z, uint eye)
{
    return 2.0 * size.w * PictureScale(eye).y * (_SurfaceDepths[eye].z > 0.5 ? 1.0 : z);
}

// Clip space of the surface's own depth: y up, z is 1 at the near plane.
float4 SurfaceClip(float3 world, uint eye)
{
    float4 at = float4(world, 1.0);
    return float4(dot(_SurfaceClipX[eye], at), dot(_SurfaceClipY[eye], at), dot(_SurfaceClipZ[eye], at), dot(_SurfaceClipW[eye], at));
}

// Whether an oblique near plane leaves a point of the world; a straight one leaves all.
bool IsBeyondNearPlane(float3 world, uint eye)
{
    return dot(_NearPlanes[eye], float4(world, 1.0)) > 0.0;
}

// Depth along the view, m.
float FromSurfaceDepth(float depth, uint eye)
{
    float4 p = _SurfaceDepths[eye];
    return p.z > 0.5 ? (depth - p.x) / p.y : p.y / max(depth - p.x, 1e-12);
}

// Depth along the view, m, of what the scene's depth texture holds at a point of the picture; depth: see FlipDepth.
float FromSceneDepth(float depth, float2 picture, uint eye)
{
    float4 p = _SceneDepths[eye];
    bool isOblique = any(p.zw != 0.0);
    if (isOblique && depth <= 0.0)
        return kNothing;        // the far plane, which is tilted with the near one and may be near
    float rest = depth - p.x - (isOblique ? dot(p.zw, picture) : 0.0);
    return _SurfaceDepths[eye].z > 0.5 ? rest / p.y : p.y / max(rest, 1e-12);
}

// Depth along the view, m, of a point in the clip space of the surface.
float DepthAlongView(float4 clip, uint eye)
{
    return _SurfaceDepths[eye].z < 0.5 ? clip.w : FromSurfaceDepth(clip.z, eye);
}

// Between the device's depth and that of the surface's textures; its own inverse.
float FlipDepth(float depth)
{
#if RILL_OPENGL
    return 1.0 - depth;
#else
    return depth;
#endif
}

// A point of the picture in texels of textures that hold a window of it.
float2 TexelsAt(float2 picture, float4 size, float4 window)
{
    return (picture * 0.5 + 0.5) * size.xy - window.xy;
}

// Returns where a texture of foam's window is sampled between texels, for a point of the picture.
float3 PointOfLayer(Texture2DArray<float4> layer, float2 picture, uint eye)
{
    uint width, height, slices;
    layer.GetDimensions(width, height, slices);
    float2 texels = clamp(TexelsAt(picture, _FoamSize, _FoamWindow), 0.5, max(_FoamWindow.zw - 0.5, 0.5));
    return float3(texels / float2(width, height), eye);
}

// Back from texels: a point of the picture.
float2 PictureAt(float2 texels, float4 size, float4 window)
{
    return (texels + window.xy) * size.zw * 2.0 - 1.0;
}

// The texel of the surface's textures in which a point of the picture lies; the nearest of the window beyond it.
int2 SurfaceTexel(float2 picture)
{
    return int2(clamp(TexelsAt(picture, _SurfaceSize, _SurfaceWindow), 0.0, _SurfaceWindow.zw - 1.0));
}

// Returns SV_Position for a point in the viewport, -1 to 1 with y up, at a depth of the surface's textures, in a render texture.
float4 ViewportPosition(float2 at, float depth)
{
#if RILL_OPENGL
    return float4(at, 1.0 - 2.0 * depth, 1.0);
#else
    return float4(at.x, -at.y, depth, 1.0);
#endif
}

// Returns SV_Position for a point in the clip space of the surface.
float4 WindowClip(float4 clip)
{
    float2 scale = _SurfaceSize.xy / max(_SurfaceWindow.zw, 1.0), shift = scale - 2.0 * _SurfaceWindow.xy / max(_SurfaceWindow.zw, 1.0) - 1.0;
    float2 at = clip.xy * scale + clip.w * shift;
#if RILL_OPENGL
    return float4(at, clip.w - 2.0 * clip.z, clip.w);
#else
    return float4(at.x, -at.y, clip.z, clip.w);
#endif
}

// Returns a corner of one triangle that covers a viewport, -1 to 1 with y up.
float2 TriangleCorner(uint vertex)
{
    return float2(vertex == 1 ? 3.0 : -1.0, vertex == 2 ? 3.0 : -1.0);
}

// Corners of a rectangle as two triangles, on the picture.
float2 RectangleCorner(uint vertex, float2 low, float2 high)
{
    static const float2 kCorners[6] = { float2(0, 0), float2(0, 1), float2(1, 1), float2(0, 0), float2(1, 1), float2(1, 0) };
    return lerp(low, high, kCorners[vertex % 6]);
}

// The center of a texel of the surface's textures on the picture.
float2 TexelPicture(int2 texel)
{
    return PictureAt(texel + 0.5, _SurfaceSize, _SurfaceWindow);
}

#endif
