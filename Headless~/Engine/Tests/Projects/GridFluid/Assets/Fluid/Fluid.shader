Shader "Hidden/Fluid"
{
    Properties
    {
        _MainTex ("Texture", 2D) = "white" {}
        _Velocity ("Velocity", 2D) = "black" {}
        _Divergence ("Divergence", 2D) = "black" {}
        _Pressure ("Pressure", 2D) = "black" {}
        _Dye ("Dye", 2D) = "black" {}
    }

    CGINCLUDE
    #include "UnityCG.cginc"

    sampler2D _MainTex;
    float4 _MainTex_TexelSize;
    sampler2D _Velocity, _Divergence, _Pressure, _Dye;
    float _DeltaTime, _Dissipation, _Radius;
    float2 _Point;
    float4 _Splat;

    struct appdata
    {
        float4 vertex : POSITION;
        float2 uv : TEXCOORD0;
    };

    struct v2f
    {
        float2 uv : TEXCOORD0;
        float4 vertex : SV_POSITION;
    };

    v2f vert (appdata v)
    {
        v2f o;
        o.vertex = UnityObjectToClipPos(v.vertex);
        o.uv = v.uv;
        return o;
    }

    float Left(sampler2D tex, float2 uv)   { return tex2D(tex, uv - float2(_MainTex_TexelSize.x, 0)).x; }
    float Right(sampler2D tex, float2 uv)  { return tex2D(tex, uv + float2(_MainTex_TexelSize.x, 0)).x; }
    float Bottom(sampler2D tex, float2 uv) { return tex2D(tex, uv - float2(0, _MainTex_TexelSize.y)).x; }
    float Top(sampler2D tex, float2 uv)    { return tex2D(tex, uv + float2(0, _MainTex_TexelSize.y)).x; }

    // velocities are in screens per second
    float4 fragAdvect (v2f i) : SV_Target
    {
        float2 from = i.uv - _DeltaTime * tex2D(_Velocity, i.uv).xy;
        return tex2D(_MainTex, from) / (1.0 + _Dissipation * _DeltaTime);
    }

    float4 fragSplat (v2f i) : SV_Target
    {
        float2 d = i.uv - _Point;
        float w = exp(-dot(d, d) / (_Radius * _Radius));
        return tex2D(_MainTex, i.uv) + _Splat * w;
    }

    float4 fragDivergence (v2f i) : SV_Target
    {
        float2 t = _MainTex_TexelSize.xy;
        float l = tex2D(_MainTex, i.uv - float2(t.x, 0)).x;
        float r = tex2D(_MainTex, i.uv + float2(t.x, 0)).x;
        float b = tex2D(_MainTex, i.uv - float2(0, t.y)).y;
        float u = tex2D(_MainTex, i.uv + float2(0, t.y)).y;
        return 0.5 * (r - l + u - b);
    }

    float4 fragJacobi (v2f i) : SV_Target
    {
        float sum = Left(_MainTex, i.uv) + Right(_MainTex, i.uv) + Bottom(_MainTex, i.uv) + Top(_MainTex, i.uv);
        return (sum - tex2D(_Divergence, i.uv).x) * 0.25;
    }

    float4 fragGradient (v2f i) : SV_Target
    {
        float2 gradient = 0.5 * float2(Right(_Pressure, i.uv) - Left(_Pressure, i.uv), Top(_Pressure, i.uv) - Bottom(_Pressure, i.uv));
        float2 velocity = tex2D(_MainTex, i.uv).xy - gradient;
        // no flow through the walls
        float2 edge = step(_MainTex_TexelSize.xy, i.uv) * step(i.uv, 1.0 - _MainTex_TexelSize.xy);
        return float4(velocity * edge, 0, 1);
    }

    float4 fragClear (v2f i) : SV_Target
    {
        return 0;
    }

    fixed4 fragShow (v2f i) : SV_Target
    {
        fixed4 scene = tex2D(_MainTex, i.uv);
        float3 dye = tex2D(_Dye, i.uv).rgb;
        return fixed4(scene.rgb + 1.0 - exp(-dye), 1);
    }
    ENDCG

    SubShader
    {
        Cull Off ZWrite Off ZTest Always

        Pass
        {
            Name "Advect"
            CGPROGRAM
            #pragma vertex vert
            #pragma fragment fragAdvect
            ENDCG
        }
        Pass
        {
            Name "Splat"
            CGPROGRAM
            #pragma vertex vert
            #pragma fragment fragSplat
            ENDCG
        }
        Pass
        {
            Name "Divergence"
            CGPROGRAM
            #pragma vertex vert
            #pragma fragment fragDivergence
            ENDCG
        }
        Pass
        {
            Name "Jacobi"
            CGPROGRAM
            #pragma vertex vert
            #pragma fragment fragJacobi
            ENDCG
        }
        Pass
        {
            Name "Gradient"
            CGPROGRAM
            #pragma vertex vert
            #pragma fragment fragGradient
            ENDCG
        }
        Pass
        {
            Name "Clear"
            CGPROGRAM
            #pragma vertex vert
            #pragma fragment fragClear
            ENDCG
        }
        Pass
        {
            Name "Show"
            CGPROGRAM
            #pragma vertex vert_img
            #pragma fragment fragShowImg
            fixed4 fragShowImg (v2f_img i) : SV_Target
            {
                v2f o;
                o.uv = i.uv;
                o.vertex = i.pos;
                return fragShow(o);
            }
            ENDCG
        }
    }
    Fallback Off
}
