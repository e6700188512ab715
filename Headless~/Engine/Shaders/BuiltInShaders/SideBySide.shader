// Headless host only: the two slices of an array beside each other.
Shader "Hidden/Headless/SideBySide"
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

            Texture2DArray _Eyes;

            float4 Vertex(uint vertex : SV_VertexID) : SV_Position
            {
                return float4(vertex == 1 ? 3.0 : -1.0, vertex == 2 ? 3.0 : -1.0, 0.5, 1.0);
            }

            float4 Fragment(float4 at : SV_Position) : SV_Target
            {
                uint width, height, slices;
                _Eyes.GetDimensions(width, height, slices);
                uint eye = (uint)at.x < width ? 0 : 1;
                return _Eyes.Load(int4((uint)at.x - eye * width, at.y, eye, 0));
            }
            ENDHLSL
        }
    }
}
