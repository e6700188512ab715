// The scene's depth for the passes that compute: kernels cannot name what a pipeline binds for draws. One triangle over the picture,
// into a texture that may be smaller than the scene's.
//
//   _CameraDepthTexture  in   the pipeline's
//   target               out  distance along the view, m: the farthest of the samples in a texel, so that what stands in front of
//                             the water leaves no seam in it
#include "SurfaceView.hlsl"
#include "SceneDepth.hlsl"

static const uint kSamples = 4;      // along x and y

struct SceneVaryings
{
    float4 clip : SV_Position;
    float2 picture : TEXCOORD0;
};

SceneVaryings SceneVertex(uint vertex : SV_VertexID)
{
    SceneVaryings result;
    float2 at = TriangleCorner(vertex);
    result.picture = ((at * 0.5 + 0.5) * _ThicknessWindow.zw + _ThicknessWindow.xy) * _ThicknessSize.zw * 2.0 - 1.0;
    result.clip = ViewportPosition(at, 0.5);
    return result;
}

float SceneFragment(SceneVaryings input) : SV_Target
{
    float farthest = 0.0;
    for (uint i = 0; i < kSamples * kSamples; i++)
    {
        float2 offset = (float2(i % kSamples, i / kSamples) + 0.5) / kSamples * 2.0 - 1.0;
        float2 picture = input.picture + offset * _ThicknessSize.zw;
        farthest = max(farthest, SceneDepthAt(picture, _SurfaceEye));
    }
    return farthest;
}
