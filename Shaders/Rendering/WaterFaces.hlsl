// The nearest faces of the water's mesh on a camera's picture, from which WaterRays.compute follows the light, and the depth of the scene, which
// kernels cannot name as the pipeline binds it.
//
//   the buffer of MeshVertex.hlsl
//   _CameraDepthTexture  in  the pipeline's
#include "SurfaceView.hlsl"
#include "SceneDepth.hlsl"
#include "DrawnDomain.hlsl"
#include "MeshVertex.hlsl"
#include "WaterFace.hlsl"

struct FaceVaryings
{
    float4 clip : SV_Position;
    float3 chord : TEXCOORD0;       // displacement in the last substep, d
    float3 drawn : TEXCOORD1;       // where it is at the time of the frame, d
    float3 world : TEXCOORD2;
    float3 normal : TEXCOORD3;      // domain
};

FaceVaryings FaceVertex(uint vertex : SV_VertexID)
{
    FaceVaryings result = (FaceVaryings)0;
    result.clip = float4(2, 2, 2, 1);
    MeshVertex v = LoadMeshVertex(vertex);
    result.chord = v.displacement;
    result.drawn = v.position + MeshShift(v, _DrawnDomainSize.xyz);
    result.normal = v.normal;
    result.world = mul(_DomainToWorld, float4(result.drawn, 1.0)).xyz;
    result.clip = WindowClip(SurfaceClip(result.world, _SurfaceEye));
    return result;
}

float4 FaceFragment(FaceVaryings input) : SV_Target
{
    if (!IsBeyondNearPlane(input.world, _SurfaceEye))
        discard;
    float3 normal = FlatOnWalls(input.drawn, normalize(input.normal));
    return PackFace(normalize(mul((float3x3)_DomainToWorld, normal)), input.chord);
}

struct CopyVaryings
{
    float4 clip : SV_Position;
    float2 picture : TEXCOORD0;
};

CopyVaryings CopyVertex(uint vertex : SV_VertexID)
{
    CopyVaryings result;
    float2 at = TriangleCorner(vertex);
    result.picture = at;
    result.clip = ViewportPosition(at, 0.5);
    return result;
}

float CopyFragment(CopyVaryings input) : SV_Target
{
    return SceneDepth(input.picture, _SurfaceEye);
}
