// Ellipsoids on the picture: the rectangle that holds one.
#ifndef RILL_SURFACE_QUADRIC_INCLUDED
#define RILL_SURFACE_QUADRIC_INCLUDED

#include "Ellipsoid.hlsl"
#include "SurfaceView.hlsl"

struct PictureBounds
{
    float2 low, high;
    float nearest;      // depth
    bool isSeen;        // wholly in front of the eye
};

// s at which the plane "row.x - s row.w" touches the ellipsoid (Sigg, Weyrich, Botsch and Gross 2006, section 3): of one
// coordinate, lowest and highest.
float2 TouchingPlanes(float4 x, float4 w, float inverseA)
{
    float b = x.w * w.w - dot(x.xyz, w.xyz);
    float c = x.w * x.w - dot(x.xyz, x.xyz);
    float a = w.w * w.w - dot(w.xyz, w.xyz);
    float root = sqrt(max(b * b - a * c, 0.0));
    return float2(b - root, b + root) * inverseA;
}

float4 RowOf(Ellipsoid e, float4 row)
{
    return float4(dot(row.xyz, e.a), dot(row.xyz, e.b), dot(row.xyz, e.c), dot(row, float4(e.center, 1.0)));
}

PictureBounds BoundsOf(Ellipsoid e, uint eye)
{
    PictureBounds bounds;
    float4 x = RowOf(e, _SurfaceClipX[eye]), y = RowOf(e, _SurfaceClipY[eye]);
    float4 z = RowOf(e, _SurfaceClipZ[eye]), w = RowOf(e, _SurfaceClipW[eye]), near = RowOf(e, _NearPlanes[eye]);
    float a = w.w * w.w - dot(w.xyz, w.xyz);
    bounds.isSeen = w.w > 0.0 && a > 0.0;
    float inverseA = 1.0 / max(a, 1e-20);
    float2 horizontal = TouchingPlanes(x, w, inverseA), vertical = TouchingPlanes(y, w, inverseA);
    bounds.low = float2(horizontal.x, vertical.x);
    bounds.high = float2(horizontal.y, vertical.y);
    bounds.nearest = TouchingPlanes(z, w, inverseA).y;
    bounds.isSeen = bounds.isSeen && bounds.nearest < 1.0 && near.w > length(near.xyz);     // what the near plane cuts is not drawn
    return bounds;
}

// A ray of the picture in the frame in which the ellipsoid is a ball of radius 1: linear on the picture.
void RayInBall(Ellipsoid e, SurfaceRay ray, out float3 origin, out float3 direction)
{
    origin = ToBall(e, ray.origin - e.center);
    direction = ToBall(e, ray.direction);
}

#endif
