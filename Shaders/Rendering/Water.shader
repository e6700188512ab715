// The water's mesh, see Water.hlsl: a SubShader for each render pipeline.
Shader "Rill/Water"
{
    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.high-definition" : "17.0" }
        Tags { "RenderPipeline" = "HDRenderPipeline" "RenderType" = "Transparent" "Queue" = "Transparent-50" }
        HLSLINCLUDE
        #define RILL_HIGH_DEFINITION 17
        ENDHLSL
        Pass
        {
            Name "Forward"
            Tags { "LightMode" = "ForwardOnly" }
            Cull Off
            ZWrite On
            ZTest LEqual
            Blend One OneMinusSrcAlpha
            ColorMask RGBA 0
            ColorMask 0 1      // motion vectors, where the project has transparent draws write them
            ColorMask 0 2

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex WaterVertex
            #pragma fragment WaterFragment
            #pragma multi_compile_local_fragment _ RILL_REFRACTION
            #pragma multi_compile_local_fragment _ RILL_OWN_REFLECTION
            #pragma multi_compile_local_fragment _ RILL_FOAM
            #include "Water.hlsl"
            ENDHLSL
        }
    }
    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.high-definition" : "[14.0,15.0)" }
        Tags { "RenderPipeline" = "HDRenderPipeline" "RenderType" = "Transparent" "Queue" = "Transparent-50" }
        HLSLINCLUDE
        #define RILL_HIGH_DEFINITION 14
        ENDHLSL
        Pass
        {
            Name "Forward"
            Tags { "LightMode" = "ForwardOnly" }
            Cull Off
            ZWrite On
            ZTest LEqual
            Blend One OneMinusSrcAlpha
            ColorMask RGBA 0
            ColorMask 0 1      // motion vectors, where the project has transparent draws write them
            ColorMask 0 2

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex WaterVertex
            #pragma fragment WaterFragment
            #pragma multi_compile_local_fragment _ RILL_REFRACTION
            #pragma multi_compile_local_fragment _ RILL_OWN_REFLECTION
            #pragma multi_compile_local_fragment _ RILL_FOAM
            #include "Water.hlsl"
            ENDHLSL
        }
    }
    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.universal" : "14.0" }
        Tags { "RenderPipeline" = "UniversalPipeline" "RenderType" = "Transparent" "Queue" = "Transparent-50" }
        HLSLINCLUDE
        #define RILL_UNIVERSAL
        ENDHLSL
        Pass
        {
            Name "Forward"
            Tags { "LightMode" = "UniversalForwardOnly" }
            Cull Off
            ZWrite On
            ZTest LEqual
            Blend One OneMinusSrcAlpha

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex WaterVertex
            #pragma fragment WaterFragment
            #pragma multi_compile_fragment _ _MAIN_LIGHT_SHADOWS _MAIN_LIGHT_SHADOWS_CASCADE _MAIN_LIGHT_SHADOWS_SCREEN
            #pragma multi_compile_local_fragment _ RILL_REFRACTION
            #pragma multi_compile_local_fragment _ RILL_OWN_REFLECTION
            #pragma multi_compile_local_fragment _ RILL_FOAM
            #pragma multi_compile _ FOG_LINEAR FOG_EXP FOG_EXP2
            #include "Water.hlsl"
            ENDHLSL
        }
    }
    SubShader
    {
        Tags { "RenderType" = "Transparent" "Queue" = "Transparent-50" }
        HLSLINCLUDE
        #define RILL_BUILT_IN
        #define RILL_SHADOW_COPY
        ENDHLSL
        Pass
        {
            Name "Forward"
            Tags { "LightMode" = "ForwardBase" }
            Cull Off
            ZWrite On
            ZTest LEqual
            Blend One OneMinusSrcAlpha

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex WaterVertex
            #pragma fragment WaterFragment
            #pragma multi_compile_local_fragment _ RILL_REFRACTION
            #pragma multi_compile_local_fragment _ RILL_OWN_REFLECTION
            #pragma multi_compile_local_fragment _ RILL_FOAM
            #pragma multi_compile _ FOG_LINEAR FOG_EXP FOG_EXP2
            #include "Water.hlsl"
            ENDHLSL
        }
    }
}
