// A plain lit surface for what stands in the water. One untagged pass, as Rill/Particles: drawn by the Built-in pipeline and by
// URP, in the light of a material's own sun. See-through: alpha below 1, Source 5, Destination 10, Depth 0, queue 3000.
Shader "Rill/Solid"
{
    Properties
    {
        _Color ("Color", Color) = (0.7, 0.7, 0.7, 1)
        _Ambient ("Ambient", Color) = (0.42, 0.47, 0.55, 1)
        _Sun ("Direction to the Sun", Vector) = (0.3, 0.9, -0.3, 0)
        [Enum(UnityEngine.Rendering.CullMode)] _Cull ("Cull", Float) = 2
        [Enum(UnityEngine.Rendering.BlendMode)] _SrcBlend ("Source", Float) = 1
        [Enum(UnityEngine.Rendering.BlendMode)] _DstBlend ("Destination", Float) = 0
        _ZWrite ("Depth", Float) = 1
    }
    SubShader
    {
        Tags { "RenderType" = "Opaque" "Queue" = "Geometry" }
        Pass
        {
            Name "Solid"
            Cull [_Cull]
            Blend [_SrcBlend] [_DstBlend]
            ZWrite [_ZWrite]
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex SolidVertex
            #pragma fragment SolidColor

            float4x4 unity_MatrixVP;
            float4x4 unity_ObjectToWorld;
            float4x4 unity_WorldToObject;
            float4 _Color;
            float4 _Ambient;
            float4 _Sun;                // world; any length

            struct Fragment
            {
                float4 clip : SV_Position;
                float3 normal : TEXCOORD0;      // world
            };

            Fragment SolidVertex(float3 position : POSITION, float3 normal : NORMAL)
            {
                Fragment result;
                result.clip = mul(unity_MatrixVP, mul(unity_ObjectToWorld, float4(position, 1.0)));
                result.normal = mul(normal, (float3x3)unity_WorldToObject);
                return result;
            }

            float4 SolidColor(Fragment fragment, bool isFront : SV_IsFrontFace) : SV_Target
            {
                float3 normal = fragment.normal * rsqrt(max(dot(fragment.normal, fragment.normal), 1e-20));
                float3 sun = _Sun.xyz * rsqrt(max(dot(_Sun.xyz, _Sun.xyz), 1e-20));
                float light = saturate(dot(isFront ? normal : -normal, sun));
                return float4(_Color.rgb * min(_Ambient.rgb + 0.75 * light, 1.0), _Color.a);
            }
            ENDHLSL
        }
    }
}
