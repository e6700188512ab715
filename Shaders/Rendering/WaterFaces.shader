// Draws for each camera, by pass number, that come before the water's rays are followed, see WaterFaces.hlsl. No pipeline draws with it.
Shader "Hidden/Rill/WaterFaces"
{
    SubShader
    {
        Pass
        {
            Name "Faces"
            Cull Back
            ZWrite On
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex FaceVertex
            #pragma fragment FaceFragment
            #include "WaterFaces.hlsl"
            ENDHLSL
        }
        Pass
        {
            Name "SceneCopy"
            Cull Off
            ZWrite Off
            ZTest Always

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex CopyVertex
            #pragma fragment CopyFragment
            #pragma multi_compile_local_fragment _ RILL_SCENE_ARRAY
            #include "WaterFaces.hlsl"
            ENDHLSL
        }
    }
}
