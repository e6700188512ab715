// Headless host: copies one slice of an array, or the first part of it.
Shader "Hidden/Headless/BlitCopyArray"
{
    SubShader
    {
        Pass
        {
            ZTest Always
            ZWrite Off
            Cull Off

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex Vertex
            #pragma fragment Fragment

            Texture2DArray _MainTex;
            SamplerState sampler_MainTex;
            float4x4 unity_MatrixVP;
            float _Slice;
            float4 _Part;           // xy: of the width and height that is copied

            struct Varyings
            {
                float4 position : SV_Position;
                float2 uv : TEXCOORD0;
            };

            Varyings Vertex(float3 position : POSITION, float2 uv : TEXCOORD0)
            {
                Varyings o;
                o.position = mul(unity_MatrixVP, float4(position, 1));
                o.uv = uv * _Part.xy;
                return o;
            }

            float4 Fragment(Varyings i) : SV_Target
            {
                return _MainTex.Sample(sampler_MainTex, float3(i.uv, _Slice));
            }
            ENDHLSL
        }
    }
}
