// A plain lit surface for what stands in the water: a SubShader for each render pipeline, with the passes that it asks for.
// See-through: alpha below 1, Source 5, Destination 10, Depth 0, queue 3000.
Shader "Rill/Solid"
{
    Properties
    {
        _Color ("Color", Color) = (0.7, 0.7, 0.7, 1)
        _Ambient ("Ambient", Color) = (0.42, 0.47, 0.55, 1)
        _SunDirection ("Direction to a Light of Its Own (W 1)", Vector) = (0.3, 0.9, -0.3, 0)
        _SunColor ("Color of That Light", Color) = (1, 1, 1, 1)
        _Tile ("Tiles, Side in m (0 None)", Float) = 0
        [ToggleUI] _ReceiveShadows ("Receive Shadows", Float) = 1
        [Enum(UnityEngine.Rendering.CullMode)] _Cull ("Cull", Float) = 2
        [Enum(UnityEngine.Rendering.BlendMode)] _SrcBlend ("Source", Float) = 1
        [Enum(UnityEngine.Rendering.BlendMode)] _DstBlend ("Destination", Float) = 0
        _ZWrite ("Depth", Float) = 1
    }
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
            Cull [_Cull]
            Blend [_SrcBlend] [_DstBlend]
            ZWrite [_ZWrite]
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex SolidVertex
            #pragma fragment SolidFragment
            #define RILL_PASS_FORWARD
            #include "Solid.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "DepthForwardOnly"
            Tags { "LightMode" = "DepthForwardOnly" }
            Cull [_Cull]
            ZWrite On
            ZTest LEqual
            ColorMask 0

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex SolidVertex
            #pragma fragment SolidFragment
            #define RILL_PASS_DEPTH
            #include "Solid.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            Cull [_Cull]
            ZWrite On
            ZTest LEqual
            ZClip [_ZClip]
            ColorMask 0

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex SolidVertex
            #pragma fragment SolidFragment
            #define RILL_PASS_SHADOW
            #include "Solid.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "MotionVectors"
            Tags { "LightMode" = "MotionVectors" }
            Cull [_Cull]
            ZWrite On
            ZTest LEqual
            Stencil { Ref 32 WriteMask 32 Comp Always Pass Replace }

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex SolidVertex
            #pragma fragment SolidFragment
            #define RILL_PASS_MOTION
            #include "Solid.hlsl"
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
            Cull [_Cull]
            Blend [_SrcBlend] [_DstBlend]
            ZWrite [_ZWrite]
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex SolidVertex
            #pragma fragment SolidFragment
            #define RILL_PASS_FORWARD
            #include "Solid.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "DepthForwardOnly"
            Tags { "LightMode" = "DepthForwardOnly" }
            Cull [_Cull]
            ZWrite On
            ZTest LEqual
            ColorMask 0

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex SolidVertex
            #pragma fragment SolidFragment
            #define RILL_PASS_DEPTH
            #include "Solid.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            Cull [_Cull]
            ZWrite On
            ZTest LEqual
            ZClip [_ZClip]
            ColorMask 0

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex SolidVertex
            #pragma fragment SolidFragment
            #define RILL_PASS_SHADOW
            #include "Solid.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "MotionVectors"
            Tags { "LightMode" = "MotionVectors" }
            Cull [_Cull]
            ZWrite On
            ZTest LEqual
            Stencil { Ref 32 WriteMask 32 Comp Always Pass Replace }

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex SolidVertex
            #pragma fragment SolidFragment
            #define RILL_PASS_MOTION
            #include "Solid.hlsl"
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
            Cull [_Cull]
            Blend [_SrcBlend] [_DstBlend]
            ZWrite [_ZWrite]
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex SolidVertex
            #pragma fragment SolidFragment
            #pragma multi_compile_fragment _ _MAIN_LIGHT_SHADOWS _MAIN_LIGHT_SHADOWS_CASCADE _MAIN_LIGHT_SHADOWS_SCREEN
            #define RILL_PASS_FORWARD
            #include "Solid.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "DepthOnly"
            Tags { "LightMode" = "DepthOnly" }
            Cull [_Cull]
            ZWrite On
            ZTest LEqual
            ColorMask R

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex SolidVertex
            #pragma fragment SolidFragment
            #define RILL_PASS_DEPTH
            #include "Solid.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "DepthNormals"
            Tags { "LightMode" = "DepthNormalsOnly" }
            Cull [_Cull]
            ZWrite On
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex SolidVertex
            #pragma fragment SolidFragment
            #pragma multi_compile_fragment _ _GBUFFER_NORMALS_OCT
            #define RILL_PASS_NORMALS
            #include "Solid.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            Cull [_Cull]
            ZWrite On
            ZTest LEqual
            ColorMask 0

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex SolidVertex
            #pragma fragment SolidFragment
            #define RILL_PASS_SHADOW
            #include "Solid.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "MotionVectors"
            Tags { "LightMode" = "MotionVectors" }
            Cull [_Cull]
            ZWrite On
            ZTest LEqual
            ColorMask RG

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex SolidVertex
            #pragma fragment SolidFragment
            #define RILL_PASS_MOTION
            #include "Solid.hlsl"
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
            Cull [_Cull]
            Blend [_SrcBlend] [_DstBlend]
            ZWrite [_ZWrite]
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex SolidVertex
            #pragma fragment SolidFragment
            #pragma multi_compile_fragment _ SHADOWS_SCREEN
            #define RILL_PASS_FORWARD
            #include "Solid.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            Cull [_Cull]
            ZWrite On
            ZTest LEqual
            ColorMask 0

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex SolidVertex
            #pragma fragment SolidFragment
            #define RILL_PASS_SHADOW
            #include "Solid.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "MotionVectors"
            Tags { "LightMode" = "MotionVectors" }
            Cull [_Cull]
            ZWrite Off
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex SolidVertex
            #pragma fragment SolidFragment
            #define RILL_PASS_MOTION
            #include "Solid.hlsl"
            ENDHLSL
        }
    }
}
