using System;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>The surface is averaged over time where the water is still, and only there.</summary>
    [Category("LongRun")]
    public class SteadySurfaceTests
    {
        const float Spacing = 0.05f;

        readonly SurfacePicture picture = new SurfacePicture();

        [TestCase(12)]
        [TestCase(24)]
        [TestCase(36)]
        public void A_wave_is_drawn_where_it_is(int frames)
        {
            // A standing wave 20 d long, of a period of 48 frames: at its crests, where it stands for a moment, and between.
            using (var fluid = new TestFluid(new float3(40f, 16f, 12f) * Spacing, Spacing, 6000))
            {
                fluid.AddBlock(0f, new float3(40f, 9f, 12f) * Spacing).Step(40);
                float4[] velocities = fluid.Read().velocities, positions = fluid.Read().positions;
                const float k = 2f * Mathf.PI / 20f, speed = 8f;        // d/s
                for (int i = 0; i < velocities.Length; i++)
                    velocities[i].xyz = speed * math.exp(k * (positions[i].y - 9f)) * new float3(-math.sin(k * positions[i].x),
                        math.cos(k * positions[i].x), 0f);
                fluid.Solver.Velocities.SetData(velocities);
                picture.Look(new Vector3(20f, 80f, 6f) * Spacing, new Vector3(20f, 0f, 6f) * Spacing, -8f * Spacing, 200, 50);
                for (int frame = 0; frame < frames; frame++)
                    picture.Draw(fluid.Step());
                (double rms, double max, double crest, double height) = DifferenceFromAFirstFrame(fluid);
                TestContext.Out.WriteLine(
                    $"after {frames} frames: {rms:F4} d rms, {max:F3} d at most, {crest:F3} d at the crest, of a wave of {height:F2} d");
                Assert.That(height, Is.GreaterThan(1.0), "a wave");
                Assert.That(crest, Is.LessThan(0.05));
                Assert.That(rms, Is.LessThan(0.025));
                Assert.That(max, Is.LessThan(0.1));
            }
        }

        // From the surface of the same state with nothing before it. Lengths in d; height: from the trough to the crest.
        (double rms, double max, double crest, double height) DifferenceFromAFirstFrame(TestFluid fluid)
        {
            double[] drawn = picture.Depth;
            fluid.Solver.ReleaseSurface();
            picture.Draw(fluid);
            double squares = 0.0, max = 0.0, low = double.MaxValue, high = 0.0, drawnLow = double.MaxValue;
            for (int i = 0; i < drawn.Length; i++)
            {
                double difference = (drawn[i] - picture.Depth[i]) / Spacing;
                squares += difference * difference;
                max = Math.Max(max, Math.Abs(difference));
                drawnLow = Math.Min(drawnLow, drawn[i] / Spacing);
                low = Math.Min(low, picture.Depth[i] / Spacing);
                high = Math.Max(high, picture.Depth[i] / Spacing);
            }
            return (Math.Sqrt(squares / drawn.Length), max, Math.Abs(drawnLow - low), high - low);
        }

        [Test]
        public void Falling_water_is_drawn_where_it_is()
        {
            using (var fluid = new TestFluid(new float3(20f, 60f, 20f) * Spacing, Spacing, 1000))
            {
                fluid.AddBlock(new float3(5f, 49f, 5f) * Spacing, new float3(10f) * Spacing);
                picture.Look(new Vector3(10f, 80f, 10f) * Spacing, new Vector3(10f, 0f, 10f) * Spacing, -8f * Spacing, 60, 60);
                for (int frame = 0; frame < 6; frame++)
                    picture.Draw(fluid.Step());
                Assert.That(DifferenceFromAFirstFrame(fluid).max, Is.LessThan(0.05));
            }
        }
    }
}
