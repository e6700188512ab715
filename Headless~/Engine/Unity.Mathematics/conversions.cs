using System.Runtime.CompilerServices;
using UnityEngine;

namespace Unity.Mathematics
{
    public partial struct float2
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator Vector2(float2 v) => new Vector2(v.x, v.y);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator float2(Vector2 v) => new float2(v.x, v.y);
    }

    public partial struct float3
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator Vector3(float3 v) => new Vector3(v.x, v.y, v.z);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator float3(Vector3 v) => new float3(v.x, v.y, v.z);
    }

    public partial struct float4
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator Vector4(float4 v) => new Vector4(v.x, v.y, v.z, v.w);
        [MethodImpl(MethodImplOptions.AggressiveInlining)] public static implicit operator float4(Vector4 v) => new float4(v.x, v.y, v.z, v.w);
    }

    public partial struct float4x4
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static implicit operator Matrix4x4(float4x4 m) => new Matrix4x4(m.c0, m.c1, m.c2, m.c3);
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static implicit operator float4x4(Matrix4x4 m) => new float4x4(m.GetColumn(0), m.GetColumn(1), m.GetColumn(2), m.GetColumn(3));
    }
}
