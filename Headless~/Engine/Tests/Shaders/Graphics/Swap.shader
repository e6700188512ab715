// An image effect: exchanges red and green. Reads the mesh that Blit draws.
Shader "Tests/Swap"
{
    Properties { _MainTex ("Source", 2D) = "white" {} }
    SubShader
    {
        Cull Off ZWrite Off ZTest Always
        Pass
        {
            HLSLPROGRAM
            #pragma vertex Vertex
            #pragma fragment Fragment
            float4x4 unity_MatrixVP;
            float4x4 unity_ObjectToWorld;
            Texture2D _MainTex;
            SamplerState sampler_MainTex;
            struct Varyings { float4 position : SV_POSITION; float2 uv : TEXCOORD0; };
            Varyings Vertex(float4 position : POSITION, float2 uv : TEXCOORD0)
            {
                Varyings o;
                o.position = mul(unity_MatrixVP, mul(unity_ObjectToWorld, position));
                o.uv = uv;
                return o;
            }
            float4 Fragment(Varyings i) : SV_Target { return _MainTex.Sample(sampler_MainTex, i.uv).grba; }
            ENDHLSL
        }
    }
}
