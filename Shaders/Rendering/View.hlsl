// The view that a pass draws for, in every render pipeline: from world to clip space, where the eye is, which of two eyes.
// Includes nothing of Unity's, so that it compiles where no pipeline is: a SubShader defines one of
//   RILL_BUILT_IN
//   RILL_UNIVERSAL
//   RILL_HIGH_DEFINITION    14 or 17, the pipeline's major version, which decides how its constant buffers begin
// and a pass that draws for a light RILL_SHADOW_VIEW, one that asks for the size of the picture RILL_PICTURE_SIZE. The names are the
// pipelines' own; their constant buffers that are bound whole (HDRP's, and those of the two eyes) are declared as far as they are read,
// in the pipelines' order.
#ifndef RILL_VIEW_INCLUDED
#define RILL_VIEW_INCLUDED

#include "Platform.hlsl"

// Two eyes in one pass. Unity adds the keywords to every shader and turns one of them on while it draws such a pass.
#if defined(STEREO_INSTANCING_ON)
#define RILL_STEREO_INSTANCING 1        // two instances, one for each eye, into the slices of a texture array
#elif defined(STEREO_MULTIVIEW_ON) && (defined(SHADER_API_GLES3) || defined(SHADER_API_GLCORE) || defined(SHADER_API_VULKAN)) && !defined(SHADER_API_SWITCH)
#define RILL_STEREO_MULTIVIEW 1         // the device runs the vertex program for each eye
#endif
#if defined(RILL_STEREO_INSTANCING) || defined(RILL_STEREO_MULTIVIEW)
#define RILL_STEREO 1
#endif

static uint eyeIndex = 0;       // set by SelectView and RestoreView

#ifdef RILL_STEREO_MULTIVIEW
cbuffer OVR_multiview
{
    uint gl_ViewID;
    uint numViews_2;
};
#endif

#if defined(RILL_HIGH_DEFINITION)

cbuffer ShaderVariablesGlobal : register(b0)
{
    float4x4 _ViewMatrix;
    float4x4 _CameraViewMatrix;
    float4x4 _InvViewMatrix;
    float4x4 _ProjMatrix;
    float4x4 _InvProjMatrix;
    float4x4 _ViewProjMatrix;
    float4x4 _CameraViewProjMatrix;
    float4x4 _InvViewProjMatrix;
    float4x4 _NonJitteredViewProjMatrix;
#if RILL_HIGH_DEFINITION >= 17
    float4x4 _NonJitteredInvViewProjMatrix;
#endif
    float4x4 _PrevViewProjMatrix;
    float4x4 _PrevInvViewProjMatrix;
    float4 _WorldSpaceCameraPos_Internal;
    float4 _PrevCamPosRWS_Internal;
#ifdef RILL_PICTURE_SIZE
    float4 _ScreenSize;
#endif
};

#ifdef RILL_STEREO
cbuffer ShaderVariablesXR : register(b1)
{
    float4x4 _XRViewMatrix[2];
    float4x4 _XRInvViewMatrix[2];
    float4x4 _XRProjMatrix[2];
    float4x4 _XRInvProjMatrix[2];
    float4x4 _XRViewProjMatrix[2];
    float4x4 _XRInvViewProjMatrix[2];
    float4x4 _XRNonJitteredViewProjMatrix[2];
#if RILL_HIGH_DEFINITION >= 17
    float4x4 _XRNonJitteredInvViewProjMatrix[2];
#endif
    float4x4 _XRPrevViewProjMatrix[2];
    float4x4 _XRPrevInvViewProjMatrix[2];
    float4x4 _XRPrevViewProjMatrixNoCameraTrans[2];
    float4x4 _XRViewProjMatrixNoCameraTrans[2];
    float4x4 _XRPixelCoordToViewDirWS[2];
    float4 _XRWorldSpaceCameraPos[2];
};
#define RILL_VIEW_MATRIX _XRViewMatrix[eyeIndex]
#define RILL_WORLD_TO_CLIP _XRViewProjMatrix[eyeIndex]
#define RILL_STEADY_WORLD_TO_CLIP _XRNonJitteredViewProjMatrix[eyeIndex]
#define RILL_PREVIOUS_WORLD_TO_CLIP _XRPrevViewProjMatrix[eyeIndex]
#define RILL_ORIGIN _XRWorldSpaceCameraPos[eyeIndex].xyz
#else
#define RILL_VIEW_MATRIX _ViewMatrix
#define RILL_WORLD_TO_CLIP _ViewProjMatrix
#define RILL_STEADY_WORLD_TO_CLIP _NonJitteredViewProjMatrix
#define RILL_PREVIOUS_WORLD_TO_CLIP _PrevViewProjMatrix
#define RILL_ORIGIN _WorldSpaceCameraPos_Internal.xyz
#endif
#define RILL_EYE RILL_ORIGIN

#else

#ifdef RILL_STEREO
#ifdef RILL_UNIVERSAL
cbuffer UnityStereoViewBuffer
{
    float4x4 unity_StereoMatrixP[2];
    float4x4 unity_StereoMatrixInvP[2];
    float4x4 unity_StereoMatrixV[2];
    float4x4 unity_StereoMatrixInvV[2];
    float4x4 unity_StereoMatrixVP[2];
};
#else
cbuffer UnityStereoGlobals
{
    float4x4 unity_StereoMatrixP[2];
    float4x4 unity_StereoMatrixV[2];
    float4x4 unity_StereoMatrixInvV[2];
    float4x4 unity_StereoMatrixVP[2];
};
#endif
#define RILL_VIEW_MATRIX unity_StereoMatrixV[eyeIndex]
#define RILL_WORLD_TO_CLIP unity_StereoMatrixVP[eyeIndex]
#define RILL_EYE float3(unity_StereoMatrixInvV[eyeIndex][0].w, unity_StereoMatrixInvV[eyeIndex][1].w, unity_StereoMatrixInvV[eyeIndex][2].w)
#else
float4x4 unity_MatrixV;
float4x4 unity_MatrixVP;
float3 _WorldSpaceCameraPos;
#define RILL_VIEW_MATRIX unity_MatrixV
#define RILL_WORLD_TO_CLIP unity_MatrixVP
#define RILL_EYE _WorldSpaceCameraPos
#endif

// Matrices without jitter (temporal antialiasing), and those of the last frame: for motion vectors alone.
#if defined(RILL_UNIVERSAL) && defined(RILL_STEREO)
float4x4 _NonJitteredViewProjMatrixStereo[2];
float4x4 _PrevViewProjMatrixStereo[2];
#define RILL_STEADY_WORLD_TO_CLIP _NonJitteredViewProjMatrixStereo[eyeIndex]
#define RILL_PREVIOUS_WORLD_TO_CLIP _PrevViewProjMatrixStereo[eyeIndex]
#elif defined(RILL_UNIVERSAL)
float4x4 _NonJitteredViewProjMatrix;
float4x4 _PrevViewProjMatrix;
#define RILL_STEADY_WORLD_TO_CLIP _NonJitteredViewProjMatrix
#define RILL_PREVIOUS_WORLD_TO_CLIP _PrevViewProjMatrix
#elif defined(RILL_STEREO)
float4x4 _StereoNonJitteredVP[2];
float4x4 _StereoPreviousVP[2];
#define RILL_STEADY_WORLD_TO_CLIP _StereoNonJitteredVP[eyeIndex]
#define RILL_PREVIOUS_WORLD_TO_CLIP _StereoPreviousVP[eyeIndex]
#else
float4x4 _NonJitteredVP;
float4x4 _PreviousVP;
#define RILL_STEADY_WORLD_TO_CLIP _NonJitteredVP
#define RILL_PREVIOUS_WORLD_TO_CLIP _PreviousVP
#endif
#define RILL_ORIGIN float3(0, 0, 0)

#endif

// ---- which eye

// At the end of what a vertex program hands on.
#if defined(RILL_STEREO_INSTANCING)
#define RILL_VIEW_OUTPUT float eye : BLENDWEIGHT0; uint slice : SV_RenderTargetArrayIndex;
#elif defined(RILL_STEREO_MULTIVIEW)
#define RILL_VIEW_OUTPUT float eye : BLENDWEIGHT0;
#else
#define RILL_VIEW_OUTPUT
#endif

// First in a vertex program. With two eyes in one pass, instance 0 is for the left and 1 for the right. An indirect draw has
// two instances wherever some camera draws so; where this pass does not, the second must draw nothing: false.
bool SelectView(uint instance)
{
#if defined(RILL_STEREO_INSTANCING)
    eyeIndex = instance & 1;
    return true;
#elif defined(RILL_STEREO_MULTIVIEW)
    eyeIndex = gl_ViewID;
    return instance == 0;
#else
    return instance == 0;
#endif
}

// Last in a vertex program.
#if defined(RILL_STEREO_INSTANCING)
#define PassViewOn(output) output.eye = eyeIndex; output.slice = eyeIndex;
#elif defined(RILL_STEREO_MULTIVIEW)
#define PassViewOn(output) output.eye = eyeIndex;
#else
#define PassViewOn(output)
#endif

// First in a fragment program.
#ifdef RILL_STEREO
#define RestoreView(input) eyeIndex = (uint)(input.eye + 0.5);
#else
#define RestoreView(input)
#endif

// Position of vertices that must not be drawn: all three of a triangle in one point, outside.
static const float4 kNowhere = float4(2, 2, 2, 1);

// ---- world to clip

float4 WorldToClip(float3 world)
{
    return mul(RILL_WORLD_TO_CLIP, float4(world - RILL_ORIGIN, 1.0));
}

bool IsOrthographic()
{
    return all(RILL_WORLD_TO_CLIP[3].xyz == 0.0);
}

#ifdef RILL_PICTURE_SIZE
#if defined(RILL_HIGH_DEFINITION)
#define RILL_PICTURE _ScreenSize
#elif defined(RILL_UNIVERSAL)
float4 _ScaledScreenParams;
#define RILL_PICTURE _ScaledScreenParams
#else
float4 _ScreenParams;
#define RILL_PICTURE _ScreenParams
#endif

// How many pixels high a meter is at a point in front of the eye.
float PixelsPerMeter(float3 world)
{
    return 0.5 * RILL_PICTURE.y * length(RILL_WORLD_TO_CLIP[1].xyz) / max(WorldToClip(world).w, 1e-6);
}
#endif

// Returns the depth for SV_Depth.
float DeviceDepth(float4 clip)
{
    float depth = clip.z / clip.w;
#if RILL_OPENGL
    depth = depth * 0.5 + 0.5;
#endif
    return depth;
}

// ---- the eye

#ifdef RILL_SHADOW_VIEW

// The pipelines name the camera's eye, not the light's, while they draw a shadow map. So it comes out of the matrix: the point
// that has no clip x, y and w. Without perspective that is a direction, w 0; its sign is that towards the near plane.
float4 HomogeneousEye()
{
    float4 a = RILL_WORLD_TO_CLIP[0], b = RILL_WORLD_TO_CLIP[1], c = RILL_WORLD_TO_CLIP[3];
    float3 bc = cross(b.xyz, c.xyz), ca = cross(c.xyz, a.xyz), ab = cross(a.xyz, b.xyz);
    float nearer = dot(RILL_WORLD_TO_CLIP[2].xyz, ab);
#if RILL_OPENGL
    nearer = -nearer;
#endif
    float4 eye = float4(nearer < 0.0 ? -ab : ab, 0.0);
    if (!IsOrthographic())
        eye = float4(RILL_ORIGIN - (bc * a.w + ca * b.w + ab * c.w) / dot(a.xyz, bc), 1.0);
    return eye;
}

// Unit vector in the world from a point to the eye.
float3 ToEye(float3 world)
{
    float4 eye = HomogeneousEye();
    return normalize(eye.xyz - world * eye.w);
}

float EyeDistanceSquared(float3 world)
{
    float4 eye = HomogeneousEye();
    float3 difference = eye.xyz - world;
    return dot(difference, difference);
}

#else

float3 ToEye(float3 world)
{
    float3 toEye = RILL_VIEW_MATRIX[2].xyz;     // without perspective: the camera looks along -z of its view matrix
    if (!IsOrthographic())
        toEye = normalize(RILL_EYE - world);
    return toEye;
}

float EyeDistanceSquared(float3 world)
{
    float3 difference = RILL_EYE - world;
    return dot(difference, difference);
}

#endif

#endif
