// Glints on the particles of a phase, see ParticleGlints.hlsl: a SubShader for each render pipeline.
Shader "Rill Samples/Particle Glints"
{
    Properties
    {
        [HDR] _Color ("Color", Color) = (0.5, 0.9, 1, 1)
        _Radius ("Radius, spacings", Range(0.05, 1)) = 0.3
        _Phase ("Phase", Range(0, 255)) = 1
        _FullSpeed ("Speed of full brightness, m/s", Range(0.1, 10)) = 3
    }
    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.high-definition" : "17.0" }
        Tags { "RenderPipeline" = "HDRenderPipeline" "RenderType" = "Transparent" "Queue" = "Transparent+50" }
        Pass
        {
            Tags { "LightMode" = "ForwardOnly" }
            Blend One One
            ZWrite Off
            Cull Off

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex GlintVertex
            #pragma fragment GlintFragment
            #define RILL_HIGH_DEFINITION 17
            #include "ParticleGlints.hlsl"
            ENDHLSL
        }
    }
    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.high-definition" : "[14.0,15.0)" }
        Tags { "RenderPipeline" = "HDRenderPipeline" "RenderType" = "Transparent" "Queue" = "Transparent+50" }
        Pass
        {
            Tags { "LightMode" = "ForwardOnly" }
            Blend One One
            ZWrite Off
            Cull Off

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex GlintVertex
            #pragma fragment GlintFragment
            #define RILL_HIGH_DEFINITION 14
            #include "ParticleGlints.hlsl"
            ENDHLSL
        }
    }
    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.universal" : "14.0" }
        Tags { "RenderPipeline" = "UniversalPipeline" "RenderType" = "Transparent" "Queue" = "Transparent+50" }
        Pass
        {
            Tags { "LightMode" = "UniversalForwardOnly" }
            Blend One One
            ZWrite Off
            Cull Off

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex GlintVertex
            #pragma fragment GlintFragment
            #define RILL_UNIVERSAL
            #include "ParticleGlints.hlsl"
            ENDHLSL
        }
    }
    SubShader
    {
        Tags { "RenderType" = "Transparent" "Queue" = "Transparent+50" }
        Pass
        {
            Blend One One
            ZWrite Off
            Cull Off

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex GlintVertex
            #pragma fragment GlintFragment
            #define RILL_BUILT_IN
            #include "ParticleGlints.hlsl"
            ENDHLSL
        }
    }
}
