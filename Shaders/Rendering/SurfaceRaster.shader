// What FluidSurfaceRecorder draws into the textures of the water's surface, by pass number, see SurfaceRaster.hlsl,
// SceneDistance.hlsl and ShadowCopy.hlsl. No pipeline draws with it.
Shader "Hidden/Rill/SurfaceRaster"
{
    SubShader
    {
        Pass
        {
            Name "SurfaceDepth"
            Cull Off
            ZWrite On
            ZTest LEqual
            ColorMask 0

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex RasterVertex
            #pragma fragment DepthFragment
            #include "SurfaceRaster.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "SceneDistance"
            Cull Off
            ZWrite Off
            ZTest Always

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex SceneVertex
            #pragma fragment SceneFragment
            #pragma multi_compile_local_fragment _ RILL_SCENE_ARRAY
            #include "SceneDistance.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "SurfaceDepthAndChords"
            Cull Off
            ZWrite On
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex RasterVertex
            #pragma fragment ChordFragment
            #define RILL_CHORDS
            #include "SurfaceRaster.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "ShadowMapCopy"
            Cull Off
            ZWrite Off
            ZTest Always

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex ShadowCopyVertex
            #pragma fragment ShadowMapFragment
            #define RILL_SHADOW_MAP
            #include "ShadowCopy.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "ShadowValuesCopy"
            Cull Off
            ZWrite Off
            ZTest Always

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex ShadowCopyVertex
            #pragma fragment ShadowValueFragment
            #include "ShadowCopy.hlsl"
            ENDHLSL
        }
    }
}
