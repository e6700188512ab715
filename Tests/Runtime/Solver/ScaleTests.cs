using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>One dam break at three resolutions: every setting is meant to mean the same at any spacing.</summary>
    public class ScaleTests
    {
        // 6, 9 and 12 layers: shallow enough for one number of iterations to hold the water up at all three.
        static readonly float[] Spacings = { 0.075f, 0.05f, 0.0375f };
        static readonly float3 Box = new float3(1.2f, 1.5f, 0.3f), Dam = new float3(0.6f, 0.45f, 0.3f);
        const int Seconds = 3;

        Run[] runs;

        [OneTimeSetUp]
        public void Play()
        {
            runs = Spacings.Select(spacing => new Run(spacing)).ToArray();
            TestContext.Out.WriteLine(Report());
        }

        [Test]
        public void Settled_water_has_the_same_volume_at_any_spacing()
        {
            AssertSame("volume ratio", runs.Select(run => run.VolumeRatio));
        }

        [Test]
        public void The_front_of_a_dam_break_runs_alike_at_any_spacing()
        {
            foreach (int step in new[] { 6, 9, 12, 15 })
                AssertSame($"front after {step} steps", runs.Select(run => run.Fronts[step]));
        }

        [Test]
        public void The_water_turns_back_at_the_same_time_at_any_spacing()
        {
            AssertSame("first turn", runs.Select(run => run.Turns[0]));
            AssertSame("second turn", runs.Select(run => run.Turns[1]));
        }

        [Test]
        public void The_water_settles_at_the_same_time_at_any_spacing()
        {
            AssertSame("settling time", runs.Select(run => run.SettlingTime));
        }

        void AssertSame(string what, IEnumerable<float> values)
        {
            float mean = values.Average();
            foreach (float value in values)
                Assert.That(value, Is.EqualTo(mean).Within(5).Percent, $"{what}\n{Report()}");
        }

        string Report() => string.Join("\n", runs.Select(run => run.ToString()));

        sealed class Run
        {
            readonly float spacing;

            /// <summary>Position at which the fluid ends in x after each step, m.</summary>
            public readonly List<float> Fronts = new List<float>();

            /// <summary>Times at which the mean velocity along x changes its sign, s.</summary>
            public readonly List<float> Turns = new List<float>();

            /// <summary>Mean of the last second.</summary>
            public readonly float VolumeRatio;

            /// <summary>
            /// From when on the center of mass stays within 10 % of its settled height, s: the settling time of any
            /// oscillation. Height is potential energy, and a dam half as long as the box falls by its settled height: so
            /// no wave lifts a tenth of what the fall released again. Here the wave thrown back by the far wall decides
            /// (18 to 25 %; the next lifts 7 %). How long the water sways within the tenth depends on the spacing.
            /// </summary>
            public readonly float SettlingTime;

            public Run(float spacing)
            {
                this.spacing = spacing;
                SolverSettings settings = SolverSettings.Default;
                settings.substeps = 2;
                settings.iterations = 12;
                settings.deepWater = DeepWater.Off;     // it would be on at the last spacing alone: 12 layers
                var heights = new List<float>();
                var volumeRatios = new List<float>();
                using (var fluid = new TestFluid(Box, spacing, 2000, settings).AddBlock(0f, Dam))
                {
                    float last = 0f;
                    for (int step = 0; step <= Seconds * 60; step++)
                    {
                        FluidStatistics statistics = fluid.Measure();
                        float velocity = statistics.momentum.x / (statistics.particles * 1000f * spacing * spacing * spacing);
                        // A particle is half a spacing long on either side.
                        Fronts.Add(statistics.furthest.x + 0.5f * spacing);
                        if (last * velocity < 0f)
                            Turns.Add((step - velocity / (velocity - last)) / 60f);
                        heights.Add(statistics.centerOfMass.y);
                        volumeRatios.Add(statistics.volumeRatio);
                        last = velocity;
                        fluid.Step();
                    }
                }
                VolumeRatio = OfLastSecond(volumeRatios);
                SettlingTime = Settling(heights, OfLastSecond(heights));
            }

            static float OfLastSecond(List<float> values) => values.Skip((Seconds - 1) * 60).Average();

            static float Settling(List<float> heights, float settled)
            {
                float tolerance = 0.1f * settled;
                int last = heights.FindLastIndex(height => math.abs(height - settled) > tolerance);
                Assert.That(last, Is.LessThan(heights.Count - 1), $"The water did not settle within {Seconds} s.");
                float outside = math.abs(heights[last] - settled), inside = math.abs(heights[last + 1] - settled);
                return (last + (outside - tolerance) / (outside - inside)) / 60f;
            }

            public override string ToString()
            {
                string fronts = string.Join(", ", new[] { 6, 9, 12, 15 }.Select(step => $"{Fronts[step]:0.000}"));
                string turns = string.Join(", ", Turns.Take(4).Select(time => $"{time:0.00}"));
                return $"spacing {spacing:0.000} m: volume ratio {VolumeRatio:0.000}, front {fronts} m, turns at {turns} s, settled at " +
                    $"{SettlingTime:0.00} s";
            }
        }
    }
}
