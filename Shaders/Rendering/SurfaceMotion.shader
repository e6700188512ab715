// Motion vectors of the water's surface, see SurfaceMotion.hlsl: a SubShader for each render pipeline that has them. In URP among the opaque
// objects, which alone it asks for motion; in HDRP drawn by the adapter's own pass alone.
Shader "Hidden/Rill/SurfaceMotion"
{
    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.high-definition" : "17.0" }
        Tags { "RenderPipeline" = "HDRenderPipeline" }
        HLSLINCLUDE
        #define RILL_HIGH_DEFINITION 17
        ENDHLSL
        Pass
        {
            Name "SurfaceMotion"
            Cull Off
            ZWrite Off
            ZTest Always
            ColorMask RG

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex SurfaceVertex
            #pragma fragment MotionFragment
            #include "SurfaceMotion.hlsl"
            ENDHLSL
        }
    }
    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.high-definition" : "[14.0,15.0)" }
        Tags { "RenderPipeline" = "HDRenderPipeline" }
        HLSLINCLUDE
        #define RILL_HIGH_DEFINITION 14
        ENDHLSL
        Pass
        {
            Name "SurfaceMotion"
            Cull Off
            ZWrite Off
            ZTest Always
            ColorMask RG

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex SurfaceVertex
            #pragma fragment MotionFragment
            #include "SurfaceMotion.hlsl"
            ENDHLSL
        }
    }
    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.universal" : "14.0" }
        Tags { "RenderPipeline" = "UniversalPipeline" "RenderType" = "Opaque" "Queue" = "Geometry" "AlwaysRenderMotionVectors" = "true" }
        HLSLINCLUDE
        #define RILL_UNIVERSAL
        ENDHLSL
        Pass
        {
            Name "MotionVectors"
            Tags { "LightMode" = "MotionVectors" }
            Cull Off
            ZWrite On
            ZTest LEqual
            ColorMask RG

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex SurfaceVertex
            #pragma fragment MotionFragment
            #include "SurfaceMotion.hlsl"
            ENDHLSL
        }
    }
    SubShader
    {
        Tags { "RenderType" = "Opaque" "Queue" = "Geometry" }
        HLSLINCLUDE
        #define RILL_BUILT_IN
        ENDHLSL
        Pass
        {
            Name "MotionVectors"
            Tags { "LightMode" = "MotionVectors" }
            Cull Off
            ZWrite On
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex SurfaceVertex
            #pragma fragment MotionFragment
            #include "SurfaceMotion.hlsl"
            ENDHLSL
        }
    }
}
