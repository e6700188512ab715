// The color of the opaque scene as the pipeline gives it, where RILL_REFRACTION is on, and its depth. Include after SurfaceView.hlsl and
// Environment.hlsl.
#ifndef RILL_SCENE_COLOR_INCLUDED
#define RILL_SCENE_COLOR_INCLUDED

#if defined(RILL_HIGH_DEFINITION)
Texture2DArray _ColorPyramidTexture;
#define RILL_SCENE_COLOR(uv) _ColorPyramidTexture.SampleLevel(rill_linear_clamp_sampler, float3(InColorPyramid(uv), eyeIndex), 0)
#define RILL_SCENE_ARRAY
#elif defined(RILL_STEREO)
#ifdef RILL_UNIVERSAL
#define _SceneColor _CameraOpaqueTexture
#endif
Texture2DArray _SceneColor;
#define RILL_SCENE_COLOR(uv) _SceneColor.SampleLevel(rill_linear_clamp_sampler, float3(uv, eyeIndex), 0)
#define RILL_SCENE_ARRAY
#else
#ifdef RILL_UNIVERSAL
#define _SceneColor _CameraOpaqueTexture
#endif
Texture2D _SceneColor;
#define RILL_SCENE_COLOR(uv) _SceneColor.SampleLevel(rill_linear_clamp_sampler, uv, 0)
#endif
#include "SceneDepth.hlsl"

#if defined(RILL_HIGH_DEFINITION)
// HDRP's textures are as large as the largest camera needs; this one uses their first texels.
float2 InColorPyramid(float2 uv)
{
    uint width, height, slices;
    _ColorPyramidTexture.GetDimensions(width, height, slices);
    return min(uv * _SceneSize.xy, _SceneSize.xy - 0.5) / float2(width, height);
}
#endif

#endif
