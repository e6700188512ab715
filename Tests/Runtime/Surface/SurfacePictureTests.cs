using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>The surface as it is seen, against shapes that are known.</summary>
    public class SurfacePictureTests
    {
        const float Spacing = 0.05f;

        readonly SurfacePicture picture = new SurfacePicture();

        [Test]
        public void A_ball_of_water_is_as_large_as_its_particles()
        {
            const float radius = 10f;
            using (TestFluid fluid = Still(30))
            {
                float3 center = new float3(15f);
                float3[] inside = ParticleState.Lattice(0f, 0.5f, 30, 0.1f).positions.Select(p => p.xyz)
                    .Where(p => math.distance(p, center) < radius).Select(p => p * Spacing).ToArray();
                fluid.Add(inside);
                for (int step = 0; step < 60; step++)
                {
                    fluid.Step();
                    fluid.Solver.Velocities.SetData(new float4[inside.Length]);        // relaxes and goes nowhere
                }
                float3 mid = Mean(fluid) * Spacing;
                double expected = Math.Pow(3.0 * inside.Length / (4.0 * Math.PI), 1.0 / 3.0) * Spacing;
                picture.Look((Vector3)mid - new Vector3(0f, 0f, 4f), mid, 20f, 320, 320).Draw(fluid);
                double squares = 0.0;
                int both = 0, either = 0;
                for (int y = 0; y < picture.Height; y++)
                    for (int x = 0; x < picture.Width; x++)
                    {
                        picture.Ray(x, y, out float3 origin, out float3 direction);
                        bool hits = HitSphere(origin, direction, mid, expected, out double depth);
                        double drawn = picture.Depth[y * picture.Width + x];
                        either += hits || drawn > 0.0 ? 1 : 0;
                        if (!hits || drawn == 0.0)
                            continue;
                        both++;
                        squares += (drawn - depth) * (drawn - depth);
                    }
                double rms = Math.Sqrt(squares / both) / Spacing, overlap = (double)both / either;
                TestContext.Out.WriteLine(
                    $"{inside.Length:N0} particles, R = {expected / Spacing:F2} d: depth RMSE {rms:F3} d, silhouette IoU {overlap:F4}");
                Assert.That(overlap, Is.GreaterThanOrEqualTo(0.985));
                Assert.That(rms, Is.LessThanOrEqualTo(0.11));
            }
        }

        [Test, Category("LongRun")]
        public void A_pool_at_rest_is_flat_and_as_high_as_its_water()
        {
            using (var fluid = new TestFluid(new float3(32f, 24f, 32f) * Spacing, Spacing, 32 * 32 * 10))
            {
                fluid.AddBlock(0f, new float3(32f, 10f, 32f) * Spacing).Step(180);
                picture.Look(new Vector3(16f * Spacing, 4f, 16f * Spacing), new Vector3(16f, 0f, 16f) * Spacing, -24f * Spacing, 240, 240)
                    .Draw(fluid);
                double sum = 0.0, tilt = 0.0;
                for (int y = 0; y < picture.Height; y++)
                    for (int x = 0; x < picture.Width; x++)
                    {
                        Assert.That(picture.Depth[y * picture.Width + x], Is.GreaterThan(0.0), "no hole");
                        sum += picture.Point(x, y).y / Spacing - 10.0;
                        double angle = Math.Acos(Math.Min(picture.Normals[y * picture.Width + x].y, 1.0)) * 180.0 / Math.PI;
                        tilt += angle * angle;
                    }
                int pixels = picture.Depth.Length;
                double mean = sum / pixels, rms = Math.Sqrt(tilt / pixels);
                TestContext.Out.WriteLine($"pool of 10 layers: mean height error {mean:F3} d, normals {rms:F2} degrees rms");
                Assert.That(Math.Abs(mean), Is.LessThanOrEqualTo(0.03));
                Assert.That(rms, Is.LessThanOrEqualTo(2.0));
            }
        }

        [TestCase(1)]
        [TestCase(2)]
        public void A_thin_sheet_has_no_holes(int layers)
        {
            using (TestFluid fluid = Still(32))
            {
                fluid.AddBlock(new float3(2f, 15f, 2f) * Spacing, new float3(28f, layers, 28f) * Spacing, jitter: 0.2f).Step();
                picture.Look(new Vector3(16f * Spacing, 4f, 16f * Spacing), new Vector3(16f, 0f, 16f) * Spacing, -24f * Spacing, 360, 360)
                    .Draw(fluid);
                double covered = picture.Depth.Count(depth => depth > 0.0) / (double)picture.Depth.Length;
                TestContext.Out.WriteLine($"sheet of {layers} layers: {100.0 * covered:F2} % covered");
                Assert.That(covered, Is.GreaterThanOrEqualTo(0.995));
            }
        }

        [Test]
        public void Nothing_is_drawn_between_two_blobs_at_different_depths()
        {
            using (TestFluid fluid = Still(40))
            {
                fluid.AddBlock(new float3(8f, 14f, 4f) * Spacing, new float3(12f, 12f, 8f) * Spacing)
                    .AddBlock(new float3(16f, 14f, 28f) * Spacing, new float3(12f, 12f, 8f) * Spacing).Step();
                picture.Look(new Vector3(20f, 20f, -60f) * Spacing, new Vector3(20f, 20f, 20f) * Spacing, 25f, 320, 320)
                    .Draw(fluid, cell: 0.5f);
                int near = 0, far = 0;
                for (int y = 0; y < picture.Height; y++)
                    for (int x = 0; x < picture.Width; x++)
                    {
                        if (picture.Depth[y * picture.Width + x] == 0.0)
                            continue;
                        float z = picture.Point(x, y).z / Spacing;
                        near += z < 13f ? 1 : 0;
                        far += z > 27f ? 1 : 0;
                        Assert.That(z < 13f || z > 27f, $"pixel {x}, {y} lies at {z} d");
                    }
                Assert.That(near > 1000 && far > 1000);
            }
        }

        [TestCase(5)]
        [TestCase(20)]
        [TestCase(100)]
        [TestCase(200)]
        public void Thickness_is_how_deep_the_water_is(int layers)
        {
            using (var fluid = new TestFluid(new float3(14f, layers + 4f, 14f) * Spacing, Spacing, 14 * 14 * layers))
            {
                fluid.Input.gravity = 0f;
                fluid.AddBlock(new float3(0f, 2f, 0f) * Spacing, new float3(14f, layers, 14f) * Spacing, jitter: 0.1f).Step();
                float top = (layers + 4f) * Spacing;
                picture.Look(new Vector3(7f * Spacing, top + 1f, 7f * Spacing), new Vector3(7f * Spacing, 0f, 7f * Spacing), -10f * Spacing,
                    200, 200).Draw(fluid);
                double mean = picture.Thickness.Average() / Spacing;
                TestContext.Out.WriteLine($"{layers} layers: thickness {mean:F2} d");
                Assert.That(mean, Is.EqualTo(layers).Within(0.25));
            }
        }

        static TestFluid Still(int cells)
        {
            var fluid = new TestFluid(new float3(cells) * Spacing, Spacing, cells * cells * cells);
            fluid.Input.gravity = 0f;
            return fluid;
        }

        static float3 Mean(TestFluid fluid)
        {
            float4[] positions = fluid.Read().positions;
            double3 sum = 0.0;
            foreach (float4 position in positions)
                sum += position.xyz;
            return (float3)(sum / positions.Length);
        }

        // depth: along the view, in lengths of the direction.
        static bool HitSphere(double3 origin, double3 direction, double3 center, double radius, out double depth)
        {
            double3 from = origin - center;
            double a = math.dot(direction, direction), b = math.dot(from, direction), c = math.dot(from, from) - radius * radius,
                root = b * b - a * c;
            depth = root >= 0.0 ? (-b - math.sqrt(root)) / a : 0.0;
            return root >= 0.0;
        }
    }
}
