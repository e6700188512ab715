// Of the headless host: a stand-in, by the same name and properties, for the shader that comes with the editor.
// A gradient from the ground's colour over a bright horizon to the sky's, with the sun as a disk: no scattering.
Shader "Skybox/Procedural"
{
    Properties
    {
        [KeywordEnum(None, Simple, High Quality)] _SunDisk ("Sun", Int) = 2
        _SunSize ("Sun Size", Range(0, 1)) = 0.04
        _SunSizeConvergence ("Sun Size Convergence", Range(1, 10)) = 5
        _AtmosphereThickness ("Atmosphere Thickness", Range(0, 5)) = 1
        _SkyTint ("Sky Tint", Color) = (0.5, 0.5, 0.5, 1)
        _GroundColor ("Ground", Color) = (0.369, 0.349, 0.341, 1)
        _Exposure ("Exposure", Range(0, 8)) = 1.3
    }
    SubShader
    {
        Tags { "Queue" = "Background" "RenderType" = "Background" "PreviewType" = "Skybox" }
        Cull Off
        ZWrite Off
        Pass
        {
            CGPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            #include "UnityCG.cginc"
            #include "Lighting.cginc"
            half4 _SkyTint, _GroundColor;
            half _SunDisk, _SunSize, _AtmosphereThickness, _Exposure;

            struct v2f
            {
                float4 position : SV_POSITION;
                float3 direction : TEXCOORD0;
            };

            v2f vert(appdata_base v)
            {
                v2f o;
                o.position = UnityObjectToClipPos(v.vertex);
                o.direction = mul((float3x3)unity_ObjectToWorld, v.vertex.xyz);
                return o;
            }

            half4 frag(v2f i) : SV_Target
            {
                float3 d = normalize(i.direction);
                float3 zenith = float3(0.13, 0.24, 0.48) * _SkyTint.rgb / unity_ColorSpaceGrey.rgb * saturate(0.4 + 0.6 * _AtmosphereThickness);
                float3 horizon = float3(0.52, 0.60, 0.67);
                float3 sky = lerp(horizon, zenith, saturate(sqrt(max(d.y, 0))));
                float3 color = lerp(sky, _GroundColor.rgb, smoothstep(0, 0.02, -d.y));
                float sun = _SunDisk > 0.5 && d.y > 0 ? smoothstep(cos(_SunSize), 1, dot(d, normalize(_WorldSpaceLightPos0.xyz))) : 0;
                return half4(color * _Exposure / 1.3 + sun * _LightColor0.rgb, 1);
            }
            ENDCG
        }
    }
}
