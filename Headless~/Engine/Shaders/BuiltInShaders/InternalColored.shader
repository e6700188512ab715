// Of the headless host: a stand-in, by the same name and properties, for the shader that comes with the editor.
Shader "Hidden/Internal-Colored"
{
    Properties
    {
        _Color ("Color", Color) = (1, 1, 1, 1)
        _SrcBlend ("SrcBlend", Int) = 5
        _DstBlend ("DstBlend", Int) = 10
        _ZWrite ("ZWrite", Int) = 1
        _ZTest ("ZTest", Int) = 4
        _Cull ("Cull", Int) = 0
        _ZBias ("ZBias", Float) = 0
    }
    SubShader
    {
        Tags { "Queue" = "Transparent" "IgnoreProjector" = "True" "RenderType" = "Transparent" }
        Blend [_SrcBlend] [_DstBlend]
        ZWrite [_ZWrite]
        ZTest [_ZTest]
        Cull [_Cull]
        Offset [_ZBias], [_ZBias]
        Pass
        {
            CGPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            #pragma target 2.0
            #pragma multi_compile_instancing
            #include "UnityCG.cginc"
            fixed4 _Color;

            struct v2f
            {
                float4 vertex : SV_POSITION;
                float4 color : COLOR;
                float2 texcoord : TEXCOORD0;
            };

            v2f vert(appdata_full v)
            {
                v2f o;
                UNITY_SETUP_INSTANCE_ID(v);
                o.vertex = UnityObjectToClipPos(v.vertex);
                o.color = v.color * _Color;
                o.texcoord = 0;
                return o;
            }

            fixed4 frag(v2f i) : SV_Target
            {
                return i.color;
            }
            ENDCG
        }
    }
}
