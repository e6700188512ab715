// Surfaces that the fluid has wetted, see Wetness.hlsl: a SubShader for each render pipeline. Drawn by the package's own passes alone.
Shader "Hidden/Rill/Wetness"
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
            Name "Wetness"
            Cull Off
            ZWrite Off
            ZTest Always
            Blend One SrcAlpha, Zero One

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex SurfaceVertex
            #pragma fragment WetFragment
            #include "Wetness.hlsl"
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
            Name "Wetness"
            Cull Off
            ZWrite Off
            ZTest Always
            Blend One SrcAlpha, Zero One

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex SurfaceVertex
            #pragma fragment WetFragment
            #include "Wetness.hlsl"
            ENDHLSL
        }
    }
    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.universal" : "14.0" }
        Tags { "RenderPipeline" = "UniversalPipeline" }
        HLSLINCLUDE
        #define RILL_UNIVERSAL
        ENDHLSL
        Pass
        {
            Name "Wetness"
            Cull Off
            ZWrite Off
            ZTest Always
            Blend One SrcAlpha, Zero One

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex SurfaceVertex
            #pragma fragment WetFragment
            #include "Wetness.hlsl"
            ENDHLSL
        }
    }
    SubShader
    {
        HLSLINCLUDE
        #define RILL_BUILT_IN
        ENDHLSL
        Pass
        {
            Name "Wetness"
            Cull Off
            ZWrite Off
            ZTest Always
            Blend One SrcAlpha, Zero One

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex SurfaceVertex
            #pragma fragment WetFragment
            #include "Wetness.hlsl"
            ENDHLSL
        }
    }
}
