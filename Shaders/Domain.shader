// The fluid's box: a chequered floor and twelve edges, from SV_VertexID alone.
Shader "Rill/Domain"
{
    SubShader
    {
        Tags { "RenderType" = "Opaque" "Queue" = "Geometry" }
        Pass
        {
            Name "Domain"
            Cull Off
            ZWrite On
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 5.0
            #pragma vertex DomainVertex
            #pragma fragment DomainColor

            float4x4 unity_MatrixVP;
            float4x4 _BoxToWorld;       // unit cube, corner at 0, to world
            float4 _BoxSize;            // m
            float4 _LineColor;          // linear
            float4 _FloorColor;         // linear
            float _FloorTile;           // m
            float _DrawFloor;           // 1 floor, 0 edges

            struct Fragment
            {
                float4 clip : SV_Position;
                float3 box : TEXCOORD0;     // unit cube
            };

            // Ends of the edges as corner numbers, bit 0 x, bit 1 y, bit 2 z.
            static const uint kEdges[24] = { 0,1, 2,3, 4,5, 6,7, 0,2, 1,3, 4,6, 5,7, 0,4, 1,5, 2,6, 3,7 };
            static const uint kFloor[6] = { 0,4,5, 0,5,1 };

            Fragment DomainVertex(uint vertex : SV_VertexID)
            {
                uint corner = _DrawFloor > 0.5 ? kFloor[vertex % 6] : kEdges[vertex % 24];
                Fragment result;
                result.box = float3(corner & 1, (corner >> 1) & 1, corner >> 2);
                result.clip = mul(unity_MatrixVP, mul(_BoxToWorld, float4(result.box, 1.0)));
                return result;
            }

            float4 DomainColor(Fragment fragment) : SV_Target
            {
                if (_DrawFloor < 0.5)
                    return float4(_LineColor.rgb, 1.0);
                float2 tile = floor(fragment.box.xz * _BoxSize.xz / max(_FloorTile, 1e-6));
                float odd = frac((tile.x + tile.y) * 0.5) * 2.0;
                return float4(_FloorColor.rgb * (1.0 - 0.18 * odd), 1.0);
            }
            ENDHLSL
        }
    }
}
