// Glints on the particles of a phase: a quad towards the eye from SV_VertexID. One pass without a tag, which the Built-in pipeline and URP draw.
Shader "Rill Samples/Particle Glints"
{
    Properties
    {
        [HDR] _Color ("Color", Color) = (0.5, 0.9, 1, 1)
        _Radius ("Radius, spacings", Range(0.05, 1)) = 0.3
        _Phase ("Phase", Range(0, 255)) = 1
        _FullSpeed ("Speed of full brightness, m/s", Range(0.1, 10)) = 3
    }
    SubShader
    {
        Tags { "RenderType" = "Transparent" "Queue" = "Transparent+50" }
        Pass
        {
            Blend One One
            ZWrite Off
            Cull Off

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex GlintVertex
            #pragma fragment GlintFragment
            #include "Packages/com.rill.fluids/Shaders/RillParticles.hlsl"

            // The camera, by the names that both pipelines give it.
            float4x4 unity_MatrixVP;
            float4x4 unity_MatrixV;
            float3 _WorldSpaceCameraPos;

            float4 _Color;
            float _Radius;
            float _Phase;
            float _FullSpeed;

            struct Glint
            {
                float4 clip : SV_Position;
                float2 corner : TEXCOORD0;
                nointerpolation float brightness : TEXCOORD1;
            };

            Glint GlintVertex(uint vertex : SV_VertexID)
            {
                uint i = vertex / 6;
                uint k = vertex % 6;
                Glint glint;
                glint.corner = float2(k == 0 || k == 2 || k == 3 ? -1.0 : 1.0, k == 0 || k == 1 || k == 4 ? -1.0 : 1.0);
                glint.brightness = saturate(length(RillVelocity(i)) / _FullSpeed);
                float3 right = unity_MatrixV[0].xyz;
                float3 up = unity_MatrixV[1].xyz;
                float3 toEye = normalize(_WorldSpaceCameraPos - RillDrawnPosition(i));
                float3 world = RillDrawnPosition(i) + (right * glint.corner.x + up * glint.corner.y) * (_Radius * RillSpacing())
                    + toEye * RillSpacing();
                bool isDrawn = i < RillCount() && RillPhase(i) == (uint)_Phase;
                glint.clip = isDrawn ? mul(unity_MatrixVP, float4(world, 1.0)) : float4(2.0, 2.0, 2.0, 1.0);
                return glint;
            }

            float4 GlintFragment(Glint glint) : SV_Target
            {
                float round = saturate(1.0 - dot(glint.corner, glint.corner));
                return float4(_Color.rgb * (round * round * glint.brightness), 1.0);
            }
            ENDHLSL
        }
    }
}
