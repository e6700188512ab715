using System;
using System.Collections.Generic;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>The same water is the same surface in pictures of other sizes, to another eye and from another place.</summary>
    public class SurfaceViewsTests
    {
        const float Spacing = 0.05f;

        TestFluid fluid;
        SurfacePicture one, other;

        [SetUp]
        public void Make()
        {
            // A block that has fallen over: a flat pool, a front that runs and a heap.
            fluid = new TestFluid(new float3(36f, 24f, 20f) * Spacing, Spacing, 36 * 20 * 16);
            fluid.AddBlock(0f, new float3(36f, 5f, 20f) * Spacing).AddBlock(new float3(0f, 5f, 0f) * Spacing, new float3(10f, 11f, 20f) * Spacing);
            one = new SurfacePicture();
            other = new SurfacePicture();
        }

        [TearDown]
        public void Release()
        {
            one.Dispose();
            other.Dispose();
            fluid.Dispose();
        }

        [TestCase(1920, 1080)]
        [TestCase(3840, 2160)]
        public void A_larger_picture_shows_the_same_surface(int width, int height)
        {
            fluid.Step(16);
            Look(one, 1280, 720, 2.3f).Draw(fluid);
            Look(other, width, height, 2.3f).Draw(fluid);
            Assert.That(other.Width, Is.EqualTo(width), "the filter is not so wide that the textures are smaller");
            AssertSame(0.95);
        }

        [Test]
        public void Both_eyes_see_the_same_surface()
        {
            fluid.Step(16);
            Look(one, 512, 512, 1f).WithTwoEyes(0.064f, 0).Draw(fluid);
            Look(other, 512, 512, 1f).WithTwoEyes(0.064f, 1).Draw(fluid);
            AssertSame(0.9);
        }

        [Test]
        public void A_camera_that_moves_sees_still_water_where_it_was()
        {
            fluid.Dispose();
            fluid = new TestFluid(new float3(24f, 16f, 24f) * Spacing, Spacing, 24 * 24 * 8);
            fluid.AddBlock(0f, new float3(24f, 8f, 24f) * Spacing).Step(150);
            one.Look(From(0), At, 30f, 256, 256).Draw(fluid);
            for (int frame = 1; frame < 6; frame++)
            {
                other.Look(From(frame), At, 30f, 256, 256).Draw(fluid.Step());
                AssertSame(0.9);
                (one, other) = (other, one);
            }
        }

        static Vector3 At => new Vector3(12f, 8f, 12f) * Spacing;

        static Vector3 From(int frame) => At + Quaternion.Euler(0f, 2f * frame, 0f) * new Vector3(0f, 1.4f, -2f) * (1f - 0.01f * frame);

        static SurfacePicture Look(SurfacePicture picture, int width, int height, float distance)
        {
            var at = new Vector3(0.85f, 0.3f, 0.5f);
            return picture.Look(at + distance * new Vector3(0.55f, 1.4f, -2.4f), at, 40f, width, height);
        }

        // Distances are across the surface. Most of the water of one is seen by the other, where no edge is.
        void AssertSame(double least)
        {
            var errors = new List<double>();
            int water = 0, step = Math.Max(one.Width / 640, 1);
            for (int y = 0; y < one.Height; y += step)
                for (int x = 0; x < one.Width; x += step)
                {
                    if (one.Depth[y * one.Width + x] == 0f)
                        continue;
                    water++;
                    if (!other.TrySee(one.Point(x, y), Spacing, out float depth, out float surface) || surface < depth - Spacing)
                        continue;       // hidden there
                    one.Ray(x, y, out _, out float3 ray);
                    errors.Add(Math.Abs((surface - depth) * math.dot(ray, one.Normals[y * one.Width + x].xyz)) / Spacing);
                }
            errors.Sort();
            double squares = 0.0;
            foreach (double error in errors)
                squares += error * error;
            double rms = Math.Sqrt(squares / errors.Count), found = errors[(int)(0.99 * errors.Count)];
            TestContext.Out.WriteLine($"{water:N0} pixels of water, {100.0 * errors.Count / water:F1} % compared: {rms:F4} d rms, " +
                $"{found:F4} d at the 99th percentile, {errors[errors.Count - 1]:F2} d at most");
            Assert.That(water, Is.GreaterThan(8000));
            Assert.That(errors.Count, Is.GreaterThan(least * water));
            Assert.That(rms, Is.LessThan(0.1));
            Assert.That(found, Is.LessThan(0.1));
        }
    }
}
