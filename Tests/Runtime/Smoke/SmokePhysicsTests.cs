using System;
using System.Collections.Generic;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Flows of air that theory knows.</summary>
    public class SmokePhysicsTests
    {
        [Test, Category("LongRun")]
        public void A_vortex_ring_keeps_its_speed()
        {
            const float Radius = 6f, Core = 1.5f, Circulation = 240f;       // d, d, d²/s
            SmokeSettings settings = SmokeStage.Lasting(BoxWalls.All);
            settings.vorticity = SmokeSettings.Default.vorticity;
            using (var stage = new SmokeStage(new int3(28, 52, 28), settings))
            {
                stage.Fluid.Input.gravity = 0f;
                stage.Step(1);
                stage.Smoke.Flow.SetData(Ring(stage, new float3(14f, 9f, 14f), Radius, Core, Circulation));
                double start = Height(stage.Read());
                var heights = new List<double>();
                const int StepsApart = 10;
                while (heights.Count < 40 && (heights.Count == 0 || heights[heights.Count - 1] < start + 5.5 * Radius))
                    heights.Add(Height(stage.Step(StepsApart)));
                double first = SpeedBetween(heights, start + 0.5 * Radius, start + 1.5 * Radius, StepsApart * stage.StepTime);
                double last = SpeedBetween(heights, start + 4.0 * Radius, start + 5.0 * Radius, StepsApart * stage.StepTime);
                TestContext.WriteLine($"{first:0.00} d/s, after 5 radii {last:0.00}");
                Assert.That(last / first, Is.EqualTo(1.0).Within(0.2));
            }
        }

        // Morton, Taylor and Turner 1956: over a small source of heat a plume of a radius b = 6/5 alpha z rises at w ~ z^(-1/3), both of its mean
        // flow (top hat), alpha 0.08 to 0.13. On a grid of half as many cells along a side it stays too narrow.
        [Test, Category("LongRun"), Category("GpuOnly")]
        public void A_plume_widens_and_slows_as_theory_says()
        {
            var counts = new int3(96, 128, 96);
            using (var stage = new SmokeStage(counts, SmokeStage.Lasting(BoxWalls.All & ~BoxWalls.Bottom)))
            {
                stage.AddSource(new float3(48f, 3f, 48f), 4f, 10f).Step(600);
                double[] volume = new double[counts.y], momentum = new double[counts.y];
                const int Samples = 400, StepsApart = 6;
                for (int sample = 0; sample < Samples; sample++)
                {
                    stage.Step(StepsApart);
                    stage.ForEachCell((x, y, z) =>
                    {
                        if (stage.Heat(x, y, z) < 1.6f / (8 + y))
                            return;
                        double w = Math.Max(stage.Rise(x, y, z), 0f);
                        volume[y] += w / Samples;
                        momentum[y] += w * w / Samples;
                    });
                }
                var at = new List<(double z, double b, double w)>();
                for (int y = 32; y < 104; y++)
                    at.Add((y + 0.5, volume[y] / Math.Sqrt(Math.PI * momentum[y]), momentum[y] / volume[y]));
                (double slope, double offset) = Line(at.ConvertAll(p => (p.z, p.b)));
                double alpha = 5.0 / 6.0 * slope, origin = -offset / slope, factor = 0;
                foreach ((double z, _, double w) in at)
                    factor += w * Math.Pow(z - origin, 1.0 / 3.0) / at.Count;
                TestContext.WriteLine($"alpha {alpha:0.000}, origin at {origin:0.0} d");
                Assert.That(alpha, Is.InRange(0.08, 0.13));
                foreach ((double z, double b, double w) in at)
                {
                    double theory = factor * Math.Pow(z - origin, -1.0 / 3.0);
                    TestContext.WriteLine($"{z:0.0} d: b {b:0.00} d, w {w:0.00} d/s, by theory {theory:0.00}");
                    Assert.That(w / theory, Is.EqualTo(1.0).Within(0.2), $"at {z} d");
                }
            }
        }

        // Velocities of a ring of straight pieces, with the core's smoothing (Rosenhead and Moore).
        static float[] Ring(SmokeStage stage, float3 center, float radius, float core, float circulation)
        {
            const int Pieces = 48;
            float[] flow = new float[stage.Flow.Length];
            int3 counts = stage.Counts;
            for (int axis = 0; axis < 3; axis++)
                for (int z = 0; z < counts.z + (axis == 2 ? 1 : 0); z++)
                    for (int y = 0; y < counts.y + (axis == 1 ? 1 : 0); y++)
                        for (int x = 0; x < counts.x + (axis == 0 ? 1 : 0); x++)
                        {
                            float3 at = new float3(x, y, z) + 0.5f;
                            at[axis] -= 0.5f;
                            float sum = 0f;
                            for (int piece = 0; piece < Pieces; piece++)
                            {
                                math.sincos(2f * math.PI * piece / Pieces, out float sine, out float cosine);
                                float3 from = center + radius * new float3(cosine, 0f, sine), along = new float3(sine, 0f, -cosine);
                                float3 apart = at - from;
                                float3 turned = math.cross(along, apart) * (2f * math.PI * radius / Pieces);
                                sum += turned[axis] / math.pow(math.dot(apart, apart) + core * core, 1.5f);
                            }
                            flow[stage.Face(axis, x, y, z)] = circulation / (4f * math.PI) * sum;
                        }
            return flow;
        }

        // Mean height of what turns fast, d.
        static double Height(SmokeStage stage)
        {
            double sum = 0, all = 0;
            for (int z = 1; z < stage.Counts.z - 1; z++)
                for (int y = 1; y < stage.Counts.y - 1; y++)
                {
                    int x = stage.Counts.x / 2;
                    float curl = stage.Flow[stage.Face(2, x, y + 1, z)] - stage.Flow[stage.Face(2, x, y, z)]
                        - stage.Flow[stage.Face(1, x, y, z + 1)] + stage.Flow[stage.Face(1, x, y, z)];
                    double weight = curl * curl;
                    sum += weight * y;
                    all += weight;
                }
            return sum / all;
        }

        static double SpeedBetween(List<double> heights, double from, double to, double time)
        {
            double At(double height)
            {
                int i = heights.FindIndex(h => h >= height);
                Assert.That(i, Is.GreaterThan(0), $"it comes to {height:0.0} d");
                return i - 1 + (height - heights[i - 1]) / (heights[i] - heights[i - 1]);
            }
            return (to - from) / ((At(to) - At(from)) * time);
        }

        static (double slope, double offset) Line(List<(double x, double y)> points)
        {
            double n = points.Count, sx = 0, sy = 0, sxx = 0, sxy = 0;
            foreach ((double x, double y) in points)
            {
                sx += x;
                sy += y;
                sxx += x * x;
                sxy += x * y;
            }
            double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
            return (slope, (sy - slope * sx) / n);
        }
    }
}
