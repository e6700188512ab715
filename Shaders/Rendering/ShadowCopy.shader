// Copies the shadow of the Built-in pipeline, by pass number, see ShadowCopy.hlsl. No pipeline draws with it.
Shader "Hidden/Rill/ShadowCopy"
{
    SubShader
    {
        Pass
        {
            Name "ShadowMapCopy"
            Cull Off
            ZWrite Off
            ZTest Always

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex ShadowCopyVertex
            #pragma fragment ShadowMapFragment
            #define RILL_SHADOW_MAP
            #include "ShadowCopy.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "ShadowValuesCopy"
            Cull Off
            ZWrite Off
            ZTest Always

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex ShadowCopyVertex
            #pragma fragment ShadowValueFragment
            #include "ShadowCopy.hlsl"
            ENDHLSL
        }
    }
}
