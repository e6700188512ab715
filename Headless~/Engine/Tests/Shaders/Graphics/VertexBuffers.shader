Shader "Tests/VertexBuffers"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex Vertex
            #pragma fragment Fragment
            StructuredBuffer<float4> _At0;
            StructuredBuffer<float4> _At1;
            StructuredBuffer<float4> _At2;
            StructuredBuffer<float4> _At3;
            StructuredBuffer<float4> _At4;
            StructuredBuffer<float4> _At5;
            StructuredBuffer<float4> _At6;
            StructuredBuffer<float4> _At7;
            StructuredBuffer<float4> _At8;
            float4 Vertex(uint id : SV_VertexID)
                : SV_Position { return _At0[id] + _At1[id] + _At2[id] + _At3[id] + _At4[id] + _At5[id] + _At6[id] + _At7[id] + _At8[id]; }
            float4 Fragment() : SV_Target { return 1; }
            ENDHLSL
        }
    }
}
