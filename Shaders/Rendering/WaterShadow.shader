// Shadows of the water that is drawn as a mesh, see WaterShadow.hlsl: a SubShader for each render pipeline.
Shader "Hidden/Rill/WaterShadow"
{
    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.high-definition" : "17.0" }
        Tags { "RenderPipeline" = "HDRenderPipeline" "RenderType" = "Opaque" "Queue" = "Geometry" }
        HLSLINCLUDE
        #define RILL_HIGH_DEFINITION 17
        ENDHLSL
        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            Cull Front
            ZWrite On
            ZTest LEqual
            ZClip [_ZClip]
            ColorMask 0

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex ShadowVertex
            #pragma fragment ShadowFragment
            #include "WaterShadow.hlsl"
            ENDHLSL
        }
    }
    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.high-definition" : "[14.0,15.0)" }
        Tags { "RenderPipeline" = "HDRenderPipeline" "RenderType" = "Opaque" "Queue" = "Geometry" }
        HLSLINCLUDE
        #define RILL_HIGH_DEFINITION 14
        ENDHLSL
        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            Cull Front
            ZWrite On
            ZTest LEqual
            ZClip [_ZClip]
            ColorMask 0

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex ShadowVertex
            #pragma fragment ShadowFragment
            #include "WaterShadow.hlsl"
            ENDHLSL
        }
    }
    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.universal" : "14.0" }
        Tags { "RenderPipeline" = "UniversalPipeline" "RenderType" = "Opaque" "Queue" = "Geometry" }
        HLSLINCLUDE
        #define RILL_UNIVERSAL
        ENDHLSL
        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            Cull Front
            ZWrite On
            ZTest LEqual
            ColorMask 0

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex ShadowVertex
            #pragma fragment ShadowFragment
            #include "WaterShadow.hlsl"
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
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            Cull Front
            ZWrite On
            ZTest LEqual
            ColorMask 0

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex ShadowVertex
            #pragma fragment ShadowFragment
            #include "WaterShadow.hlsl"
            ENDHLSL
        }
    }
}
