// Of the headless host: a stand-in, by the same name and properties, for the shader that comes with the editor.
Shader "Standard"
{
    Properties
    {
        _Color ("Color", Color) = (1, 1, 1, 1)
        _MainTex ("Albedo", 2D) = "white" {}
        _Cutoff ("Alpha Cutoff", Range(0, 1)) = 0.5
        _Glossiness ("Smoothness", Range(0, 1)) = 0.5
        _GlossMapScale ("Smoothness Scale", Range(0, 1)) = 1
        _SmoothnessTextureChannel ("Smoothness texture channel", Float) = 0
        _Metallic ("Metallic", Range(0, 1)) = 0
        _MetallicGlossMap ("Metallic", 2D) = "white" {}
        _BumpScale ("Scale", Float) = 1
        _BumpMap ("Normal Map", 2D) = "bump" {}
        _OcclusionStrength ("Strength", Range(0, 1)) = 1
        _OcclusionMap ("Occlusion", 2D) = "white" {}
        _EmissionColor ("Color", Color) = (0, 0, 0)
        _EmissionMap ("Emission", 2D) = "white" {}
        _Mode ("Mode", Float) = 0
        _SrcBlend ("Source", Float) = 1
        _DstBlend ("Destination", Float) = 0
        _ZWrite ("Depth", Float) = 1
    }
    SubShader
    {
        Tags { "RenderType" = "Opaque" "PerformanceChecks" = "False" }
        Blend [_SrcBlend] [_DstBlend]
        ZWrite [_ZWrite]
        CGPROGRAM
        #pragma surface surf Standard keepalpha finalcolor:Opacity
        #pragma target 3.0
        #pragma shader_feature_local _NORMALMAP
        #pragma shader_feature_local _ _ALPHATEST_ON _ALPHABLEND_ON _ALPHAPREMULTIPLY_ON
        #pragma shader_feature _EMISSION
        #pragma shader_feature_local _METALLICGLOSSMAP
        sampler2D _MainTex, _BumpMap, _OcclusionMap, _EmissionMap, _MetallicGlossMap;
        half4 _Color, _EmissionColor;
        half _Cutoff, _Glossiness, _GlossMapScale, _BumpScale, _OcclusionStrength, _Metallic;

        struct Input { float2 uv_MainTex; };

        void surf(Input IN, inout SurfaceOutputStandard o)
        {
            half4 c = tex2D(_MainTex, IN.uv_MainTex) * _Color;
        #ifdef _ALPHATEST_ON
            clip(c.a - _Cutoff);
        #endif
            o.Albedo = c.rgb;
            o.Alpha = c.a;
        #ifdef _NORMALMAP
            o.Normal = UnpackNormalWithScale(tex2D(_BumpMap, IN.uv_MainTex), _BumpScale);
        #endif
        #ifdef _METALLICGLOSSMAP
            half4 gloss = tex2D(_MetallicGlossMap, IN.uv_MainTex);
            o.Metallic = gloss.r;
            o.Smoothness = gloss.a * _GlossMapScale;
        #else
            o.Metallic = _Metallic;
            o.Smoothness = _Glossiness;
        #endif
            o.Occlusion = lerp(1, tex2D(_OcclusionMap, IN.uv_MainTex).g, _OcclusionStrength);
        #ifdef _EMISSION
            o.Emission = tex2D(_EmissionMap, IN.uv_MainTex).rgb * _EmissionColor.rgb;
        #endif
        }

        void Opacity(Input IN, SurfaceOutputStandard o, inout half4 color)
        {
        #if !defined(_ALPHABLEND_ON) && !defined(_ALPHAPREMULTIPLY_ON)
            color.a = 1;
        #endif
        }
        ENDCG
    }
}
