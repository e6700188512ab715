using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>One dam break at three resolutions: every setting is meant to mean the same at any spacing.</summary>
    public class ScaleTests
    {
        // 0.5 m long, 0.5 m high and 0.2 m wide in a box 1 m long: 10, 15 and 20 layers.
        static readonly float[] Spacings = { 0.05f, 1f / 30f, 0.025f };
        static readonly float3 Box = new float3(1f, 1f, 0.2f), Dam = new float3(0.5f, 0.5f, 0.2f);
        const int Seconds = 5;

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

            /// <summary>Where the fluid ends in x after each step, m.</summary>
            public readonly List<float> Fronts = new List<float>();

            /// <summary>Times at which the mean velocity along x changes its sign, s.</summary>
            public readonly List<float> Turns = new List<float>();

            /// <summary>Mean of the last second.</summary>
            public readonly float VolumeRatio;

            /// <summary>Last time at which the water as a whole was faster than 0.1 m/s, s.</summary>
            public readonly float SwayedUntil;

            public Run(float spacing)
            {
                this.spacing = spacing;
                SolverSettings settings = SolverSettings.Default;
                settings.substeps = 4;
                var volumeRatios = new List<float>();
                using (var fluid = new TestFluid(Box, spacing, 4000, settings).AddBlock(0f, Dam))
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
                        if (math.abs(velocity) > 0.1f)
                            SwayedUntil = step / 60f;
                        if (step > (Seconds - 1) * 60)
                            volumeRatios.Add(statistics.volumeRatio);
                        last = velocity;
                        fluid.Step();
                    }
                }
                VolumeRatio = volumeRatios.Average();
            }

            public override string ToString()
            {
                string fronts = string.Join(", ", new[] { 6, 9, 12, 15 }.Select(step => $"{Fronts[step]:0.000}"));
                string turns = string.Join(", ", Turns.Take(4).Select(time => $"{time:0.00}"));
                return $"spacing {spacing:0.000} m: volume ratio {VolumeRatio:0.000}, front {fronts} m, turns at {turns} s, sways until {SwayedUntil:0.00} s";
            }
        }
    }
}
