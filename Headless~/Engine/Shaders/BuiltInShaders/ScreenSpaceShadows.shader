// Headless host: by the name of the shader that comes with the editor: the main light's shadow at each pixel, out of
// the camera's depth and one shadow map.
Shader "Hidden/Internal-ScreenSpaceShadows"
{
    SubShader
    {
        Pass
        {
            ZTest Always
            ZWrite Off
            Cull Off

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex Vertex
            #pragma fragment Fragment

            #pragma multi_compile_local_fragment _ EYES

        #ifdef EYES
            Texture2DArray _CameraDepthTexture;
        #else
            Texture2D _CameraDepthTexture;
        #endif
            float _Eye;
            Texture2D _ShadowMap;
            SamplerComparisonState host_linear_clamp_compare_sampler;
            float4x4 unity_MatrixInvVP;
            float4x4 unity_WorldToShadow[4];
            float3 _WorldSpaceCameraPos;
            float4 _LightShadowData;        // x 1 - strength
            float4 _ShadowMapSize;          // x texels, y 0 hard and 1 soft, z distance at which it ends, m

            float4 Vertex(uint vertex : SV_VertexID) : SV_Position
            {
                return float4(vertex == 1 ? 3.0 : -1.0, vertex == 2 ? 3.0 : -1.0, 0.5, 1.0);
            }

            float4 Fragment(float4 at : SV_Position) : SV_Target
            {
                uint width, height;
            #ifdef EYES
                uint slices;
                _CameraDepthTexture.GetDimensions(width, height, slices);
                float depth = _CameraDepthTexture.Load(int4(at.xy, _Eye, 0)).r;
            #else
                _CameraDepthTexture.GetDimensions(width, height);
                float depth = _CameraDepthTexture.Load(int3(at.xy, 0)).r;
            #endif
                float4 world = mul(unity_MatrixInvVP, float4(at.x / width * 2.0 - 1.0, 1.0 - at.y / height * 2.0, depth, 1.0));
                world /= world.w;
                float3 shadowed = mul(unity_WorldToShadow[0], world).xyz;
                float away = distance(world.xyz, _WorldSpaceCameraPos);
                if (depth <= 0.0 || away >= _ShadowMapSize.z || any(shadowed.xy <= 0.0) || any(shadowed.xy >= 1.0))
                    return 1.0;

                float lit = 0.0;
                int reach = _ShadowMapSize.y > 0.5 ? 1 : 0;
                for (int y = -reach; y <= reach; y++)
                    for (int x = -reach; x <= reach; x++)
                        lit += _ShadowMap.SampleCmpLevelZero(host_linear_clamp_compare_sampler, shadowed.xy + float2(x, y) / _ShadowMapSize.x, shadowed.z);
                lit /= (2 * reach + 1) * (2 * reach + 1);
                float fade = saturate((away / _ShadowMapSize.z - 0.9) * 10.0);
                return lerp(lerp(_LightShadowData.x, 1.0, lit), 1.0, fade);
            }
            ENDHLSL
        }
    }
}
