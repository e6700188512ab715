// Headless host: a stand-in, by the same name and properties, for the shader that comes with the editor.
// Light that air scatters once: blue overhead, white towards the horizon, where the path through it is long, and red where the sun is
// low; a disk and a glow for the sun; the ground's color below.
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
                float3 d = normalize(i.direction), sun = normalize(_WorldSpaceLightPos0.xyz);
            #ifdef UNITY_COLORSPACE_GAMMA
                float3 tint = _SkyTint.rgb / 0.5, ground = GammaToLinearSpace(_GroundColor.rgb), light = GammaToLinearSpace(_LightColor0.rgb);
            #else
                float3 tint = _SkyTint.rgb / unity_ColorSpaceGrey.rgb, ground = _GroundColor.rgb, light = _LightColor0.rgb;
            #endif
                // By wavelength, over a vertical path; paths in vertical ones.
                float3 scattering = float3(0.058, 0.135, 0.331) * tint * _AtmosphereThickness;
                float path = 1 / (0.95 * max(d.y, 0) + 0.05), sunPath = 1 / (0.95 * max(sun.y, 0) + 0.05);
                float cosine = dot(d, sun);
                float3 sunlight = exp(-scattering * 0.35 * (sunPath - 1)) * smoothstep(-0.15, 0.1, sun.y);
                float glow = 0.012 / pow(1.64 - 1.6 * cosine, 1.5) * saturate(path * 0.15);
                float3 sky = (1 - exp(-scattering * path)) * sunlight * (0.8 + 0.15 * cosine * cosine) + glow * sunlight;
                float3 horizon = (1 - exp(-scattering * 20)) * sunlight * (0.8 + 0.15 * cosine * cosine);
                float3 color = d.y >= 0 ? sky : lerp(horizon, ground * max(sunlight, 0.1), smoothstep(0, 0.06, -d.y));

                float away = acos(min(cosine, 1)), radius = max(_SunSize * 0.5, 1e-3);
                float disk = _SunDisk > 0.5 && d.y > 0 ? 1 - smoothstep(radius * 0.85, radius, away) : 0;
                color = (color + disk * 20 * light * sunlight) * _Exposure / 1.3;
            #ifdef UNITY_COLORSPACE_GAMMA
                color = LinearToGammaSpace(color);
            #endif
                return half4(color, 1);
            }
            ENDCG
        }
    }
}
