// View of an eye in the water, see Water.hlsl: a SubShader for each render pipeline. After the mesh.
Shader "Rill/Water Inside"
{
    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.high-definition" : "17.0" }
        Tags { "RenderPipeline" = "HDRenderPipeline" "RenderType" = "Transparent" "Queue" = "Transparent-49" }
        HLSLINCLUDE
        #define RILL_HIGH_DEFINITION 17
        ENDHLSL
        Pass
        {
            Name "Forward"
            Tags { "LightMode" = "ForwardOnly" }
            Cull Off
            ZWrite Off
            ZTest Always
            Blend One OneMinusSrcAlpha
            ColorMask RGBA 0
            ColorMask 0 1      // motion vectors, where the project has transparent draws write them
            ColorMask 0 2

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex UnderWaterVertex
            #pragma fragment UnderWaterFragment
            #pragma multi_compile_local_fragment _ RILL_REFRACTION
            #pragma multi_compile_local_fragment _ RILL_OWN_REFLECTION
            #define RILL_UNDER_WATER
            #include "Water.hlsl"
            ENDHLSL
        }
    }
    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.high-definition" : "[14.0,15.0)" }
        Tags { "RenderPipeline" = "HDRenderPipeline" "RenderType" = "Transparent" "Queue" = "Transparent-49" }
        HLSLINCLUDE
        #define RILL_HIGH_DEFINITION 14
        ENDHLSL
        Pass
        {
            Name "Forward"
            Tags { "LightMode" = "ForwardOnly" }
            Cull Off
            ZWrite Off
            ZTest Always
            Blend One OneMinusSrcAlpha
            ColorMask RGBA 0
            ColorMask 0 1      // motion vectors, where the project has transparent draws write them
            ColorMask 0 2

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex UnderWaterVertex
            #pragma fragment UnderWaterFragment
            #pragma multi_compile_local_fragment _ RILL_REFRACTION
            #pragma multi_compile_local_fragment _ RILL_OWN_REFLECTION
            #define RILL_UNDER_WATER
            #include "Water.hlsl"
            ENDHLSL
        }
    }
    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.universal" : "14.0" }
        Tags { "RenderPipeline" = "UniversalPipeline" "RenderType" = "Transparent" "Queue" = "Transparent-49" }
        HLSLINCLUDE
        #define RILL_UNIVERSAL
        ENDHLSL
        Pass
        {
            Name "Forward"
            Tags { "LightMode" = "UniversalForwardOnly" }
            Cull Off
            ZWrite Off
            ZTest Always
            Blend One OneMinusSrcAlpha

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex UnderWaterVertex
            #pragma fragment UnderWaterFragment
            #pragma multi_compile_local_fragment _ RILL_REFRACTION
            #pragma multi_compile_local_fragment _ RILL_OWN_REFLECTION
            #define RILL_UNDER_WATER
            #include "Water.hlsl"
            ENDHLSL
        }
    }
    SubShader
    {
        Tags { "RenderType" = "Transparent" "Queue" = "Transparent-49" }
        HLSLINCLUDE
        #define RILL_BUILT_IN
        #define RILL_SHADOW_COPY
        ENDHLSL
        Pass
        {
            Name "Forward"
            Tags { "LightMode" = "ForwardBase" }
            Cull Off
            ZWrite Off
            ZTest Always
            Blend One OneMinusSrcAlpha

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex UnderWaterVertex
            #pragma fragment UnderWaterFragment
            #pragma multi_compile_local_fragment _ RILL_REFRACTION
            #pragma multi_compile_local_fragment _ RILL_OWN_REFLECTION
            #define RILL_UNDER_WATER
            #include "Water.hlsl"
            ENDHLSL
        }
    }
}
