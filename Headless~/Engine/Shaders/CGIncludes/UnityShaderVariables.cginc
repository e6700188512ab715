// Variables that the engine sets by itself (manual, "Built-in shader variables reference"). Written again for the headless host.
#ifndef UNITY_SHADER_VARIABLES_INCLUDED
#define UNITY_SHADER_VARIABLES_INCLUDED

#include "HLSLSupport.cginc"

CBUFFER_START(UnityPerCamera)
    float4 _Time;               // t / 20, t, 2 t, 3 t
    float4 _SinTime;            // sine of t / 8, t / 4, t / 2, t
    float4 _CosTime;
    float4 unity_DeltaTime;     // dt, 1 / dt, smoothed dt, 1 / smoothed dt
    float3 _WorldSpaceCameraPos;
    float4 _ProjectionParams;   // -1 where the projection is flipped, near, far, 1 / far
    float4 _ScreenParams;       // width, height, 1 + 1 / width, 1 + 1 / height
    float4 _ZBufferParams;      // far / near - 1, 1, x / far, y / far: depth is reversed
    float4 unity_OrthoParams;   // width, height, unused, 1 for an orthographic camera
CBUFFER_END

CBUFFER_START(UnityPerCameraRare)
    float4 unity_CameraWorldClipPlanes[6];
    float4x4 unity_CameraProjection;
    float4x4 unity_CameraInvProjection;
    float4x4 unity_WorldToCamera;
    float4x4 unity_CameraToWorld;
CBUFFER_END

CBUFFER_START(UnityLighting)
    float4 _WorldSpaceLightPos0;    // of a directional light: the direction to it, 0
    float4 unity_SHAr;
    float4 unity_SHAg;
    float4 unity_SHAb;
    float4 unity_SHBr;
    float4 unity_SHBg;
    float4 unity_SHBb;
    float4 unity_SHC;
CBUFFER_END

CBUFFER_START(UnityShadows)
    float4 unity_LightShadowBias;   // of the depth (negative: away from the light), 1 for a directional light, of the normal
    float4x4 unity_WorldToShadow[4];
    float4 _LightShadowData;        // x 1 - strength
    float4 unity_ShadowFadeCenterAndType;
CBUFFER_END

CBUFFER_START(UnityPerFrame)
    float4 glstate_lightmodel_ambient;
    float4 unity_AmbientSky;
    float4 unity_AmbientEquator;
    float4 unity_AmbientGround;
    float4x4 glstate_matrix_projection;
    float4x4 unity_MatrixV;
    float4x4 unity_MatrixInvV;
    float4x4 unity_MatrixVP;
CBUFFER_END

CBUFFER_START(UnityFog)
    float4 unity_FogColor;
    float4 unity_FogParams;
CBUFFER_END

// A program cannot write to a constant: where instances have matrices of their own, these two are variables.
#if defined(INSTANCING_ON) || defined(PROCEDURAL_INSTANCING_ON)
static float4x4 unity_ObjectToWorld = float4x4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
static float4x4 unity_WorldToObject = float4x4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
#endif
CBUFFER_START(UnityPerDraw)
#if !defined(INSTANCING_ON) && !defined(PROCEDURAL_INSTANCING_ON)
    float4x4 unity_ObjectToWorld;
    float4x4 unity_WorldToObject;
#endif
    float4 unity_LODFade;
    float4 unity_WorldTransformParams;  // w: -1 for a mirroring matrix, else 1
CBUFFER_END

UNITY_DECLARE_TEXCUBE(unity_SpecCube0);
CBUFFER_START(UnityReflectionProbes)
    float4 unity_SpecCube0_HDR;
CBUFFER_END

#define UNITY_MATRIX_P glstate_matrix_projection
#define UNITY_MATRIX_V unity_MatrixV
#define UNITY_MATRIX_I_V unity_MatrixInvV
#define UNITY_MATRIX_VP unity_MatrixVP
#define UNITY_MATRIX_M unity_ObjectToWorld
#define UNITY_MATRIX_MV mul(unity_MatrixV, unity_ObjectToWorld)
#define UNITY_MATRIX_MVP mul(unity_MatrixVP, unity_ObjectToWorld)
#define UNITY_MATRIX_T_MV transpose(UNITY_MATRIX_MV)
#define UNITY_MATRIX_IT_MV transpose(mul(unity_WorldToObject, unity_MatrixInvV))
#define UNITY_LIGHTMODEL_AMBIENT glstate_lightmodel_ambient

// Of old; the editor rewrites a project's files to the names above.
#define _Object2World unity_ObjectToWorld
#define _World2Object unity_WorldToObject

#include "UnityInstancing.cginc"

#endif
