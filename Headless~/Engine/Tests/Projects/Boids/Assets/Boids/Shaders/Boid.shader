Shader "Flocking/Boid"
{
    Properties
    {
        _Color ("Color", Color) = (1,1,1,1)
        _Size ("Size", Range(0.01, 2)) = 0.3
    }
    SubShader
    {
        Tags { "RenderType"="Opaque" }
        LOD 100

        Pass
        {
            CGPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            #pragma target 4.5

            #include "UnityCG.cginc"

            struct Boid
            {
                float3 position;
                float3 velocity;
                float noise;
            };

            StructuredBuffer<Boid> boidBuffer;

            struct v2f
            {
                float4 vertex : SV_POSITION;
                float3 normal : TEXCOORD0;
                float shade : TEXCOORD1;
            };

            fixed4 _Color;
            float _Size;

            float3x3 lookRotation(float3 forward)
            {
                float3 f = normalize(forward);
                float3 r = normalize(cross(float3(0, 1, 0), f));
                float3 u = cross(f, r);
                return transpose(float3x3(r, u, f));
            }

            v2f vert (appdata_base v, uint instanceID : SV_InstanceID)
            {
                Boid boid = boidBuffer[instanceID];
                float3x3 rotation = lookRotation(boid.velocity);
                float3 world = boid.position + mul(rotation, v.vertex.xyz * float3(0.5, 0.5, 1.5) * _Size);

                v2f o;
                o.vertex = mul(UNITY_MATRIX_VP, float4(world, 1.0));
                o.normal = mul(rotation, v.normal);
                o.shade = boid.noise;
                return o;
            }

            fixed4 frag (v2f i) : SV_Target
            {
                float light = saturate(dot(normalize(i.normal), normalize(float3(0.3, 1, -0.5)))) * 0.6 + 0.4;
                return fixed4(_Color.rgb * light * i.shade, 1);
            }
            ENDCG
        }
    }
    FallBack "Diffuse"
}
