// Foam, see FoamParticles.hlsl: a SubShader for each render pipeline. Transparent and without depth: it has no other passes.
Shader "Rill/Foam"
{
    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.high-definition" : "17.0" }
        Tags { "RenderPipeline" = "HDRenderPipeline" "RenderType" = "Transparent" "Queue" = "Transparent" }
        HLSLINCLUDE
        #define RILL_HIGH_DEFINITION 17
        ENDHLSL
        Pass
        {
            Name "Forward"
            Tags { "LightMode" = "ForwardOnly" }
            Cull Off
            ZWrite Off
            ZTest LEqual
            Blend SrcAlpha OneMinusSrcAlpha, One OneMinusSrcAlpha

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex FoamVertex
            #pragma fragment FoamFragment
            #include "FoamParticles.hlsl"
            ENDHLSL
        }
    }
    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.high-definition" : "[14.0,15.0)" }
        Tags { "RenderPipeline" = "HDRenderPipeline" "RenderType" = "Transparent" "Queue" = "Transparent" }
        HLSLINCLUDE
        #define RILL_HIGH_DEFINITION 14
        ENDHLSL
        Pass
        {
            Name "Forward"
            Tags { "LightMode" = "ForwardOnly" }
            Cull Off
            ZWrite Off
            ZTest LEqual
            Blend SrcAlpha OneMinusSrcAlpha, One OneMinusSrcAlpha

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex FoamVertex
            #pragma fragment FoamFragment
            #include "FoamParticles.hlsl"
            ENDHLSL
        }
    }
    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.universal" : "14.0" }
        Tags { "RenderPipeline" = "UniversalPipeline" "RenderType" = "Transparent" "Queue" = "Transparent" "UniversalMaterialType" = "Unlit" }
        HLSLINCLUDE
        #define RILL_UNIVERSAL
        ENDHLSL
        Pass
        {
            Name "Forward"
            Tags { "LightMode" = "UniversalForwardOnly" }
            Cull Off
            ZWrite Off
            ZTest LEqual
            Blend SrcAlpha OneMinusSrcAlpha, One OneMinusSrcAlpha

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex FoamVertex
            #pragma fragment FoamFragment
            #pragma multi_compile_fragment _ _MAIN_LIGHT_SHADOWS _MAIN_LIGHT_SHADOWS_CASCADE
            #include "FoamParticles.hlsl"
            ENDHLSL
        }
    }
    SubShader
    {
        Tags { "RenderType" = "Transparent" "Queue" = "Transparent" }
        HLSLINCLUDE
        #define RILL_BUILT_IN
        ENDHLSL
        Pass
        {
            Name "Forward"
            Tags { "LightMode" = "ForwardBase" }
            Cull Off
            ZWrite Off
            ZTest LEqual
            Blend SrcAlpha OneMinusSrcAlpha, One OneMinusSrcAlpha

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex FoamVertex
            #pragma fragment FoamFragment
            #include "FoamParticles.hlsl"
            ENDHLSL
        }
    }
}
