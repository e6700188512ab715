// Shader "Not/This"
Shader "Fixtures/Flat"
{
    Properties
    {
        _Color ("Tint", Color) = (1, 1, 1, 1)
        _Direction ("Direction", Vector) = (0, 0, 0, 0)
        _Gloss ("Gloss", Range(0, 1)) = 0.5
        _MainTex ("Texture", 2D) = "white" {}
    }
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment Frag
            #pragma multi_compile_local _ FOAM
            float4 _Color;
            float4 Vert(uint id : SV_VertexID) : SV_Position { return float4(id & 1, id >> 1, 0, 1); }
            float4 Frag() : SV_Target { return _Color; }
            ENDHLSL
        }
    }
}
