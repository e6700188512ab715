using System;
using System.Collections.Generic;
using System.Linq;
using Rill;
using Unity.Mathematics;

namespace Host.Report.Extremes
{
    /// <summary>Speeds, forces and steps beyond what water meets.</summary>
    static class ForceCases
    {
        const string Impacts = "Impacts", Forces = "Forces and steps";
        const float Spacing = 0.05f;

        public static IEnumerable<ExtremeCase> All(bool quick)
        {
            int size = quick ? 8 : 24;
            yield return OnThinLayer(size);
            yield return OnWall(size);
            yield return Gravity(size, 981f, "100 g", 3);
            yield return Weightless(size);
            yield return Flips(size);
            yield return LongSteps(size);
        }

        // 2 layers at rest, a block above that comes down.
        static ExtremeCase OnThinLayer(int size)
            => new(Impacts, $"block of {size} x {size} x {size} at 100 m/s onto a layer 2 d thick; 2 s", (setting, check) =>
        {
            using var fluid = new ExtremeFluid(new float3(3f, 4f, 3f) * size, Spacing, 3 * size * 3 * size * 2 + size * size * size, setting.Solver)
                .AddLattice(0f, new int3(3 * size, 2, 3 * size))
                .AddLattice(new float3(1f, 2f, 1f) * size, size, new float3(0f, -100f, 0f));
            fluid.Step(120, 2);
            check.AtMost("highest energy over the start's", fluid.MaxEnergy, 1.001);
            check.AtMost("speed", fluid.Counts.SpeedMax, 101, "m/s");
            check.AtMost("C+ at the end", fluid.Settled(s => s.densityError, 0.5), 0.05, "%");
            return fluid.Counts;
        });

        static ExtremeCase OnWall(int size) => new(Impacts, $"block of {size} x {size} x {size} at 100 m/s against a wall; 2 s", (setting, check) =>
        {
            using var fluid = new ExtremeFluid(new float3(4f, 3f, 3f) * size, Spacing, size * size * size, setting.Solver)
                .AddLattice(new float3(2f, 1f, 1f) * size, size, new float3(100f, 0f, 0f));
            fluid.Step(120, 2);
            check.AtMost("highest energy over the start's", fluid.MaxEnergy, 1.001);
            check.AtMost("speed", fluid.Counts.SpeedMax, 101, "m/s");
            check.AtMost("C+ at the end", fluid.Settled(s => s.densityError, 0.5), 0.05, "%");
            return fluid.Counts;
        });

        static ExtremeFluid Dam(int size, SolverSettings settings)
            => new ExtremeFluid(new float3(2f, 2f, 1f) * size, Spacing, size * size * size, settings).AddLattice(0f, size);

        static ExtremeCase Gravity(int size, float strength, string name, double seconds)
            => new(Forces, $"dam of {size} layers under {name}; {seconds:0} s", (setting, check) =>
        {
            using ExtremeFluid fluid = Dam(size, setting.Solver);
            fluid.Input.gravity = new float3(0f, -strength, 0f);
            fluid.Seconds(seconds, 5);
            check.AtMost("highest energy over the start's", fluid.MaxEnergy, 1.005);
            check.Note("gravity's displacement in a step in d", strength * Math.Pow(fluid.Input.timeStep, 2) / Spacing);
            check.Note("substeps", setting.Solver.StableSubsteps(strength / 3600 / Spacing));
            check.Between("volume settled", fluid.Settled(s => s.volumeRatio, 1), 0.9, 1.1);
            check.AtMost("C+ settled", fluid.Settled(s => s.densityError, 1), 0.05, "%");
            return fluid.Counts;
        });

        static ExtremeCase Weightless(int size) => new(Forces, $"block of {size} x {size} x {size} at rest without gravity; 2 s", (setting, check) =>
        {
            using var fluid = new ExtremeFluid(3f * size, Spacing, size * size * size, setting.Solver).AddLattice(size, size);
            fluid.Input.gravity = 0f;
            fluid.Step(120, 10);
            check.AtMost("displacement of the center of mass in d",
                math.distance(fluid.Last.centerOfMass, fluid.Samples[0].centerOfMass) / Spacing, 0.05);
            check.AtMost("speed at the end", fluid.Last.speed, 0.05, "m/s");
            return fluid.Counts;
        });

        static ExtremeCase Flips(int size) => new(Forces, $"half-full box of {size} d whose gravity flips each second; 8 s", (setting, check) =>
        {
            using var fluid = new ExtremeFluid(size, Spacing, size * size * size / 2, setting.Solver).AddLattice(0f, new int3(size, size / 2, size));
            for (int second = 0; second < 8; second++)
            {
                fluid.Step(60, 10);
                fluid.Input.gravity = -fluid.Input.gravity;
            }
            // Particles that fall through the whole box cannot be faster; waves that are thrown together gain a little.
            check.AtMost("speed", fluid.Counts.SpeedMax, 1.5 * Math.Sqrt(2 * 9.81 * size * Spacing) + 1, "m/s");
            check.AtMost("C+ over the last 2 s", fluid.Settled(s => s.densityError), 0.02, "%");
            return fluid.Counts;
        });

        static ExtremeCase LongSteps(int size) => new(Forces, $"dam of {size} layers in steps of 1/15 s; 8 s", (setting, check) =>
        {
            using ExtremeFluid fluid = Dam(size, setting.Solver);
            fluid.Input.timeStep = 1f / 15f;
            fluid.Seconds(8, 5);
            check.AtMost("highest energy over the start's", fluid.MaxEnergy, 1.005);
            check.Between("volume settled", fluid.Settled(s => s.volumeRatio), 0.9, 1.1);
            check.AtMost("C+ settled", fluid.Settled(s => s.densityError), 0.05, "%");
            check.Note("substeps", setting.Solver.StableSubsteps(9.81f / 225 / Spacing));
            check.Note("gravity's displacement in a step in d", 9.81 * Math.Pow(fluid.Input.timeStep, 2) / Spacing);
            return fluid.Counts;
        });
    }
}
