// The depth of the water's mesh, see WaterDepth.hlsl: a SubShader for each render pipeline. Before its colors.
Shader "Rill/Water Depth"
{
    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.high-definition" : "17.0" }
        Tags { "RenderPipeline" = "HDRenderPipeline" "RenderType" = "Transparent" "Queue" = "Transparent-51" }
        HLSLINCLUDE
        #define RILL_HIGH_DEFINITION 17
        ENDHLSL
        Pass
        {
            Name "Forward"
            Tags { "LightMode" = "ForwardOnly" }
            Cull Back
            ZWrite On
            ZTest LEqual
            ColorMask 0

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex WaterVertex
            #pragma fragment WaterDepthFragment
            #include "WaterDepth.hlsl"
            ENDHLSL
        }
    }
    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.high-definition" : "[14.0,15.0)" }
        Tags { "RenderPipeline" = "HDRenderPipeline" "RenderType" = "Transparent" "Queue" = "Transparent-51" }
        HLSLINCLUDE
        #define RILL_HIGH_DEFINITION 14
        ENDHLSL
        Pass
        {
            Name "Forward"
            Tags { "LightMode" = "ForwardOnly" }
            Cull Back
            ZWrite On
            ZTest LEqual
            ColorMask 0

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex WaterVertex
            #pragma fragment WaterDepthFragment
            #include "WaterDepth.hlsl"
            ENDHLSL
        }
    }
    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.universal" : "14.0" }
        Tags { "RenderPipeline" = "UniversalPipeline" "RenderType" = "Transparent" "Queue" = "Transparent-51" }
        HLSLINCLUDE
        #define RILL_UNIVERSAL
        ENDHLSL
        Pass
        {
            Name "Forward"
            Tags { "LightMode" = "UniversalForwardOnly" }
            Cull Back
            ZWrite On
            ZTest LEqual
            ColorMask 0

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex WaterVertex
            #pragma fragment WaterDepthFragment
            #include "WaterDepth.hlsl"
            ENDHLSL
        }
    }
    SubShader
    {
        Tags { "RenderType" = "Transparent" "Queue" = "Transparent-51" }
        HLSLINCLUDE
        #define RILL_BUILT_IN
        #define RILL_SHADOW_COPY
        ENDHLSL
        Pass
        {
            Name "Forward"
            Tags { "LightMode" = "ForwardBase" }
            Cull Back
            ZWrite On
            ZTest LEqual
            ColorMask 0

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex WaterVertex
            #pragma fragment WaterDepthFragment
            #include "WaterDepth.hlsl"
            ENDHLSL
        }
    }
}
