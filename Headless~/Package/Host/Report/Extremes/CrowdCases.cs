using System.Collections.Generic;
using System.Linq;
using Host.Experiments;
using Rill;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Host.Report.Extremes
{
    /// <summary>Particles nearer to each other than a fluid can be.</summary>
    static class CrowdCases
    {
        const string Subject = "Crowding";
        const float Spacing = 0.05f;

        public static IEnumerable<ExtremeCase> All(bool quick)
        {
            yield return Point();
            yield return PairsInTheAir();
            yield return PairsInWater();
            yield return Dense(quick ? 10 : 24);
            yield return OneCell(quick ? 2_000 : 10_000);
            foreach (int layers in new[] { 51, 60 })
                yield return Overfilled(layers, quick ? 6 : 24, quick ? 2 : 6);
            if (!quick)
                yield return AfterAnImpact();
        }

        /// <summary>
        /// Speed at which two steps can throw particles apart, m/s: a pass moves it half a spacing at most, the grid's density
        /// correction two spacings. Nothing but two steps being enough to end the crowding holds it at that.
        /// </summary>
        static double SpeedLimit(ExtremeFluid fluid)
        {
            SolverSettings settings = fluid.Input.settings;
            double spacings = 0.5 * settings.iterations + (settings.deepWater == DeepWater.Off ? 0 : 2);
            return 2 * spacings * fluid.Spacing * settings.substeps / fluid.Input.timeStep;
        }

        static ExtremeCase Point() => new(Subject, "1000 particles at one point; no gravity; 2 s", (setting, check) =>
        {
            using var fluid = new ExtremeFluid(40f, Spacing, 1000, setting.Solver).Add(Enumerable.Repeat(new float3(20f), 1000));
            fluid.Input.gravity = 0f;
            fluid.Step(120, 5);
            check.AtMost("speed", fluid.Counts.SpeedMax, SpeedLimit(fluid), "m/s");
            check.AtMost("p99.9 of C+ at the end", fluid.Last.densityError999, 0.1);
            check.Exactly("closer than 0.05 d", fluid.Last.coincident, 0);
            return fluid.Counts;
        });

        static ExtremeCase PairsInTheAir() => new(Subject, "200 pairs at distance 0 far from all others; no gravity; 1 s", (setting, check) =>
        {
            IEnumerable<float3> positions = Enumerable.Range(0, 200).Select(i => 3f + 3f * new float3(i % 6, i / 6 % 6, i / 36));
            using var fluid = new ExtremeFluid(24f, Spacing, 400, setting.Solver).Add(positions.Concat(positions));
            fluid.Input.gravity = 0f;
            fluid.Step(60, 5);
            check.Exactly("closer than 0.05 d", fluid.Last.coincident, 0);
            check.AtMost("speed", fluid.Counts.SpeedMax, SpeedLimit(fluid), "m/s");
            return fluid.Counts;
        });

        static ExtremeCase PairsInWater() => new(Subject, "every eighth particle of still water doubled; 3 s", (setting, check) =>
        {
            float3[] water = ExtremeFluid.Lattice(0f, new int3(12, 8, 12)).ToArray();
            using var fluid = new ExtremeFluid(new float3(12f, 24f, 12f), Spacing, water.Length * 2, setting.Solver)
                .Add(water.Concat(water.Where((_, i) => i % 8 == 0)));
            fluid.Step(180, 10);
            check.Exactly("closer than 0.05 d", fluid.Last.coincident, 0);
            check.Note("pairs nearer than 0.25 d", ClosePairs.Count(fluid.Read(), 0.25f));
            check.AtMost("speed", fluid.Counts.SpeedMax, SpeedLimit(fluid), "m/s");
            check.Note("volume", fluid.Settled(s => s.volumeRatio, 1));
            return fluid.Counts;
        });

        static ExtremeCase Dense(int side) => new(Subject, $"block of {side} x {side} x {side} at eight times the density; no gravity; 2 s",
            (setting, check) =>
        {
            using var fluid = new ExtremeFluid(1.6f * side + 8f, Spacing, side * side * side, setting.Solver);
            fluid.AddLattice((fluid.Solver.Layout.DomainSize - 0.5f * side) * 0.5f, side, pitch: 0.5f);
            fluid.Input.gravity = 0f;
            fluid.Step(120, 5);
            check.AtMost("speed", fluid.Counts.SpeedMax, SpeedLimit(fluid), "m/s");
            check.AtMost("p99.9 of C+ at the end", fluid.Last.densityError999, 0.1);
            check.Exactly("closer than 0.05 d", fluid.Last.coincident, 0);
            return fluid.Counts;
        });

        static ExtremeCase OneCell(int particles) => new(Subject, $"{particles} particles in one grid cell (a cube of 1 d); 3 s", (setting, check) =>
        {
            var random = new Random(3);
            float side = math.ceil(math.pow(particles, 1f / 3f));
            float3 corner = math.floor(side);
            using var fluid = new ExtremeFluid(2f * side, Spacing, particles, setting.Solver)
                .Add(Enumerable.Range(0, particles).Select(_ => corner + random.NextFloat3()));
            fluid.Step(10, 1).Step(170, 10);
            check.AtLeast("particles reported with full lists", fluid.Counts.Overflow, 1);
            check.Exactly("of those at the end", fluid.Last.neighborOverflow, 0);
            check.AtMost("p99.9 of C+ at the end", fluid.Last.densityError999, 0.2);
            check.AtMost("speed", fluid.Counts.SpeedMax, SpeedLimit(fluid) + 9.81 * 3, "m/s");
            check.Exactly("closer than 0.05 d", fluid.Last.coincident, 0);
            return fluid.Counts;
        });

        // 50 layers, so that one more is 2 %.
        static ExtremeCase Overfilled(int layers, int side, double seconds)
            => new(Subject, $"closed box of {side} x 50 x {side} d filled with {layers} layers; {seconds:0} s", (setting, check) =>
        {
            double excess = layers / 50.0 - 1;
            IEnumerable<float3> positions = ExtremeFluid.Lattice(0f, new int3(side, layers, side)).Select(p => p * new float3(1f, 50f / layers, 1f));
            using var fluid = new ExtremeFluid(new float3(side, 50f, side), Spacing, side * layers * side, setting.Solver).Add(positions);
            fluid.Seconds(seconds);
            check.Between("C+ settled", fluid.Settled(s => s.densityError, 1), 0.5 * excess, 1.3 * excess, "%");
            check.AtMost("p99.9 of C+ over its mean", fluid.Settled(s => s.densityError999, 1) / fluid.Settled(s => s.densityError, 1), 3);
            check.AtMost("jitter", fluid.Settled(s => s.jitter, 1), 0.05, "m/s");
            check.Exactly("closer than 0.05 d", fluid.Last.coincident, 0);
            return fluid.Counts;
        });

        static ExtremeCase AfterAnImpact() => new(Subject, "drop at 25 m/s on a pool of 4 layers (540672 particles); 6 s", (setting, check) =>
        {
            using var fluid = new ExtremeFluid(ExperimentScene.Drop(4), setting.Solver);
            fluid.Seconds(6);
            check.AtMost("C+ from 0.2 to 6 s", fluid.Settled(s => s.densityError, 5.8), 0.01, "%");
            check.Between("volume settled", fluid.Settled(s => s.volumeRatio), 0.95, 1.05);
            check.AtMost("highest energy over the start's", fluid.MaxEnergy, 1.005);
            check.Exactly("closer than 0.05 d", fluid.Last.coincident, 0);
            check.Note("pairs nearer than 0.25 d", ClosePairs.Count(fluid.Read(), 0.25f));
            return fluid.Counts;
        });
    }
}
