// The depth of a mesh for one eye, or for two in one pass: an instance for each, into the slices of an array.
Shader "Tests/Stereo"
{
    SubShader
    {
        Pass
        {
            Tags { "LightMode" = "ShadowCaster" }
            ColorMask 0

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex Vertex
            #pragma fragment Fragment
            float4x4 unity_ObjectToWorld;
            #ifdef STEREO_INSTANCING_ON
            cbuffer UnityStereoGlobals
            {
                float4x4 unity_StereoMatrixP[2];
                float4x4 unity_StereoMatrixV[2];
                float4x4 unity_StereoMatrixInvV[2];
                float4x4 unity_StereoMatrixVP[2];
            };
            #else
            float4x4 unity_MatrixVP;
            #endif

            struct Varyings
            {
                float4 position : SV_Position;
            #ifdef STEREO_INSTANCING_ON
                uint eye : SV_RenderTargetArrayIndex;
            #endif
            };

            Varyings Vertex(float4 position : POSITION, uint instance : SV_InstanceID)
            {
                Varyings o;
                float4 world = mul(unity_ObjectToWorld, position);
            #ifdef STEREO_INSTANCING_ON
                o.position = mul(unity_StereoMatrixVP[instance], world);
                o.eye = instance;
            #else
                o.position = mul(unity_MatrixVP, world);
            #endif
                return o;
            }

            float4 Fragment(Varyings i) : SV_Target { return 0; }
            ENDHLSL
        }
    }
}
