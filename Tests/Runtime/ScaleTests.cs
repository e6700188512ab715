using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>One scene at three resolutions: every setting is meant to mean the same at any spacing.</summary>
    public class ScaleTests
    {
        static readonly float[] Spacings = { 0.05f, 1f / 30f, 0.025f };

        // A dam of 0.5 x 0.5 x 0.2 m in a box 1 m long: 10, 15 and 20 layers.
        const int Seconds = 5;

        [Test]
        public void A_dam_break_is_the_same_at_three_spacings()
        {
            Run[] runs = Spacings.Select(Play).ToArray();
            foreach (Run run in runs)
                TestContext.Out.WriteLine(run);

            foreach (Run run in runs)
                Assert.That(run.VolumeRatio, Is.EqualTo(runs[0].VolumeRatio).Within(5).Percent, $"volume ratio\n{string.Join("\n", runs.Select(r => r.ToString()))}");
            for (int i = 0; i < Run.FrontTimes.Length; i++)
                foreach (Run run in runs)
                    Assert.That(run.Fronts[i], Is.EqualTo(runs[0].Fronts[i]).Within(5).Percent, $"front at {Run.FrontTimes[i]} s\n{string.Join("\n", runs.Select(r => r.ToString()))}");
            foreach (Run run in runs)
                Assert.That(run.SettlingTime, Is.EqualTo(runs[0].SettlingTime).Within(5).Percent, $"settling time\n{string.Join("\n", runs.Select(r => r.ToString()))}");
        }

        static Run Play(float spacing)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.substeps = 4;
            using (var fluid = new TestFluid(new float3(1f, 1f, 0.2f), spacing, 20000, settings).AddBlock(0f, new float3(0.5f, 0.5f, 0.2f)))
            {
                var run = new Run { Spacing = spacing };
                float start = fluid.Measure().potentialEnergy;
                for (int step = 1; step <= Seconds * 60; step++)
                {
                    fluid.Step();
                    if (step % 3 != 0)
                        continue;
                    FluidStatistics statistics = fluid.Measure();
                    int front = Array.FindIndex(Run.FrontTimes, time => Math.Abs(time * 60f - step) < 0.5f);
                    if (front >= 0)
                        run.Fronts[front] = statistics.furthest.x;
                    if (statistics.kineticEnergy > 0.01f * start)
                        run.SettlingTime = step / 60f;
                    if (step > (Seconds - 1) * 60)
                        run.volumeRatios.Add(statistics.volumeRatio);
                }
                return run;
            }
        }

        sealed class Run
        {
            public static readonly float[] FrontTimes = { 0.1f, 0.15f, 0.2f, 0.25f };

            public float Spacing;
            public readonly float[] Fronts = new float[FrontTimes.Length];

            /// <summary>Last time at which a hundredth of the energy at the start was in motion, s.</summary>
            public float SettlingTime;

            public readonly List<float> volumeRatios = new List<float>();

            /// <summary>Mean of the last second.</summary>
            public float VolumeRatio => volumeRatios.Average();

            public override string ToString()
            {
                return $"spacing {Spacing:0.000} m: volume ratio {VolumeRatio:0.000}, front {string.Join(", ", Fronts.Select(x => $"{x:0.000}"))} m, settled after {SettlingTime:0.00} s";
            }
        }
    }
}
