// Headless host: a stand-in, by the same name and properties, for the shader that comes with the editor.
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
        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            Blend Off
            ZWrite On
            ZTest LEqual
            CGPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            #pragma target 3.0
            #pragma shader_feature_local _ _ALPHATEST_ON _ALPHABLEND_ON _ALPHAPREMULTIPLY_ON
            #pragma multi_compile_shadowcaster
            #pragma multi_compile_instancing
            #include "UnityCG.cginc"
            sampler2D _MainTex;
            float4 _MainTex_ST;
            half4 _Color;
            half _Cutoff;

            struct v2f
            {
                V2F_SHADOW_CASTER;
                float2 uv : TEXCOORD1;
            };

            v2f vert(appdata_base v)
            {
                v2f o;
                UNITY_SETUP_INSTANCE_ID(v);
                TRANSFER_SHADOW_CASTER_NORMALOFFSET(o)
                o.uv = TRANSFORM_TEX(v.texcoord, _MainTex);
                return o;
            }

            float4 frag(v2f i) : SV_Target
            {
            #if defined(_ALPHATEST_ON) || defined(_ALPHABLEND_ON) || defined(_ALPHAPREMULTIPLY_ON)
                half alpha = tex2D(_MainTex, i.uv).a * _Color.a;
            #ifdef _ALPHATEST_ON
                clip(alpha - _Cutoff);
            #else
                // Half of the light is half of the texels: an ordered pattern of 4 x 4.
                uint2 at = uint2(i.pos.xy) & 3, bit = at ^ at.yx;
                uint order = (bit.x & 1) << 3 | (at.y & 1) << 2 | (bit.x & 2) | at.y >> 1;
                clip(alpha - (order + 0.5) / 16);
            #endif
            #endif
                SHADOW_CASTER_FRAGMENT(i)
            }
            ENDCG
        }
    }
    Fallback "Legacy Shaders/VertexLit"
}
