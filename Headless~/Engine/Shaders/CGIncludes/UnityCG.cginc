// Helper functions and structures (manual, "Built-in shader helper functions", "Provide vertex data to vertex programs").
// Written again for the headless host.
#ifndef UNITY_CG_INCLUDED
#define UNITY_CG_INCLUDED

#define UNITY_PI 3.14159265359f
#define UNITY_TWO_PI 6.28318530718f
#define UNITY_FOUR_PI 12.56637061436f
#define UNITY_INV_PI 0.31830988618f
#define UNITY_INV_TWO_PI 0.15915494309f
#define UNITY_INV_FOUR_PI 0.07957747155f
#define UNITY_HALF_PI 1.57079632679f
#define UNITY_INV_HALF_PI 0.636619772367f
#define UNITY_HALF_MIN 6.103515625e-5

#include "UnityShaderVariables.cginc"
#include "UnityInstancing.cginc"

#ifdef UNITY_COLORSPACE_GAMMA
#define unity_ColorSpaceGrey float4(0.5, 0.5, 0.5, 0.5)
#define unity_ColorSpaceDouble float4(2.0, 2.0, 2.0, 2.0)
#define unity_ColorSpaceDielectricSpec float4(0.22, 0.22, 0.22, 1.0 - 0.22)
#define unity_ColorSpaceLuminance float4(0.22, 0.707, 0.071, 0.0)
#else
#define unity_ColorSpaceGrey float4(0.21404114, 0.21404114, 0.21404114, 0.5)
#define unity_ColorSpaceDouble float4(4.59479380, 4.59479380, 4.59479380, 2.0)
#define unity_ColorSpaceDielectricSpec float4(0.04, 0.04, 0.04, 1.0 - 0.04)
#define unity_ColorSpaceLuminance float4(0.0396819152, 0.458021790, 0.00609653955, 1.0)
#endif

// ---- vertex data

struct appdata_base
{
    float4 vertex : POSITION;
    float3 normal : NORMAL;
    float4 texcoord : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct appdata_tan
{
    float4 vertex : POSITION;
    float4 tangent : TANGENT;
    float3 normal : NORMAL;
    float4 texcoord : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct appdata_full
{
    float4 vertex : POSITION;
    float4 tangent : TANGENT;
    float3 normal : NORMAL;
    float4 texcoord : TEXCOORD0;
    float4 texcoord1 : TEXCOORD1;
    float4 texcoord2 : TEXCOORD2;
    float4 texcoord3 : TEXCOORD3;
    float4 color : COLOR;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct appdata_img
{
    float4 vertex : POSITION;
    float2 texcoord : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

#define TRANSFORM_TEX(tex, name) (tex.xy * name##_ST.xy + name##_ST.zw)
#define TRANSFORM_UV(idx) v.texcoord.xy

// ---- spaces

inline float4 UnityWorldToClipPos(float3 position) { return mul(UNITY_MATRIX_VP, float4(position, 1.0)); }
inline float4 UnityViewToClipPos(float3 position) { return mul(UNITY_MATRIX_P, float4(position, 1.0)); }
inline float3 UnityObjectToViewPos(float3 position) { return mul(UNITY_MATRIX_V, mul(unity_ObjectToWorld, float4(position, 1.0))).xyz; }
inline float3 UnityObjectToViewPos(float4 position) { return UnityObjectToViewPos(position.xyz); }
inline float3 UnityWorldToViewPos(float3 position) { return mul(UNITY_MATRIX_V, float4(position, 1.0)).xyz; }
inline float4 UnityObjectToClipPos(float3 position) { return mul(UNITY_MATRIX_VP, mul(unity_ObjectToWorld, float4(position, 1.0))); }
inline float4 UnityObjectToClipPos(float4 position) { return UnityObjectToClipPos(position.xyz); }

inline float3 UnityObjectToWorldDir(float3 direction) { return normalize(mul((float3x3)unity_ObjectToWorld, direction)); }
inline float3 UnityWorldToObjectDir(float3 direction) { return normalize(mul((float3x3)unity_WorldToObject, direction)); }
// A normal goes by the inverse's transpose, so that an unequal scale leaves it perpendicular.
inline float3 UnityObjectToWorldNormal(float3 normal) { return normalize(mul(normal, (float3x3)unity_WorldToObject)); }

inline float3 UnityWorldSpaceLightDir(float3 worldPosition) { return _WorldSpaceLightPos0.xyz - worldPosition * _WorldSpaceLightPos0.w; }
inline float3 WorldSpaceLightDir(float4 localPosition) { return UnityWorldSpaceLightDir(mul(unity_ObjectToWorld, localPosition).xyz); }
inline float3 ObjSpaceLightDir(float4 localPosition)
{
    float3 light = mul(unity_WorldToObject, _WorldSpaceLightPos0).xyz;
    return light - localPosition.xyz * _WorldSpaceLightPos0.w;
}
inline float3 UnityWorldSpaceViewDir(float3 worldPosition) { return _WorldSpaceCameraPos.xyz - worldPosition; }
inline float3 WorldSpaceViewDir(float4 localPosition) { return UnityWorldSpaceViewDir(mul(unity_ObjectToWorld, localPosition).xyz); }
inline float3 ObjSpaceViewDir(float4 localPosition) { return mul(unity_WorldToObject, float4(_WorldSpaceCameraPos.xyz, 1)).xyz - localPosition.xyz; }

#define TANGENT_SPACE_ROTATION \
    float3 binormal = cross(normalize(v.normal), normalize(v.tangent.xyz)) * v.tangent.w; \
    float3x3 rotation = float3x3(v.tangent.xyz, binormal, v.normal)

// ---- the screen

inline float4 ComputeNonStereoScreenPos(float4 clip)
{
    float4 o = clip * 0.5f;
    o.xy = float2(o.x, o.y * _ProjectionParams.x) + o.w;
    o.zw = clip.zw;
    return o;
}
inline float4 ComputeScreenPos(float4 clip) { return ComputeNonStereoScreenPos(clip); }
inline float4 ComputeGrabScreenPos(float4 clip)
{
    float4 o = clip * 0.5f;
    o.xy = float2(o.x, -o.y) + o.w;     // a texture's rows begin at the top
    o.zw = clip.zw;
    return o;
}
inline float2 UnityStereoTransformScreenSpaceTex(float2 uv) { return uv; }
#define UnityStereoScreenSpaceUVAdjust(x, y) ((x).xy * (y).xy + (y).zw)
inline float4 UnityPixelSnap(float4 position)
{
    float2 half_size = _ScreenParams.xy * 0.5f;
    float2 snapped = round(position.xy / position.w * half_size);
    position.xy = snapped / half_size * position.w;
    return position;
}

// ---- depth; the buffer is reversed: 1 at the near plane

inline float Linear01Depth(float z) { return 1.0 / (_ZBufferParams.x * z + _ZBufferParams.y); }
inline float LinearEyeDepth(float z) { return 1.0 / (_ZBufferParams.z * z + _ZBufferParams.w); }
#define COMPUTE_EYEDEPTH(o) o = -UnityObjectToViewPos(v.vertex).z
#define COMPUTE_DEPTH_01 -(UnityObjectToViewPos(v.vertex).z * _ProjectionParams.w)
#define COMPUTE_VIEW_NORMAL normalize(mul((float3x3)UNITY_MATRIX_IT_MV, v.normal))
#define UNITY_TRANSFER_DEPTH(oo)
#define UNITY_OUTPUT_DEPTH(i) return 0

// ---- colors

inline float Luminance(float3 rgb) { return dot(rgb, unity_ColorSpaceLuminance.rgb); }
inline float LinearRgbToLuminance(float3 rgb) { return dot(rgb, float3(0.2126729f, 0.7151522f, 0.0721750f)); }

// The sRGB curve, exactly for one channel, and as the usual polynomial and power for three.
inline float GammaToLinearSpaceExact(float value)
{
    if (value <= 0.04045F)
        return value / 12.92F;
    return value < 1.0F ? pow((value + 0.055F) / 1.055F, 2.4F) : pow(value, 2.2F);
}
inline float LinearToGammaSpaceExact(float value)
{
    if (value <= 0.0F)
        return 0.0F;
    if (value <= 0.0031308F)
        return 12.92F * value;
    return value < 1.0F ? 1.055F * pow(value, 0.4166667F) - 0.055F : pow(value, 0.45454545F);
}
inline float3 GammaToLinearSpace(float3 c) { return c * (c * (c * 0.305306011f + 0.682171111f) + 0.012522878f); }
inline float3 LinearToGammaSpace(float3 c) { return max(1.055f * pow(max(c, 0.0f), 0.416666667f) - 0.055f, 0.0f); }
inline bool IsGammaSpace()
{
#ifdef UNITY_COLORSPACE_GAMMA
    return true;
#else
    return false;
#endif
}

// A texture's color with its alpha as exponent or factor.
inline float3 DecodeHDR(float4 data, float4 instructions)
{
    float alpha = instructions.w * (data.a - 1.0) + 1.0;
#ifdef UNITY_COLORSPACE_GAMMA
    return instructions.x * alpha * data.rgb;
#else
    return instructions.x * pow(abs(alpha), instructions.y) * data.rgb;
#endif
}

// ---- numbers in colors

inline float4 EncodeFloatRGBA(float v)
{
    float4 digits = frac(float4(1.0, 255.0, 65025.0, 16581375.0) * v);
    return digits - digits.yzww / 255.0;
}
inline float DecodeFloatRGBA(float4 rgba) { return dot(rgba, float4(1.0, 1 / 255.0, 1 / 65025.0, 1 / 16581375.0)); }
inline float2 EncodeFloatRG(float v)
{
    float2 digits = frac(float2(1.0, 255.0) * v);
    digits.x -= digits.y / 255.0;
    return digits;
}
inline float DecodeFloatRG(float2 rg) { return dot(rg, float2(1.0, 1 / 255.0)); }

// A view-space normal by stereographic projection.
inline float2 EncodeViewNormalStereo(float3 n)
{
    const float scale = 1.7777;
    return n.xy / (n.z + 1) / scale * 0.5 + 0.5;
}
inline float3 DecodeViewNormalStereo(float4 encoded)
{
    const float scale = 1.7777;
    float3 nn = encoded.xyz * float3(2 * scale, 2 * scale, 0) + float3(-scale, -scale, 1);
    float g = 2.0 / dot(nn, nn);
    return float3(g * nn.xy, g - 1);
}
inline float4 EncodeDepthNormal(float depth, float3 normal) { return float4(EncodeViewNormalStereo(normal), EncodeFloatRG(depth)); }
inline void DecodeDepthNormal(float4 encoded, out float depth, out float3 normal)
{
    depth = DecodeFloatRG(encoded.zw);
    normal = DecodeViewNormalStereo(encoded);
}

// ---- normal maps: x in red or, where only two channels are kept, in alpha

inline float3 UnpackNormalDXT5nm(float4 packed)
{
    float3 normal;
    normal.xy = packed.wy * 2 - 1;
    normal.z = sqrt(1 - saturate(dot(normal.xy, normal.xy)));
    return normal;
}
inline float3 UnpackNormalmapRGorAG(float4 packed)
{
    packed.x *= packed.w;
    float3 normal;
    normal.xy = packed.xy * 2 - 1;
    normal.z = sqrt(1 - saturate(dot(normal.xy, normal.xy)));
    return normal;
}
inline float3 UnpackNormal(float4 packed) { return UnpackNormalmapRGorAG(packed); }
inline float3 UnpackNormalWithScale(float4 packed, float scale)
{
    float3 normal = UnpackNormalmapRGorAG(packed);
    normal.xy *= scale;
    return normal;
}

inline float2 ParallaxOffset(float h, float height, float3 viewDir)
{
    h = h * height - height / 2.0;
    float3 v = normalize(viewDir);
    v.z += 0.42;
    return h * (v.xy / v.z);
}

// ---- ambient light: spherical harmonics of the second order

inline float3 SHEvalLinearL0L1(float4 normal) { return float3(dot(unity_SHAr, normal), dot(unity_SHAg, normal), dot(unity_SHAb, normal)); }
inline float3 SHEvalLinearL2(float4 normal)
{
    float4 products = normal.xyzz * normal.yzzx;
    float3 first = float3(dot(unity_SHBr, products), dot(unity_SHBg, products), dot(unity_SHBb, products));
    return first + unity_SHC.rgb * (normal.x * normal.x - normal.y * normal.y);
}
inline float3 ShadeSH9(float4 normal)
{
    float3 light = SHEvalLinearL0L1(normal) + SHEvalLinearL2(normal);
#ifdef UNITY_COLORSPACE_GAMMA
    light = LinearToGammaSpace(light);
#endif
    return light;
}
inline float3 ShadeSH3Order(float4 normal) { return SHEvalLinearL2(normal); }
inline float3 ShadeSH12Order(float4 normal) { return SHEvalLinearL0L1(normal); }

// ---- image effects

struct v2f_img
{
    float4 pos : SV_POSITION;
    float2 uv : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
    UNITY_VERTEX_OUTPUT_STEREO
};

v2f_img vert_img(appdata_img v)
{
    v2f_img o;
    UNITY_INITIALIZE_OUTPUT(v2f_img, o);
    UNITY_SETUP_INSTANCE_ID(v);
    o.pos = UnityObjectToClipPos(v.vertex);
    o.uv = v.texcoord;
    return o;
}

float2 MultiplyUV(float4x4 m, float2 uv) { return mul(m, float4(uv, 0, 0)).xy; }

// ---- fog, which this host leaves off, and lightmaps and probes, which it does not have

#define UNITY_FOG_COORDS_PACKED(idx, vectype)
#define UNITY_FOG_COORDS(idx)
#define UNITY_CALC_FOG_FACTOR(coord)
#define UNITY_TRANSFER_FOG(o, outpos)
#define UNITY_TRANSFER_FOG_COMBINED_WITH_TSPACE(o, outpos)
#define UNITY_FOG_LERP_COLOR(col, fogCol, fogFac) col.rgb = lerp((fogCol).rgb, (col).rgb, saturate(fogFac))
#define UNITY_APPLY_FOG_COLOR(coord, col, fogCol)
#define UNITY_APPLY_FOG(coord, col)
#define UNITY_OPAQUE_ALPHA(outputAlpha) outputAlpha = 1.0
#define UNITY_APPLY_DITHER_CROSSFADE(vpos)

// ---- passes that draw a shadow map and the camera's depth, where both biases are 0

// A point moved inwards along its normal, the more the light grazes it.
float4 UnityClipSpaceShadowCasterPos(float4 vertex, float3 normal)
{
    float4 world = mul(unity_ObjectToWorld, vertex);
    if (unity_LightShadowBias.z != 0.0)
    {
        float3 outwards = UnityObjectToWorldNormal(normal);
        float cosine = dot(outwards, normalize(UnityWorldSpaceLightDir(world.xyz)));
        world.xyz -= outwards * (unity_LightShadowBias.z * sqrt(saturate(1 - cosine * cosine)));
    }
    return mul(UNITY_MATRIX_VP, world);
}
float4 UnityClipSpaceShadowCasterPos(float3 vertex, float3 normal) { return UnityClipSpaceShadowCasterPos(float4(vertex, 1), normal); }

// Away from the light (depth is reversed), but what is before the near plane of a directional light stays on it.
float4 UnityApplyLinearShadowBias(float4 clip)
{
    clip.z += max(-1, min(unity_LightShadowBias.x / clip.w, 0));
    clip.z = lerp(clip.z, min(clip.z, clip.w * UNITY_NEAR_CLIP_VALUE), unity_LightShadowBias.y);
    return clip;
}

#define V2F_SHADOW_CASTER_NOPOS
#define V2F_SHADOW_CASTER V2F_SHADOW_CASTER_NOPOS UNITY_POSITION(pos)
#define TRANSFER_SHADOW_CASTER_NOPOS_LEGACY(o, opos) opos = UnityApplyLinearShadowBias(UnityObjectToClipPos(v.vertex.xyz));
#define TRANSFER_SHADOW_CASTER_NOPOS(o, opos) opos = UnityApplyLinearShadowBias(UnityClipSpaceShadowCasterPos(v.vertex, v.normal));
#define TRANSFER_SHADOW_CASTER_NORMALOFFSET(o) TRANSFER_SHADOW_CASTER_NOPOS(o, o.pos)
#define TRANSFER_SHADOW_CASTER(o) TRANSFER_SHADOW_CASTER_NOPOS_LEGACY(o, o.pos)
#define SHADOW_CASTER_FRAGMENT(i) return 0;

#endif
