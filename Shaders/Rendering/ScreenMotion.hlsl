// Output of MotionVectors passes: how far a point has come on the screen since the last frame, by its own motion and the
// camera's. Includes nothing of Unity's; see View.hlsl.
#ifndef RILL_SCREEN_MOTION_INCLUDED
#define RILL_SCREEN_MOTION_INCLUDED

#include "View.hlsl"

#ifdef RILL_BUILT_IN
int _ForceNoMotion;
float _MotionVectorDepthBias;
#define RILL_HAS_MOTION (_ForceNoMotion == 0)
#define RILL_MOTION_DEPTH_BIAS _MotionVectorDepthBias
#else
float4 unity_MotionVectorsParams;       // y 0 where the renderer is to have none; z keeps the pass in front of the depth
#define RILL_HAS_MOTION (unity_MotionVectorsParams.y != 0.0)
#define RILL_MOTION_DEPTH_BIAS unity_MotionVectorsParams.z
#endif

// The clip position with the bias by which the pass passes the depth test against what it itself drew before.
float4 MotionClip(float4 clip)
{
#if RILL_OPENGL
    clip.z += RILL_MOTION_DEPTH_BIAS * clip.w;
#else
    clip.z -= RILL_MOTION_DEPTH_BIAS * clip.w;
#endif
    return clip;
}

// From where a point of the world was at the last frame to where it is, both in world space, as the pipeline stores it: in
// fractions of the screen, y as the pipeline's textures have it.
float4 MotionOnScreen(float3 world, float3 previous)
{
    float4 now = mul(RILL_STEADY_WORLD_TO_CLIP, float4(world - RILL_ORIGIN, 1.0));
    float4 before = mul(RILL_PREVIOUS_WORLD_TO_CLIP, float4(previous - RILL_ORIGIN, 1.0));       // HDRP's is relative to this frame's camera too
    float2 motion = (now.xy / now.w - before.xy / before.w) * 0.5;
#if !RILL_OPENGL
    motion.y = -motion.y;
#endif
#ifdef RILL_BUILT_IN
    return float4(motion, 0.0, 1.0);
#else
    return float4(motion, 0.0, 0.0);
#endif
}

// Returns the motion in a pass for which the pipeline says whether the renderer is to have any.
float4 ScreenMotion(float3 world, float3 previous)
{
#ifdef RILL_HIGH_DEFINITION
    if (!RILL_HAS_MOTION)
        return float4(2.0, 0.0, 0.0, 0.0);      // what HDRP takes for "no motion vector"
#else
    if (!RILL_HAS_MOTION)
        return 0.0;
#endif
    return MotionOnScreen(world, previous);
}

#endif
