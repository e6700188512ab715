// Draws a mesh with its vertex colors; uv goes to blue so that attributes can be told apart.
Shader "Tests/Mesh"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
            #pragma vertex Vertex
            #pragma fragment Fragment
            float4x4 unity_MatrixVP;
            float4x4 unity_ObjectToWorld;
            struct Attributes { float4 position : POSITION; float4 color : COLOR; float2 uv : TEXCOORD0; };
            struct Varyings { float4 position : SV_POSITION; float4 color : COLOR; float2 uv : TEXCOORD0; };
            Varyings Vertex(Attributes v)
            {
                Varyings o;
                o.position = mul(unity_MatrixVP, mul(unity_ObjectToWorld, v.position));
                o.color = v.color;
                o.uv = v.uv;
                return o;
            }
            float4 Fragment(Varyings i) : SV_Target { return float4(i.color.rg, i.uv.x, 1); }
            ENDHLSL
        }
    }
}
