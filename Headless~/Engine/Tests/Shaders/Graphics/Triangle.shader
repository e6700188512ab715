// Procedural triangles: positions from SV_VertexID, colors from properties, a buffer of offsets for instances.
Shader "Tests/Triangle"
{
    Properties
    {
        _Color ("Color", Color) = (1, 1, 1, 1)
        _Tint ("Tint", Vector) = (1, 1, 1, 1)
        _Depth ("Depth", Float) = 5
        [Enum(Off, 0, Front, 1, Back, 2)] _Cull ("Cull", Float) = 2
        _MainTex ("Texture", 2D) = "white" {}
    }
    SubShader
    {
        Tags { "RenderType" = "Opaque" "Queue" = "Geometry" }
        Pass
        {
            Name "World"
            Cull [_Cull]
            HLSLPROGRAM
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma multi_compile_local _ HALF_RED
            float4x4 unity_MatrixVP;
            float4x4 unity_ObjectToWorld;
            float4 _Color, _Tint;
            float _Depth;
            float4 _GlobalTint;
            Texture2D _MainTex;
            SamplerState sampler_MainTex;

            struct Varyings { float4 position : SV_POSITION; float2 uv : TEXCOORD0; };

            // Clockwise as seen from the camera at the origin looking along +z: left bottom, left top, right bottom.
            Varyings Vertex(uint id : SV_VertexID, uint instance : SV_InstanceID)
            {
                float2 corner = float2(id == 2 ? 1 : -1, id == 1 ? 1 : -1);
                Varyings o;
                o.uv = corner * 0.5 + 0.5;
                o.position = mul(unity_MatrixVP, mul(unity_ObjectToWorld, float4(corner + float2(instance * 2.0, 0), _Depth, 1)));
                return o;
            }

            // Back faces show in blue.
            float4 Fragment(Varyings i, bool isFront : SV_IsFrontFace) : SV_Target
            {
                if (!isFront)
                    return float4(0, 0, 1, 1);
                float4 c = _Color * _Tint * _MainTex.Sample(sampler_MainTex, i.uv) + _GlobalTint;
            #ifdef HALF_RED
                c.r *= 0.5;
            #endif
                return c;
            }
            ENDHLSL
        }
    }
}
