// What is drawn into the textures of the water's surface, see FluidSurfaceRecorder.cs: its ellipsoids as the device's depth.
//
//   the buffers of DrawnSurface.hlsl
#include "SurfaceQuadric.hlsl"
#include "DrawnSurface.hlsl"

#if RILL_OPENGL
#define RILL_CONSERVATIVE_DEPTH SV_DepthGreaterEqual
#else
#define RILL_CONSERVATIVE_DEPTH SV_DepthLessEqual
#endif

struct RasterVaryings
{
    float4 clip : SV_Position;
    float3 origin : TEXCOORD0;      // of the ray, in the frame in which the ellipsoid is a ball of radius 1
    float3 direction : TEXCOORD1;
};

RasterVaryings RasterVertex(uint vertex : SV_VertexID)
{
    static const float2 kCorners[6] = { float2(0, 0), float2(0, 1), float2(1, 1), float2(0, 0), float2(1, 1), float2(1, 0) };
    RasterVaryings result = (RasterVaryings)0;
    result.clip = float4(2, 2, 2, 1);
    Ellipsoid e = DrawnEllipsoid(vertex / 6);
    PictureBounds bounds = BoundsOf(e, _SurfaceEye);
    if (!bounds.isSeen)
        return result;

    float2 picture = lerp(bounds.low, bounds.high, kCorners[vertex % 6]);
    RayInBall(e, RayThrough(picture, _SurfaceEye), result.origin, result.direction);
    result.clip = SurfacePosition(picture, bounds.nearest);
    return result;
}

void DepthFragment(RasterVaryings input, out float depth : RILL_CONSERVATIVE_DEPTH)
{
    float2 hit;
    if (!HitBall(input.origin, input.direction, hit))
        discard;
    depth = FlipDepth(ToSurfaceDepth(hit.x, _SurfaceEye));
}
