// The depth of the scene as the pipeline binds it: with RILL_SCENE_ARRAY a slice for each eye. In kernels, which cannot name that, RILL_SCENE_COPY
// reads the copy of it that WaterFaces.hlsl makes: in texels of the rays' textures, but of the whole picture. Include after SurfaceView.hlsl.
#ifndef RILL_SCENE_DEPTH_INCLUDED
#define RILL_SCENE_DEPTH_INCLUDED

#if defined(RILL_SCENE_COPY)
Texture2DArray<float> _SceneCopy;
#elif defined(RILL_SCENE_ARRAY)
Texture2DArray _CameraDepthTexture;
#else
Texture2D _CameraDepthTexture;
#endif

#ifdef RILL_SCENE_COPY

float2 SceneSize()
{
    return _FoamSize.xy;
}

float SceneDepth(float2 picture, uint eye)
{
    int2 texel = int2(clamp((picture * 0.5 + 0.5) * _FoamSize.xy, 0.0, _FoamSize.xy - 1.0));
    return _SceneCopy.Load(int4(texel, eye, 0));
}

#else

float2 SceneSize()
{
    uint width, height;
#ifdef RILL_SCENE_ARRAY
    uint slices;
    _CameraDepthTexture.GetDimensions(width, height, slices);
#else
    _CameraDepthTexture.GetDimensions(width, height);
#endif
    return _SceneSize.x > 0.0 ? _SceneSize.xy : float2(width, height);
}

// The device's, at a point of the picture.
float SceneDepth(float2 picture, uint eye)
{
    float2 size = SceneSize();
    int2 texel = int2(clamp((picture * 0.5 + 0.5) * size, 0.0, size - 1.0));
#ifdef RILL_SCENE_ARRAY
    return _CameraDepthTexture.Load(int4(texel, eye, 0)).r;
#else
    return _CameraDepthTexture.Load(int3(texel, 0)).r;
#endif
}

#endif

// Depth along the view at a point of the picture, m.
float SceneDepthAt(float2 picture, uint eye)
{
    return FromSceneDepth(FlipDepth(SceneDepth(picture, eye)), picture, eye);
}

#endif
