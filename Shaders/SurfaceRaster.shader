// What FluidSurfaceRecorder draws into the textures of the water's surface, by pass number, see SurfaceRaster.hlsl. No pipeline
// draws with it.
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
            #define RILL_PASS_DEPTH
            #include "SurfaceRaster.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "SurfaceThickness"
            Cull Off
            ZWrite Off
            ZTest Always
            Blend One One

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex RasterVertex
            #pragma fragment ThicknessFragment
            #pragma multi_compile_local_fragment _ RILL_SCENE_ARRAY
            #define RILL_PASS_THICKNESS
            #include "SurfaceRaster.hlsl"
            ENDHLSL
        }
    }
}
