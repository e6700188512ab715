// What is drawn into the textures of the water's surface, see FluidSurfaceRecorder.cs: its ellipsoids as the device's depth. Where
// RILL_CHORDS is on also how each moves: xyz its displacement in the last substep, d, in the domain's frame.
//
//   the buffers of DrawnSurface.hlsl
#include "SurfaceQuadric.hlsl"
#include "DrawnSurface.hlsl"

struct RasterVaryings
{
    float4 clip : SV_Position;
    float3 origin : TEXCOORD0;      // of the ray, in the frame in which the ellipsoid is a ball of radius 1
    float3 direction : TEXCOORD1;
#ifdef RILL_CHORDS
    nointerpolation float3 chord : TEXCOORD2;
#endif
};

RasterVaryings RasterVertex(uint vertex : SV_VertexID)
{
    RasterVaryings result = (RasterVaryings)0;
    result.clip = float4(2, 2, 2, 1);
    float3 chord;
    Ellipsoid e = DrawnEllipsoid(vertex / 6, chord);
    PictureBounds bounds = BoundsOf(e, _SurfaceEye);
    if (!bounds.isSeen)
        return result;

    float2 picture = RectangleCorner(vertex, bounds.low, bounds.high);
    RayInBall(e, RayThrough(picture, _SurfaceEye), result.origin, result.direction);
    result.clip = SurfacePosition(picture, bounds.nearest);
#ifdef RILL_CHORDS
    result.chord = chord;
#endif
    return result;
}

float DepthOfHit(RasterVaryings input)
{
    float2 hit;
    if (!HitBall(input.origin, input.direction, hit))
        discard;
    return FlipDepth(ToSurfaceDepth(hit.x, _SurfaceEye));
}

#ifdef RILL_CHORDS
float4 ChordFragment(RasterVaryings input, out float depth : RILL_CONSERVATIVE_DEPTH) : SV_Target
{
    depth = DepthOfHit(input);
    return float4(input.chord, FlipDepth(depth));
}
#else
void DepthFragment(RasterVaryings input, out float depth : RILL_CONSERVATIVE_DEPTH)
{
    depth = DepthOfHit(input);
}
#endif
