// Draws each particle as a sphere: a camera-facing quad from SV_VertexID, intersected with the ray through the pixel,
// lit, with the depth of the hit. Includes nothing of a pipeline: the pass around it defines
//   RillWorldToClip(float3)  the pipeline's world to clip transform
// and is compiled for any pipeline that sets Unity's own camera constants.
//
//   _Tags         uint, the phase in the highest byte, see ParticleTags.hlsl; where RILL_TAGS is on
//   and the buffers of DrawnParticles.hlsl
#include "DrawnParticles.hlsl"

#ifdef RILL_TAGS
StructuredBuffer<uint> _Tags;
float4 _PhaseColors[8];         // linear
#endif

float4x4 _DomainToWorld;        // from the domain's frame in d to world, metres
float _ParticleSpacing;         // m
float _ParticleRadius;          // m
float4 _SlowColor;              // linear, at value 0 of the ramp
float4 _MiddleColor;            // at 0.5
float4 _FastColor;              // at 1
float4 _ColorRange;             // ramp value = speed * x + (density - 1) * y + z
float4 _LightDirection;         // world, towards the light
float4 _LightColor;             // linear, intensity applied
float4 _AmbientColor;           // linear

struct ParticleFragment
{
    float4 clip : SV_Position;
    float3 world : TEXCOORD0;               // on the quad
    nointerpolation float3 center : TEXCOORD1;
    nointerpolation float3 color : TEXCOORD2;
};

float3 RampColor(float value)
{
    value = saturate(value);
    return value < 0.5 ? lerp(_SlowColor.rgb, _MiddleColor.rgb, value * 2.0) : lerp(_MiddleColor.rgb, _FastColor.rgb, value * 2.0 - 1.0);
}

// World direction from the eye towards a point: the camera looks along -z of its view matrix.
float3 ViewRay(float3 world)
{
    if (unity_OrthoParams.w > 0.5)
        return -unity_MatrixV[2].xyz;
    return normalize(world - _WorldSpaceCameraPos);
}

ParticleFragment ParticleVertex(uint vertex : SV_VertexID)
{
    static const float2 kCorners[6] = { float2(-1, -1), float2(-1, 1), float2(1, 1), float2(-1, -1), float2(1, 1), float2(1, -1) };
    uint i = vertex / 6;
    float2 corner = kCorners[vertex % 6];

    ParticleFragment result;
    float4 velocity = _Velocities[i];
    result.center = mul(_DomainToWorld, float4(DrawnPosition(i), 1.0)).xyz;
    float speed = length(velocity.xyz) * _ParticleSpacing;
#ifdef RILL_TAGS
    result.color = _PhaseColors[min(_Tags[i] >> 24, 7)].rgb;
#else
    result.color = RampColor(speed * _ColorRange.x + (velocity.w - 1.0) * _ColorRange.y + _ColorRange.z);
#endif

    // The silhouette of a sphere seen in perspective is wider than its radius in the plane of its centre.
    float3 ray = ViewRay(result.center);
    float size = _ParticleRadius;
    if (unity_OrthoParams.w < 0.5)
    {
        float3 eye = result.center - _WorldSpaceCameraPos;
        float distanceSquared = dot(eye, eye);
        size *= sqrt(distanceSquared / max(distanceSquared - _ParticleRadius * _ParticleRadius, 1e-4 * distanceSquared));
    }
    float3 side = normalize(cross(abs(ray.y) < 0.99 ? float3(0, 1, 0) : float3(1, 0, 0), ray));
    float3 up = cross(ray, side);
    result.world = result.center + (side * corner.x + up * corner.y) * size;
    result.clip = RillWorldToClip(result.world);
    return result;
}

float4 ParticleColor(ParticleFragment fragment, out float depth : SV_Depth) : SV_Target
{
    float3 ray = ViewRay(fragment.world);
    float3 toCenter = fragment.center - fragment.world;
    float along = dot(toCenter, ray);
    float3 offset = toCenter - ray * along;
    float missing = _ParticleRadius * _ParticleRadius - dot(offset, offset);
    if (missing < 0.0)
        discard;

    float3 hit = fragment.world + ray * (along - sqrt(max(missing, 0.0)));
    float3 normal = (hit - fragment.center) / _ParticleRadius;
    float4 clip = RillWorldToClip(hit);
    depth = clip.z / clip.w;
#if defined(SHADER_API_GLCORE) || defined(SHADER_API_GLES3)
    depth = depth * 0.5 + 0.5;      // OpenGL's clip space is -1 to 1
#endif

    float diffuse = saturate(dot(normal, _LightDirection.xyz) * 0.6 + 0.4);
    float highlight = pow(saturate(dot(reflect(ray, normal), _LightDirection.xyz)), 40.0);
    float rim = 1.0 - saturate(-dot(ray, normal));
    float3 sky = _AmbientColor.rgb * (0.6 + 0.4 * normal.y);
    float3 lit = fragment.color * (sky + _LightColor.rgb * diffuse) + _LightColor.rgb * (0.25 * highlight) + sky * (0.2 * rim * rim * rim);
    return float4(lit, 1.0);
}
