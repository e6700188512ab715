using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Host.Report.Extremes
{
    /// <summary>Drift over many steps.</summary>
    static class LongCases
    {
        const string Subject = "Long runs";
        const float Spacing = 0.05f;

        public static IEnumerable<ExtremeCase> All(bool quick)
        {
            int steps = quick ? 300 : 100_000;
            yield return Still(steps);
            yield return Floating(quick ? 100 : 6_000);
        }

        static ExtremeCase Still(int steps) => new(Subject, $"still water of 8 x 6 x 8; {steps} steps", (setting, check) =>
        {
            using var fluid = new ExtremeFluid(new float3(8f, 16f, 8f), Spacing, 384, setting.Solver).AddLattice(0f, new int3(8, 6, 8));
            // Settles first: what comes after is drift.
            int settling = Math.Min(1_000, steps);
            fluid.Step(settling, settling).Step(steps, steps / 100);
            int first = fluid.Samples.FindIndex(s => s.step >= settling);
            var (early, late) = (fluid.Samples[first], fluid.Last);
            check.AtMost("drift of the energy", Math.Abs(late.Energy / (double)early.Energy - 1), 0.02, "%");
            check.AtMost("drift of the volume", Math.Abs(late.volumeRatio / (double)early.volumeRatio - 1), 0.02, "%");
            check.AtMost("speed of the center of mass", math.length(late.momentum) / (1000.0 * 384 * Math.Pow(Spacing, 3)), 0.02, "m/s");
            check.AtMost("rms speed at the end", late.speed, 0.1, "m/s");
            return fluid.Counts;
        });

        static ExtremeCase Floating(int steps) => new(Subject, $"block of 8 x 8 x 8 afloat without gravity; {steps} steps", (setting, check) =>
        {
            // Particles that are pressed out of the block fly off for good, at up to 0.5 d/s: no wall may be within reach, since it would push.
            using var fluid = new ExtremeFluid(128f, Spacing, 512, setting.Solver).AddLattice(60f, 8);
            fluid.Input.gravity = 0f;
            fluid.Step(steps, steps / 100);
            double mass = 1000.0 * 512 * Math.Pow(Spacing, 3);
            check.AtMost("displacement of the center of mass in d",
                math.distance(fluid.Last.centerOfMass, fluid.Samples[0].centerOfMass) / Spacing, 0.1);
            check.AtMost("speed of the center of mass", math.length(fluid.Last.momentum) / mass, 1e-3, "m/s");
            check.AtMost("rms speed at the end", fluid.Last.speed, 0.02, "m/s");
            return fluid.Counts;
        });
    }
}
