// The views that the water's surface is drawn for: one camera, one or two eyes. Its own matrices, so that its textures can be
// filled outside the pipeline's passes. Positions on the picture are -1 to 1 with y up; textures begin at the bottom of the picture.
//
// Depth in the surface's textures is the device's with 1 at the near plane, 0 at the far plane and 0 where there is no water.
// Planes are linear in it on the picture, with perspective and without.
#ifndef RILL_SURFACE_VIEW_INCLUDED
#define RILL_SURFACE_VIEW_INCLUDED

#include "Platform.hlsl"
#include "../Generated/SurfaceView.hlsl"

float4x4 _SurfaceWorldToClip[2];    // of each eye; y up, z is 1 at the near plane
float4 _SurfaceRays[2 * kRaysOfEye];      // of each eye: origin, its change along x and y of the picture, direction, its change along x and y
float4 _SurfaceDepths[2];           // of each eye: device depth = x + y / z with perspective, x + y z without; z, m, along the view. z: 1 without
float4 _SurfaceSize;                // width and height of the textures, texels, and one over them
uint _SurfaceEye;                   // that a pass draws for

struct SurfaceRay
{
    float3 origin;          // world
    float3 direction;       // of length 1 along the view: a distance along the ray is the depth in the view, m
};

SurfaceRay RayThrough(float2 picture, uint eye)
{
    SurfaceRay ray;
    uint first = eye * kRaysOfEye;
    ray.origin = _SurfaceRays[first].xyz + _SurfaceRays[first + 1].xyz * picture.x + _SurfaceRays[first + 2].xyz * picture.y;
    ray.direction = _SurfaceRays[first + 3].xyz + _SurfaceRays[first + 4].xyz * picture.x + _SurfaceRays[first + 5].xyz * picture.y;
    return ray;
}

// z > 0 with perspective.
float ToSurfaceDepth(float z, uint eye)
{
    float4 p = _SurfaceDepths[eye];
    return p.z > 0.5 ? p.x + p.y * z : p.x + p.y / z;
}

// Depth along the view, m.
float FromSurfaceDepth(float depth, uint eye)
{
    float4 p = _SurfaceDepths[eye];
    return p.z > 0.5 ? (depth - p.x) / p.y : p.y / max(depth - p.x, 1e-12);
}

// Depth along the view, m, of a point in the clip space of _SurfaceWorldToClip.
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

// What SV_Position takes for a point of the picture at a depth of the surface's textures, in a render texture.
float4 SurfacePosition(float2 picture, float depth)
{
#if RILL_OPENGL
    return float4(picture, 1.0 - 2.0 * depth, 1.0);
#else
    return float4(picture.x, -picture.y, depth, 1.0);
#endif
}

// Of a rectangle as two triangles, on the picture.
float2 RectangleCorner(uint vertex, float2 low, float2 high)
{
    static const float2 kCorners[6] = { float2(0, 0), float2(0, 1), float2(1, 1), float2(0, 0), float2(1, 1), float2(1, 0) };
    return lerp(low, high, kCorners[vertex % 6]);
}

// The middle of a texel on the picture.
float2 TexelPicture(uint2 texel)
{
    return (texel + 0.5) * _SurfaceSize.zw * 2.0 - 1.0;
}

#endif
