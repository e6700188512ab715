// Headless host: one face and mip of a reflection, what a surface of one roughness sees of a sky in its mirror direction
// (the GGX lobe with normal and view along it).
Shader "Hidden/Headless/FilterReflection"
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

            TextureCube _Source;
            SamplerState host_linear_clamp_sampler;
            float _Face;
            float _Size;            // texels of a side
            float _Roughness;       // GGX's alpha
            float _Samples;

            float4 Vertex(uint vertex : SV_VertexID) : SV_Position
            {
                return float4(vertex == 1 ? 3.0 : -1.0, vertex == 2 ? 3.0 : -1.0, 0.5, 1.0);
            }

            // The order of CubemapFace; the first row of a face is its top.
            float3 Direction(float2 at)
            {
                float s = at.x / _Size * 2.0 - 1.0, t = at.y / _Size * 2.0 - 1.0;
                uint face = uint(_Face + 0.5);
                if (face == 0) return float3(1, -t, -s);
                if (face == 1) return float3(-1, -t, s);
                if (face == 2) return float3(s, 1, t);
                if (face == 3) return float3(s, -1, -t);
                if (face == 4) return float3(s, -t, 1);
                return float3(-s, -t, -1);
            }

            float4 Fragment(float4 at : SV_Position) : SV_Target
            {
                float3 mirror = normalize(Direction(at.xy));
                uint count = uint(_Samples + 0.5);
                if (count <= 1)
                    return float4(_Source.SampleLevel(host_linear_clamp_sampler, mirror, 0).rgb, 1);

                float3 side = normalize(cross(abs(mirror.y) < 0.9 ? float3(0, 1, 0) : float3(1, 0, 0), mirror)), up = cross(mirror, side);
                float3 sum = 0;
                float weights = 0;
                for (uint i = 0; i < count; i++)
                {
                    float u = (i + 0.5) / count, v = reversebits(i) * 2.3283064e-10;
                    float cosine = sqrt((1 - u) / (1 + (_Roughness * _Roughness - 1) * u)), sine = sqrt(saturate(1 - cosine * cosine));
                    float3 between = side * (sine * cos(6.2831853 * v)) + up * (sine * sin(6.2831853 * v)) + mirror * cosine;
                    float3 towards = 2 * dot(mirror, between) * between - mirror;
                    float weight = saturate(dot(mirror, towards));
                    sum += _Source.SampleLevel(host_linear_clamp_sampler, towards, 0).rgb * weight;
                    weights += weight;
                }
                return float4(sum / max(weights, 1e-6), 1);
            }
            ENDHLSL
        }
    }
}
