using System;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using static Unity.Mathematics.math;
using Random = Unity.Mathematics.Random;

namespace Host.Tests
{
    public class EngineMathematicsTests
    {
        static void Near(float3 actual, float3 expected, float within = 1e-5f)
            => Assert.That(distance(actual, expected), Is.LessThan(within), $"{actual} instead of {expected}");

        static void Near(float4x4 actual, Matrix4x4 expected, float within = 1e-4f)
        {
            for (int i = 0; i < 16; i++)
                Assert.That(actual[i / 4][i % 4], Is.EqualTo(expected[i]).Within(within), $"element {i}");
        }

        [Test]
        public void Swizzles_read_and_write_their_components()
        {
            float4 v = float4(1, 2, 3, 4);
            Assert.That(v.wzyx.Equals(float4(4, 3, 2, 1)));
            Assert.That(v.xxy.Equals(float3(1, 1, 2)));
            v.zx = float2(7, 8);
            Assert.That(v.Equals(float4(8, 2, 7, 4)));
            Assert.That(float4(v.xy, 5, 6).Equals(float4(8, 2, 5, 6)));
            Assert.That(v.ToString(), Is.EqualTo("float4(8f, 2f, 7f, 4f)"));
        }

        [Test]
        public void Operators_work_component_by_component()
        {
            int3 a = int3(7, -8, 9);
            Assert.That((a * 2 - int3(1, 1, 1)).Equals(int3(13, -17, 17)));
            Assert.That((a / 2).Equals(int3(3, -4, 4)));
            Assert.That((a >> 1).Equals(int3(3, -4, 4)));
            Assert.That((a & 1).Equals(int3(1, 0, 1)));
            Assert.That((a > 0).Equals(bool3(true, false, true)));
            Assert.That(any(a < 0) && !all(a < 0));
            Assert.That(select(a, 0, a < 0).Equals(int3(7, 0, 9)));
            Assert.That(((uint3)a).Equals(uint3(7, 4294967288, 9)));
            Assert.That(((int3)float3(1.9f, -1.9f, 0.5f)).Equals(int3(1, -1, 0)));
        }

        [Test]
        public void Integer_functions_agree_with_the_framework()
        {
            var random = new Random(1);
            for (int i = 0; i < 1000; i++)
            {
                uint x = random.NextUInt() >> random.NextInt(0, 32);
                Assert.That(countbits(x), Is.EqualTo(System.Numerics.BitOperations.PopCount(x)));
                Assert.That(lzcnt(x), Is.EqualTo(System.Numerics.BitOperations.LeadingZeroCount(x)));
                Assert.That(tzcnt(x), Is.EqualTo(System.Numerics.BitOperations.TrailingZeroCount(x)));
                Assert.That(rol(x, 7), Is.EqualTo(System.Numerics.BitOperations.RotateLeft(x, 7)));
                Assert.That(ror(x, 7), Is.EqualTo(System.Numerics.BitOperations.RotateRight(x, 7)));
                Assert.That(reversebits(reversebits(x)), Is.EqualTo(x));
                Assert.That(asuint(asfloat(x & 0x7F7FFFFF)), Is.EqualTo(x & 0x7F7FFFFF));
            }
            Assert.That(ceilpow2(100003), Is.EqualTo(131072));
            Assert.That(ceilpow2(64u), Is.EqualTo(64));
            Assert.That(ceillog2(65), Is.EqualTo(7));
            Assert.That(floorlog2(65), Is.EqualTo(6));
            Assert.That(reversebits(1u), Is.EqualTo(0x80000000));
        }

        [Test]
        public void Min_and_max_prefer_the_number_over_NaN()
        {
            Assert.That(min(float.NaN, 1f), Is.EqualTo(1));
            Assert.That(min(1f, float.NaN), Is.EqualTo(1));
            Assert.That(max(float.NaN, 1f), Is.EqualTo(1));
            Assert.That(clamp(float3(-1, 0.5f, 3), 0, 1).Equals(float3(0, 0.5f, 1)));
            Assert.That(cmax(int4(3, 9, -1, 2)), Is.EqualTo(9));
        }

        [Test]
        public void Matrices_agree_with_Unitys()
        {
            var random = new Random(2);
            for (int i = 0; i < 50; i++)
            {
                float3 t = random.NextFloat3(-5, 5), s = random.NextFloat3(0.5f, 2), p = random.NextFloat3(-1, 1);
                quaternion q = random.NextQuaternionRotation();
                float4x4 m = Unity.Mathematics.float4x4.TRS(t, q, s);
                Matrix4x4 oracle = Matrix4x4.TRS(t, q, s);
                Near(m, oracle);
                Near(mul(m, m), oracle * oracle, 1e-3f);
                Near(inverse(m), oracle.inverse, 1e-3f);
                Near(transpose(m), oracle.transpose);
                Near(transform(m, p), oracle.MultiplyPoint3x4(p), 1e-4f);
                Near(mul(inverse(new float3x3(m)), mul(new float3x3(m), p)), p, 1e-4f);
                Assert.That(determinant(m), Is.EqualTo(oracle.determinant).Within(1e-3));
                Near(rotate(q, p), (Quaternion)q * (Vector3)p);
                quaternion again = quaternion(new float3x3(q));
                Assert.That(abs(dot(q, again)), Is.EqualTo(1).Within(1e-4));
            }
        }

        [Test]
        public void Rows_and_columns_of_a_matrix_are_where_they_belong()
        {
            float3x3 m = float3x3(1, 2, 3, 4, 5, 6, 7, 8, 9);
            Assert.That(m.c0.Equals(float3(1, 4, 7)));
            Assert.That(mul(m, float3(1, 0, 0)).Equals(float3(1, 4, 7)));
            Assert.That(mul(float3(1, 0, 0), m).Equals(float3(1, 2, 3)));
            m[2] = float3(0, 0, 1);
            Assert.That(m.c2.Equals(float3(0, 0, 1)));
        }

        [Test]
        public void Euler_angles_turn_in_the_order_of_their_name()
        {
            float3 angles = radians(float3(30, 40, 50));
            var unity = (quaternion)Quaternion.Euler(30, 40, 50);
            Assert.That(abs(dot(Unity.Mathematics.quaternion.EulerZXY(angles), unity)), Is.EqualTo(1).Within(1e-5));
            Assert.That(abs(dot(Unity.Mathematics.quaternion.Euler(angles), unity)), Is.EqualTo(1).Within(1e-5));
            quaternion x = Unity.Mathematics.quaternion.RotateX(angles.x), y = Unity.Mathematics.quaternion.RotateY(angles.y),
                z = Unity.Mathematics.quaternion.RotateZ(angles.z);
            Assert.That(abs(dot(Unity.Mathematics.quaternion.EulerXYZ(angles), mul(z, mul(y, x)))), Is.EqualTo(1).Within(1e-5));
        }

        [Test]
        public void Random_numbers_follow_xorshift_and_stay_in_range()
        {
            // One step of Marsaglia's xorshift32 from 1, then one more, by hand.
            Assert.That(new Random(1).state, Is.EqualTo(270369));
            Assert.That(new Random(1).NextUInt(), Is.EqualTo(270368));
            Assert.Throws<ArgumentException>(() => new Random(0));
            var random = new Random(77);
            for (int i = 0; i < 1000; i++)
            {
                Assert.That(random.NextFloat(), Is.GreaterThanOrEqualTo(0).And.LessThan(1));
                Assert.That(random.NextInt(-3, 4), Is.InRange(-3, 3));
                Assert.That(length(random.NextFloat3Direction()), Is.EqualTo(1).Within(1e-4));
                Assert.That(random.NextDouble(), Is.GreaterThanOrEqualTo(0).And.LessThan(1));
            }
        }

        [Test]
        public void Structs_have_the_sizes_that_shaders_expect()
        {
            Assert.That(Unity.Collections.LowLevel.Unsafe.UnsafeUtility.SizeOf<float3>(), Is.EqualTo(12));
            Assert.That(Unity.Collections.LowLevel.Unsafe.UnsafeUtility.SizeOf<float3x3>(), Is.EqualTo(36));
            Assert.That(Unity.Collections.LowLevel.Unsafe.UnsafeUtility.SizeOf<float4x4>(), Is.EqualTo(64));
            Assert.That(Unity.Collections.LowLevel.Unsafe.UnsafeUtility.SizeOf<uint2>(), Is.EqualTo(8));
        }

        [Test]
        public void Hashes_tell_neighbors_apart()
        {
            var seen = new System.Collections.Generic.HashSet<uint>();
            for (int x = 0; x < 20; x++)
                for (int y = 0; y < 20; y++)
                    for (int z = 0; z < 20; z++)
                        seen.Add(hash(int3(x, y, z)));
            Assert.That(seen.Count, Is.GreaterThan(7990));
        }

        [Test]
        public void Smooth_functions_have_their_known_values()
        {
            Assert.That(smoothstep(0f, 2f, 0.5f), Is.EqualTo(0.15625f).Within(1e-6));
            Assert.That(lerp(float2(0, 10), float2(4, 20), 0.25f).Equals(float2(1, 12.5f)));
            Assert.That(remap(0f, 10f, 100f, 200f, 5f), Is.EqualTo(150).Within(1e-4));
            Near(normalize(float3(3, 0, 4)), float3(0.6f, 0, 0.8f));
            Near(normalizesafe(default(float3), float3(1, 0, 0)), float3(1, 0, 0));
            Near(reflect(float3(1, -1, 0), float3(0, 1, 0)), float3(1, 1, 0));
            Near(cross(float3(1, 0, 0), float3(0, 1, 0)), float3(0, 0, 1));
            Assert.That(log2(8f), Is.EqualTo(3).Within(1e-6));
            Assert.That(frac(-0.25f), Is.EqualTo(0.75f).Within(1e-6));
            Assert.That(isnan(sqrt(-1f)));
        }
    }
}
