// The fluid's box, see Domain.hlsl: a SubShader for each render pipeline, with the passes that it asks for.
Shader "Rill/Domain"
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
            Name "Forward"
            Tags { "LightMode" = "ForwardOnly" }
            Cull Off
            ZWrite On
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex DomainVertex
            #pragma fragment DomainFragment
            #define RILL_PASS_FORWARD
            #include "Domain.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "DepthForwardOnly"
            Tags { "LightMode" = "DepthForwardOnly" }
            Cull Off
            ZWrite On
            ZTest LEqual
            ColorMask 0

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex DomainVertex
            #pragma fragment DomainFragment
            #define RILL_PASS_DEPTH
            #include "Domain.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            Cull Off
            ZWrite On
            ZTest LEqual
            ZClip [_ZClip]
            ColorMask 0

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex DomainVertex
            #pragma fragment DomainFragment
            #define RILL_PASS_SHADOW
            #include "Domain.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "MotionVectors"
            Tags { "LightMode" = "MotionVectors" }
            Cull Off
            ZWrite On
            ZTest LEqual
            Stencil { Ref 32 WriteMask 32 Comp Always Pass Replace }

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex DomainVertex
            #pragma fragment DomainFragment
            #define RILL_PASS_MOTION
            #include "Domain.hlsl"
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
            Name "Forward"
            Tags { "LightMode" = "ForwardOnly" }
            Cull Off
            ZWrite On
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex DomainVertex
            #pragma fragment DomainFragment
            #define RILL_PASS_FORWARD
            #include "Domain.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "DepthForwardOnly"
            Tags { "LightMode" = "DepthForwardOnly" }
            Cull Off
            ZWrite On
            ZTest LEqual
            ColorMask 0

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex DomainVertex
            #pragma fragment DomainFragment
            #define RILL_PASS_DEPTH
            #include "Domain.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            Cull Off
            ZWrite On
            ZTest LEqual
            ZClip [_ZClip]
            ColorMask 0

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex DomainVertex
            #pragma fragment DomainFragment
            #define RILL_PASS_SHADOW
            #include "Domain.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "MotionVectors"
            Tags { "LightMode" = "MotionVectors" }
            Cull Off
            ZWrite On
            ZTest LEqual
            Stencil { Ref 32 WriteMask 32 Comp Always Pass Replace }

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex DomainVertex
            #pragma fragment DomainFragment
            #define RILL_PASS_MOTION
            #include "Domain.hlsl"
            ENDHLSL
        }
    }
    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.universal" : "14.0" }
        Tags
        {
            "RenderPipeline" = "UniversalPipeline" "RenderType" = "Opaque" "Queue" = "Geometry"
            "UniversalMaterialType" = "Unlit" "AlwaysRenderMotionVectors" = "true"
        }
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

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex DomainVertex
            #pragma fragment DomainFragment
            #pragma multi_compile_fragment _ _MAIN_LIGHT_SHADOWS _MAIN_LIGHT_SHADOWS_CASCADE _MAIN_LIGHT_SHADOWS_SCREEN
            #define RILL_PASS_FORWARD
            #include "Domain.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "DepthOnly"
            Tags { "LightMode" = "DepthOnly" }
            Cull Off
            ZWrite On
            ZTest LEqual
            ColorMask R

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex DomainVertex
            #pragma fragment DomainFragment
            #define RILL_PASS_DEPTH
            #include "Domain.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "DepthNormals"
            Tags { "LightMode" = "DepthNormalsOnly" }
            Cull Off
            ZWrite On
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex DomainVertex
            #pragma fragment DomainFragment
            #pragma multi_compile_fragment _ _GBUFFER_NORMALS_OCT
            #define RILL_PASS_NORMALS
            #include "Domain.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            Cull Off
            ZWrite On
            ZTest LEqual
            ColorMask 0

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex DomainVertex
            #pragma fragment DomainFragment
            #define RILL_PASS_SHADOW
            #include "Domain.hlsl"
            ENDHLSL
        }
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
            #pragma vertex DomainVertex
            #pragma fragment DomainFragment
            #define RILL_PASS_MOTION
            #include "Domain.hlsl"
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
            Name "Forward"
            Tags { "LightMode" = "ForwardBase" }
            Cull Off
            ZWrite On
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex DomainVertex
            #pragma fragment DomainFragment
            #pragma multi_compile_fragment _ SHADOWS_SCREEN
            #define RILL_PASS_FORWARD
            #include "Domain.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            Cull Off
            ZWrite On
            ZTest LEqual
            ColorMask 0

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex DomainVertex
            #pragma fragment DomainFragment
            #define RILL_PASS_SHADOW
            #include "Domain.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "MotionVectors"
            Tags { "LightMode" = "MotionVectors" }
            Cull Off
            ZWrite Off
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex DomainVertex
            #pragma fragment DomainFragment
            #define RILL_PASS_MOTION
            #include "Domain.hlsl"
            ENDHLSL
        }
    }
}
