// Motion vectors of the water's surface: one rectangle over the textures that WaterRays filled for this camera, with depth,
// into a pipeline's texture of motion. The SubShader around it says for which pipeline, see View.hlsl. Includes nothing of Unity's.
//
//   _SurfaceDepth   in  Texture2DArray, a slice for each eye, x: see SurfaceView.hlsl
//   _SurfaceChords  in  xyz displacement of the nearest water in the last substep, d, in the domain's frame
//   the scene's depth, where the pipeline has no depth to test against (HDRP)
#include "ScreenMotion.hlsl"
#include "SurfaceView.hlsl"
#include "SurfaceRectangle.hlsl"

Texture2DArray<float> _SurfaceDepth;
Texture2DArray<float4> _SurfaceChords;
#ifdef RILL_HIGH_DEFINITION
#define RILL_SCENE_ARRAY
#include "SceneDepth.hlsl"
#endif

float4 _FrameLag;               // time of this frame, x, and of the frame before, z, since the newest state, substeps
float4x4 _WorldToDomain;        // from world, meters, to the domain's frame in d
float4x4 _LastDomainToWorld;    // back, at the frame before
float4x4 _DomainMotion;         // the same of this frame minus that: exactly 0 where the domain stands still

// How far a point of the water, world, has come since the frame before, m: along the chord of its particle, and with the domain.
float3 MotionOfWater(float3 world, float3 chord)
{
    float4 inDomain = float4(mul(_WorldToDomain, float4(world, 1.0)).xyz, 1.0);
    return mul((float3x3)_LastDomainToWorld, chord * (_FrameLag.x - _FrameLag.z)) + mul(_DomainMotion, inDomain).xyz;
}

// Returns the water's motion in xy, and its position. Discards pixels without water.
float4 MotionAt(float2 picture, out float3 world)
{
    int2 texel = SurfaceTexel(picture);
    float surface = _SurfaceDepth.Load(int4(texel, eyeIndex, 0));
    if (surface == 0.0)
        discard;
    SurfaceRay ray = RayThrough(picture, eyeIndex);
    world = ray.origin + ray.direction * FromSurfaceDepth(surface, eyeIndex);
    return MotionOnScreen(world, world - MotionOfWater(world, _SurfaceChords.Load(int4(texel, eyeIndex, 0)).xyz));
}

#ifdef RILL_HIGH_DEFINITION
// HDRP's depth may have several samples where its motion has one, and is not to hold the water before it is shaded.
float4 MotionFragment(SurfaceVaryings input) : SV_Target
{
    RestoreView(input);
    float3 world;
    float4 motion = MotionAt(input.picture.xy, world);
    if (FlipDepth(SceneDepth(input.picture.xy, eyeIndex)) > FlipDepth(DeviceDepth(WorldToClip(world))))
        discard;
    return motion;
}
#else
float4 MotionFragment(SurfaceVaryings input, out float depth : SV_Depth) : SV_Target
{
    RestoreView(input);
    float3 world;
    float4 motion = MotionAt(input.picture.xy, world);
    depth = DeviceDepth(WorldToClip(world));
    return motion;
}
#endif
