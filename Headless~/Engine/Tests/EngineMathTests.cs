using System;
using NUnit.Framework;
using UnityEngine;
using Numerics = System.Numerics;
using Random = System.Random;

namespace Host.Tests
{
    public class EngineMathTests
    {
        static float Next(Random random, float range) => (float)(random.NextDouble() * 2 - 1) * range;
        static Vector3 NextVector(Random random, float range) => new Vector3(Next(random, range), Next(random, range), Next(random, range));
        static Quaternion NextRotation(Random random)
            => Quaternion.Normalize(new Quaternion(Next(random, 1), Next(random, 1), Next(random, 1), Next(random, 1)));

        static void Near(Vector3 actual, Vector3 expected, float within = 1e-5f)
            => Assert.That((actual - expected).magnitude, Is.LessThan(within * Mathf.Max(1, expected.magnitude)),
                $"{actual:G9} instead of {expected:G9}");

        static void Near(Matrix4x4 actual, Matrix4x4 expected, float within = 1e-5f)
        {
            for (int i = 0; i < 16; i++)
                Assert.That(actual[i], Is.EqualTo(expected[i]).Within(within * Mathf.Max(1, Mathf.Abs(expected[i]))),
                    $"element {i} of\n{actual}\ninstead of\n{expected}");
        }

        // Row vectors there, column vectors here: the transpose.
        static Matrix4x4 From(Numerics.Matrix4x4 m) => new Matrix4x4(
            new Vector4(m.M11, m.M12, m.M13, m.M14), new Vector4(m.M21, m.M22, m.M23, m.M24),
            new Vector4(m.M31, m.M32, m.M33, m.M34), new Vector4(m.M41, m.M42, m.M43, m.M44));

        [Test]
        public void A_matrix_lies_column_by_column_in_memory()
        {
            var m = new Matrix4x4(new Vector4(0, 1, 2, 3), new Vector4(4, 5, 6, 7), new Vector4(8, 9, 10, 11), new Vector4(12, 13, 14, 15));
            for (int i = 0; i < 16; i++)
                Assert.That(m[i], Is.EqualTo(i));
            Assert.That(m.m10, Is.EqualTo(1));
            Assert.That(m.m03, Is.EqualTo(12));
            Assert.That(m[2, 3], Is.EqualTo(14));
            Assert.That(m.GetRow(1), Is.EqualTo(new Vector4(1, 5, 9, 13)));
            unsafe { Assert.That(((float*)&m)[6], Is.EqualTo(6)); }
        }

        [Test]
        public void Rotations_multiply_as_quaternions_and_as_matrices_alike()
        {
            var random = new Random(1);
            for (int i = 0; i < 100; i++)
            {
                Quaternion a = NextRotation(random), b = NextRotation(random);
                Vector3 p = NextVector(random, 10);
                Numerics.Quaternion na = new Numerics.Quaternion(a.x, a.y, a.z, a.w), nb = new Numerics.Quaternion(b.x, b.y, b.z, b.w);
                Numerics.Vector3 oracle = Numerics.Vector3.Transform(new Numerics.Vector3(p.x, p.y, p.z), na * nb);
                var expected = new Vector3(oracle.X, oracle.Y, oracle.Z);
                Near(a * b * p, expected);
                Near(a * (b * p), expected);
                Near((Matrix4x4.Rotate(a) * Matrix4x4.Rotate(b)).MultiplyPoint(p), expected);
            }
        }

        [Test]
        public void TRS_scales_then_rotates_then_moves()
        {
            var random = new Random(2);
            for (int i = 0; i < 100; i++)
            {
                Vector3 t = NextVector(random, 5), s = NextVector(random, 3), p = NextVector(random, 5);
                Quaternion q = NextRotation(random);
                Near(Matrix4x4.TRS(t, q, s).MultiplyPoint3x4(p), t + q * Vector3.Scale(s, p));
            }
        }

        [Test]
        public void An_inverse_agrees_with_System_Numerics()
        {
            var random = new Random(3);
            for (int i = 0; i < 100; i++)
            {
                var n = new Numerics.Matrix4x4(
                    Next(random, 2), Next(random, 2), Next(random, 2), Next(random, 2), Next(random, 2), Next(random, 2), Next(random, 2),
                    Next(random, 2),
                    Next(random, 2), Next(random, 2), Next(random, 2), Next(random, 2), Next(random, 2), Next(random, 2), Next(random, 2),
                        Next(random, 2));
                if (Math.Abs(n.GetDeterminant()) < 0.1f)
                    continue;
                Assert.That(Numerics.Matrix4x4.Invert(n, out Numerics.Matrix4x4 inverse));
                Near(From(n).inverse, From(inverse), 1e-4f);
                Assert.That(From(n).determinant, Is.EqualTo(n.GetDeterminant()).Within(1e-4));
                Near(From(n) * From(n).inverse, Matrix4x4.identity, 1e-4f);
            }
        }

        [Test]
        public void A_singular_matrix_has_the_zero_matrix_for_inverse()
            => Assert.That(Matrix4x4.Scale(new Vector3(1, 0, 1)).inverse.Equals(Matrix4x4.zero));

        [Test]
        public void A_perspective_maps_near_to_minus_one_and_far_to_one()
        {
            Matrix4x4 m = Matrix4x4.Perspective(60, 16f / 9, 0.3f, 1000);
            Assert.That(m.MultiplyPoint(new Vector3(0, 0, -0.3f)).z, Is.EqualTo(-1).Within(1e-5));
            Assert.That(m.MultiplyPoint(new Vector3(0, 0, -1000)).z, Is.EqualTo(1).Within(1e-4));
            float half = 10 * Mathf.Tan(30 * Mathf.Deg2Rad);
            Near(m.MultiplyPoint(new Vector3(half * 16 / 9, half, -10)), new Vector3(1, 1, m.MultiplyPoint(new Vector3(0, 0, -10)).z));
            FrustumPlanes planes = m.decomposeProjection;
            Assert.That(planes.zNear, Is.EqualTo(0.3f).Within(1e-4));
            Assert.That(planes.zFar, Is.EqualTo(1000).Within(1));
            Assert.That(planes.top, Is.EqualTo(0.3f * Mathf.Tan(30 * Mathf.Deg2Rad)).Within(1e-5));
        }

        [Test]
        public void An_orthographic_projection_maps_its_box_to_the_unit_cube()
        {
            Matrix4x4 m = Matrix4x4.Ortho(-2, 6, -1, 3, 0.5f, 10);
            Near(m.MultiplyPoint(new Vector3(-2, -1, -0.5f)), new Vector3(-1, -1, -1));
            Near(m.MultiplyPoint(new Vector3(6, 3, -10)), new Vector3(1, 1, 1));
            Near(new Vector3(m.decomposeProjection.left, m.decomposeProjection.top, m.decomposeProjection.zFar), new Vector3(-2, 3, 10));
        }

        [Test]
        public void LookAt_places_an_object_that_looks_along_z()
        {
            Matrix4x4 m = Matrix4x4.LookAt(new Vector3(1, 2, 3), new Vector3(5, 2, 3), Vector3.up);
            Near(m.GetPosition(), new Vector3(1, 2, 3));
            Near(m.MultiplyVector(Vector3.forward), Vector3.right);
            Near(m.MultiplyVector(Vector3.up), Vector3.up);
        }

        [Test]
        public void Euler_angles_turn_about_z_then_x_then_y()
        {
            Quaternion q = Quaternion.Euler(30, 40, 50);
            Quaternion expected = Quaternion.AngleAxis(40, Vector3.up) * Quaternion.AngleAxis(30, Vector3.right) * Quaternion.AngleAxis(50,
                Vector3.forward);
            Assert.That(Quaternion.Angle(q, expected), Is.LessThan(0.01f));
            Near(q.eulerAngles, new Vector3(30, 40, 50), 1e-4f);
            // Left-handed: 90 degrees about y turn forward to the right.
            Near(Quaternion.Euler(0, 90, 0) * Vector3.forward, Vector3.right);
            Near(Quaternion.Euler(90, 0, 0) * Vector3.forward, Vector3.down);
        }

        [TestCase(90, 10, 0)]
        [TestCase(-90, 200, 0)]
        [TestCase(0, 0, 0)]
        [TestCase(89, 359, 180)]
        [TestCase(-45, -60, -170)]
        public void Euler_angles_of_a_rotation_give_the_rotation_back(float x, float y, float z)
        {
            Quaternion q = Quaternion.Euler(x, y, z);
            Vector3 angles = q.eulerAngles;
            Assert.That(Mathf.Abs(Quaternion.Dot(q, Quaternion.Euler(angles))), Is.EqualTo(1).Within(1e-5), $"{angles}");
            Assert.That(angles.x, Is.InRange(0, 360));
            Assert.That(angles.y, Is.InRange(0, 360));
            Assert.That(angles.z, Is.InRange(0, 360));
        }

        [Test]
        public void LookRotation_has_its_forward_and_an_up_nearest_to_the_one_given()
        {
            var random = new Random(4);
            for (int i = 0; i < 100; i++)
            {
                Vector3 forward = NextVector(random, 1).normalized, up = NextVector(random, 1).normalized;
                Quaternion q = Quaternion.LookRotation(forward, up);
                Near(q * Vector3.forward, forward, 1e-4f);
                Assert.That(Vector3.Dot(q * Vector3.right, up), Is.EqualTo(0).Within(1e-4));
                Assert.That(Vector3.Dot(q * Vector3.up, up), Is.GreaterThan(0));
            }
            Near(Quaternion.LookRotation(Vector3.up, Vector3.up) * Vector3.forward, Vector3.up);
        }

        [Test]
        public void FromToRotation_turns_one_direction_into_the_other()
        {
            var random = new Random(5);
            for (int i = 0; i < 100; i++)
            {
                Vector3 a = NextVector(random, 1), b = NextVector(random, 1);
                Near(Quaternion.FromToRotation(a, b) * a.normalized, b.normalized, 1e-4f);
            }
            Near(Quaternion.FromToRotation(Vector3.up, Vector3.down) * Vector3.up, Vector3.down);
        }

        [Test]
        public void Slerp_moves_at_constant_angle_the_short_way()
        {
            Quaternion a = Quaternion.identity, b = Quaternion.AngleAxis(120, Vector3.up);
            var minus = new Quaternion(-b.x, -b.y, -b.z, -b.w);
            Assert.That(Quaternion.Angle(Quaternion.Slerp(a, b, 0.25f), Quaternion.AngleAxis(30, Vector3.up)), Is.LessThan(0.01));
            Assert.That(Quaternion.Angle(Quaternion.Slerp(a, minus, 0.25f), Quaternion.AngleAxis(30, Vector3.up)), Is.LessThan(0.01));
        }

        [Test]
        public void A_rotation_gives_back_its_angle_and_axis()
        {
            Quaternion.AngleAxis(75, new Vector3(1, 2, 3)).ToAngleAxis(out float angle, out Vector3 axis);
            Assert.That(angle, Is.EqualTo(75).Within(1e-3));
            Near(axis, new Vector3(1, 2, 3).normalized);
        }

        [Test]
        public void Vectors_that_differ_by_rounding_are_equal_and_tiny_ones_normalize_to_zero()
        {
            Assert.That(new Vector3(1, 2, 3) == new Vector3(1, 2, 3.000001f));
            Assert.That(new Vector3(1, 2, 3) != new Vector3(1, 2, 3.0001f));
            Assert.That(new Vector3(1, 2, 3).Equals(new Vector3(1, 2, 3.000001f)), Is.False);
            Assert.That(new Vector3(1e-6f, 0, 0).normalized, Is.EqualTo(Vector3.zero));
        }

        [Test]
        public void SmoothDamp_settles_at_its_target_without_overshoot()
        {
            float at = 0, velocity = 0;
            for (int i = 0; i < 300; i++)
            {
                at = Mathf.SmoothDamp(at, 10, ref velocity, 0.3f, Mathf.Infinity, 0.016f);
                Assert.That(at, Is.LessThanOrEqualTo(10f));
            }
            Assert.That(at, Is.EqualTo(10).Within(1e-3));
        }

        [TestCase(0f)]
        [TestCase(1f)]
        [TestCase(-2.5f)]
        [TestCase(65504f)]
        [TestCase(6.1e-5f)]
        [TestCase(5.96e-8f)]
        [TestCase(1e6f)]
        [TestCase(float.NaN)]
        [TestCase(0.1f)]
        [TestCase(2049f)]
        public void Halves_agree_with_the_framework(float value)
        {
            ushort expected = BitConverter.HalfToUInt16Bits((Half)value);
            if (float.IsNaN(value))
                Assert.That(Mathf.HalfToFloat(Mathf.FloatToHalf(value)), Is.NaN);
            else
            {
                Assert.That(Mathf.FloatToHalf(value), Is.EqualTo(expected));
                Assert.That(Mathf.HalfToFloat(expected), Is.EqualTo((float)BitConverter.UInt16BitsToHalf(expected)));
            }
        }

        [Test]
        public void Rounding_goes_to_the_even_neighbor_and_powers_of_two_are_found()
        {
            Assert.That(Mathf.RoundToInt(2.5f), Is.EqualTo(2));
            Assert.That(Mathf.RoundToInt(3.5f), Is.EqualTo(4));
            Assert.That(Mathf.FloorToInt(-0.5f), Is.EqualTo(-1));
            Assert.That(Mathf.NextPowerOfTwo(100003), Is.EqualTo(131072));
            Assert.That(Mathf.NextPowerOfTwo(64), Is.EqualTo(64));
            Assert.That(Mathf.ClosestPowerOfTwo(70), Is.EqualTo(64));
            Assert.That(Mathf.Repeat(-1, 3), Is.EqualTo(2));
            Assert.That(Mathf.DeltaAngle(350, 10), Is.EqualTo(20).Within(1e-4));
        }

        [Test]
        public void Bounds_grow_contain_and_stop_rays()
        {
            var bounds = new Bounds(new Vector3(1, 0, 0), new Vector3(2, 2, 2));
            Assert.That(bounds.Contains(new Vector3(2, 1, 1)));
            Assert.That(bounds.Contains(new Vector3(2.01f, 0, 0)), Is.False);
            Assert.That(bounds.IntersectRay(new Ray(new Vector3(-5, 0, 0), Vector3.right), out float distance));
            Assert.That(distance, Is.EqualTo(5).Within(1e-5));
            Assert.That(bounds.IntersectRay(new Ray(new Vector3(-5, 0, 0), Vector3.left)), Is.False);
            bounds.Encapsulate(new Vector3(1, 5, 0));
            Near(bounds.max, new Vector3(2, 5, 1));
            Assert.That(bounds.SqrDistance(new Vector3(1, 7, 0)), Is.EqualTo(4).Within(1e-5));
        }

        [Test]
        public void Frustum_planes_face_inwards()
        {
            Matrix4x4 view = Matrix4x4.Scale(new Vector3(1, 1, -1));     // a camera at the origin that looks along +z
            Plane[] planes = GeometryUtility.CalculateFrustumPlanes(Matrix4x4.Perspective(90, 1, 1, 100) * view);
            foreach (Plane plane in planes)
                Assert.That(plane.GetDistanceToPoint(new Vector3(0, 0, 10)), Is.GreaterThan(0));
            Near(planes[0].normal, new Vector3(1, 0, 1).normalized);
            Near(planes[4].normal, Vector3.forward);
            Assert.That(planes[4].distance, Is.EqualTo(-1).Within(1e-4));
            Assert.That(GeometryUtility.TestPlanesAABB(planes, new Bounds(new Vector3(0, 0, 10), Vector3.one)));
            Assert.That(GeometryUtility.TestPlanesAABB(planes, new Bounds(new Vector3(0, 0, -10), Vector3.one)), Is.False);
            Assert.That(GeometryUtility.TestPlanesAABB(planes, new Bounds(new Vector3(20, 0, 10), Vector3.one)), Is.False);
        }

        [Test]
        public void A_curve_passes_through_its_keys_with_their_slopes()
        {
            var curve = new AnimationCurve(new Keyframe(0, 1, 0, 2), new Keyframe(2, 3, -1, 0));
            Assert.That(curve.Evaluate(0), Is.EqualTo(1));
            Assert.That(curve.Evaluate(2), Is.EqualTo(3));
            Assert.That((curve.Evaluate(0.001f) - 1) / 0.001f, Is.EqualTo(2).Within(0.01));
            Assert.That((3 - curve.Evaluate(1.999f)) / 0.001f, Is.EqualTo(-1).Within(0.02));
            Assert.That(curve.Evaluate(9), Is.EqualTo(3));
            Assert.That(AnimationCurve.Linear(0, 0, 4, 8).Evaluate(1), Is.EqualTo(2).Within(1e-5));
            Assert.That(AnimationCurve.EaseInOut(0, 0, 1, 1).Evaluate(0.25f), Is.EqualTo(0.15625f).Within(1e-5));
            curve.postWrapMode = WrapMode.Loop;
            Assert.That(curve.Evaluate(2.5f), Is.EqualTo(curve.Evaluate(0.5f)).Within(1e-5));
        }

        [Test]
        public void A_weight_of_a_third_changes_nothing_in_a_curve()
        {
            var plain = new AnimationCurve(new Keyframe(0, 1, 0, 2), new Keyframe(2, 3, -1, 0));
            var weighted = new AnimationCurve(new Keyframe(0, 1, 0, 2, 0, 1f / 3), new Keyframe(2, 3, -1, 0, 1f / 3, 0));
            for (float t = 0; t <= 2; t += 0.1f)
                Assert.That(weighted.Evaluate(t), Is.EqualTo(plain.Evaluate(t)).Within(1e-5), $"at {t}");
        }

        [Test]
        public void A_gradient_blends_or_steps()
        {
            var gradient = new Gradient();
            gradient.SetKeys(new[] { new GradientColorKey(Color.red, 0), new GradientColorKey(Color.green, 0.5f),
                new GradientColorKey(Color.blue, 1) }, new[] { new GradientAlphaKey(0, 0), new GradientAlphaKey(1, 1) });
            Assert.That(gradient.Evaluate(0.25f) == new Color(0.5f, 0.5f, 0, 0.25f));
            gradient.mode = GradientMode.Fixed;
            Assert.That(gradient.Evaluate(0.25f) == new Color(0, 1, 0, 1));
            Assert.That(gradient.Evaluate(0.75f) == new Color(0, 0, 1, 1));
        }

        [Test]
        public void The_same_seed_gives_the_same_numbers_in_range()
        {
            UnityEngine.Random.InitState(42);
            var state = UnityEngine.Random.state;
            float[] first = { UnityEngine.Random.value, UnityEngine.Random.Range(-3f, 5f), UnityEngine.Random.Range(2, 7) };
            UnityEngine.Random.state = state;
            Assert.That(new[] { UnityEngine.Random.value, UnityEngine.Random.Range(-3f, 5f), UnityEngine.Random.Range(2, 7) }, Is.EqualTo(first));
            for (int i = 0; i < 1000; i++)
            {
                Assert.That(UnityEngine.Random.Range(2, 7), Is.InRange(2, 6));
                Assert.That(UnityEngine.Random.Range(-3f, 5f), Is.InRange(-3f, 5f));
                Assert.That(UnityEngine.Random.insideUnitSphere.magnitude, Is.LessThanOrEqualTo(1.0001f));
                Assert.That(UnityEngine.Random.onUnitSphere.magnitude, Is.EqualTo(1).Within(1e-4));
            }
        }

        [Test]
        public void Colors_go_through_HSV_and_linear_space_and_back()
        {
            var random = new Random(6);
            for (int i = 0; i < 100; i++)
            {
                var color = new Color((float)random.NextDouble(), (float)random.NextDouble(), (float)random.NextDouble());
                Color.RGBToHSV(color, out float h, out float s, out float v);
                Assert.That(Color.HSVToRGB(h, s, v) == color, $"{color} through {h}, {s}, {v}");
                Assert.That(color.linear.gamma == color);
            }
            Assert.That(((Color32)new Color(0.5f, 1.5f, -1, 1)).ToString(), Is.EqualTo("RGBA(128, 255, 0, 255)"));
        }
    }
}
