// Spheres in one untagged pass: drawn by the Built-in pipeline and by URP. HDRP, camera-relative, needs a pass of its own.
Shader "Rill/Particles"
{
    SubShader
    {
        Tags { "RenderType" = "Opaque" "Queue" = "Geometry" }
        Pass
        {
            Name "Particles"
            Cull Off
            ZWrite On
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex ParticleVertex
            #pragma fragment ParticleColor
            #pragma multi_compile_local _ RILL_TAGS

            float4x4 unity_MatrixVP;
            float4x4 unity_MatrixV;
            float4 unity_OrthoParams;
            float3 _WorldSpaceCameraPos;
            #define RillWorldToClip(world) mul(unity_MatrixVP, float4(world, 1.0))

            #include "Particles.hlsl"
            ENDHLSL
        }
    }
}
