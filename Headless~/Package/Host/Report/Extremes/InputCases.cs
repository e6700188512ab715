using System;
using System.Collections.Generic;
using System.Linq;
using Rill;
using Unity.Mathematics;
using UnityEngine;

namespace Host.Report.Extremes
{
    /// <summary>Input that a user may give the component.</summary>
    static class InputCases
    {
        const string Input = "Input", Sizes = "Counts and scales", Time = "Forces and steps";
        const float Spacing = 0.05f;
        const int Dam = 480;        // particles of the dam: 10 x 8 x 6

        public static IEnumerable<ExtremeCase> All()
        {
            yield return Hitch();
            yield return BadParticles();
            yield return LostTransform();
            yield return Setting("relaxation 0", s => { s.relaxation = 0f; return s; }, null);
            yield return Setting("relaxation 2", s => { s.relaxation = 2f; return s; }, null);
            yield return Setting("relaxation 5", s => { s.relaxation = 5f; return s; }, "relaxation 5 is outside 0 to 2");
            yield return Setting("relaxation NaN", s => { s.relaxation = float.NaN; return s; }, "relaxation NaN is outside 0 to 2");
            yield return Setting("0 iterations", s => { s.iterations = 0; return s; }, "iterations 0 is outside 1 to 50");
            yield return Setting("50 iterations", s => { s.iterations = 50; return s; }, null);
            yield return Setting("softness (epsilon) 0", s => { s.softness = 0f; return s; }, "softness 0 is outside");
            foreach (int added in new[] { 0, 1, Dam, Dam + 1 })
                yield return Count(added);
            yield return Scale(1e-4f);
            yield return Scale(10f);
            yield return FarAway();
        }

        static Vector3 Box(float spacing) => new Vector3(20f, 16f, 6f) * spacing;
        static Vector3 Water(float spacing) => new Vector3(10f, 8f, 6f) * spacing;

        static ExtremeComponent Tank(float spacing = Spacing, Action<FluidSimulation> setUp = null)
            => new(Box(spacing), spacing, Dam, Water(spacing), setUp);

        static ExtremeCase Case(string subject, string name, Func<ExtremeCheck, ExtremeCounts> run)
            => new(subject, name, (_, check) => run(check)) { OfComponent = true };

        static ExtremeCase Hitch() => Case(Time, "frame of 1 s in a dam break; then 2 s", check =>
        {
            using ExtremeComponent fluid = Tank(), even = Tank();
            fluid.Frames(20).Measure();
            fluid.Fluid.Advance(1f);
            check.Exactly("steps taken in it", fluid.Fluid.StepCount - 20, 4);
            fluid.Frames(120).Measure();
            fluid.Fluid.TryGetStatistics(out FluidStatistics statistics);
            check.Between("time reported as dropped", statistics.droppedTime, 1 - 5 / 60.0, 1 - 3 / 60.0, "s");
            even.Frames(144).Measure();
            double apart = fluid.Read().Zip(even.Read(), (a, b) => (double)math.distance(a, b)).Max();
            check.Exactly("largest distance from a run of as many steps without it in d", apart, 0);
            return fluid.Counts(Dam);
        });

        static ExtremeCase BadParticles() => Case(Input, "4 particles with NaN or infinity for position or velocity among others; 1 s", check =>
        {
            using var fluid = new ExtremeComponent(Box(Spacing), Spacing, Dam + 4, Water(Spacing));
            foreach (float bad in new[] { float.NaN, float.PositiveInfinity })
            {
                fluid.Add(new float3(0f, bad, 0f), 0f);
                fluid.Add(0f, new float3(0f, 0f, bad));
            }
            fluid.Frames(60).Measure();
            check.Exactly("culled and counted", fluid.Samples[^1].nonFinite, 4);
            return fluid.Counts(Dam + 4);
        });

        static ExtremeCase LostTransform() => Case(Input, "transform that is not finite for 1 s; then finite again", check =>
        {
            var parent = new GameObject("Stretched");
            using ExtremeComponent fluid = Tank(setUp: f =>
            {
                f.transform.SetParent(parent.transform, false);
                f.transform.localPosition = new Vector3(2f, 0f, 0f);
            });
            fluid.Frames(10);
            parent.transform.localScale = Vector3.one * 3e38f;
            fluid.Frames(60).Measure();
            check.That("is logged by the object's name", fluid.Said("'Tank': its transform is not finite"),
                string.Join(" ", fluid.Messages).Replace(',', ';'));
            check.Exactly("messages", fluid.Messages.Count, 1);
            check.Exactly("steps taken", fluid.Fluid.StepCount, 70);
            parent.transform.localScale = Vector3.one;
            fluid.Frames(60).Measure();
            check.AtMost("speed", fluid.Counts(Dam).SpeedMax, 10, "m/s");
            UnityEngine.Object.DestroyImmediate(parent);
            return fluid.Counts(Dam);
        });

        // Any setting has to leave the water whole and inside, if not at its volume.
        static ExtremeCase Setting(string name, Func<SolverSettings, SolverSettings> change, string message)
            => Case(Input, $"{name}; dam break of 2 s", check =>
        {
            using ExtremeComponent fluid = Tank(setUp: f => f.Settings = change(f.Settings));
            if (message != null)
                check.That("says what it used instead", fluid.Said(message), "no message");
            else
                check.Exactly("messages", fluid.Messages.Count, 0);
            fluid.Frames(1).Measure();
            for (int part = 0; part < 6; part++)
                fluid.Frames(20).Measure();
            ExtremeCounts counts = fluid.Counts(Dam);
            check.AtMost("highest energy over the start's", fluid.Samples.Max(s => s.Energy) / fluid.Samples[0].Energy, 1.005);
            check.Note("relaxation used", fluid.Fluid.Input.settings.relaxation);
            check.Note("iterations used", fluid.Fluid.Settings.iterations);
            check.Note("volume", fluid.Samples[^1].volumeRatio);
            return counts;
        });

        static ExtremeCase Count(int added) => Case(Sizes, $"{added} particles where {Dam} fit; 1 s", check =>
        {
            using var fluid = new ExtremeComponent(Box(Spacing), Spacing, Dam, Vector3.zero);
            float3[] positions = ExtremeFluid.Lattice(-0.5f * (float3)(Box(1f)), new int3(10, 8, 7)).Take(added).ToArray();
            foreach (float3 position in positions)
                fluid.Add(position * Spacing, 0f);
            fluid.Frames(60).Measure();
            check.Exactly("alive", fluid.Samples[^1].particles, math.min(added, Dam));
            check.Exactly("refused and counted", fluid.Samples[^1].refused, math.max(added - Dam, 0));
            return fluid.Counts(added);
        });

        // Gravity for the spacing, so that a step means the same: then the fluid has to do the same.
        static ExtremeCase Scale(float spacing)
            => Case(Sizes, string.Create(System.Globalization.CultureInfo.InvariantCulture,
            $"spacing {spacing} m with gravity in proportion; dam break of 2 s"), check =>
        {
            using ExtremeComponent fluid = Tank(spacing, f => f.Gravity = Vector3.down * (9.81f * spacing / Spacing)), usual = Tank();
            FluidStatistics scaled = fluid.Frames(120).Measure(), at = usual.Frames(120).Measure();
            check.AtMost("volume's difference from spacing 0.05 m", math.abs(scaled.volumeRatio - at.volumeRatio), 0.02);
            check.AtMost("C+ difference", math.abs(scaled.densityError - at.densityError), 0.005, "%");
            return fluid.Counts(Dam);
        });

        static ExtremeCase FarAway() => Case(Sizes, "domain 10 km from the origin; dam break of 2 s", check =>
        {
            using ExtremeComponent far = Tank(setUp: f => f.transform.position = new Vector3(10_000f, 10_000f, -10_000f)), near = Tank();
            FluidStatistics there = far.Frames(120).Measure(), here = near.Frames(120).Measure();
            check.Exactly("messages", far.Messages.Count, 0);
            check.AtMost("volume's difference from the origin", math.abs(there.volumeRatio - here.volumeRatio), 0.02);
            check.AtMost("C+ difference", math.abs(there.densityError - here.densityError), 0.005, "%");
            return far.Counts(Dam);
        });
    }
}
