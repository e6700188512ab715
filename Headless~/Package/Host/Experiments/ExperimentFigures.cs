using System.Linq;
using Rill;
using Unity.Mathematics;

namespace Host.Experiments
{
    /// <summary>Figures of a run with one setting: the common columns of the report's sweeps. Measures as in Documentation~/solver.md.</summary>
    static class ExperimentFigures
    {
        public static readonly string[] Columns =
        {
            "scene", "particles", "layers", "spacing_m", "seconds", "deep", "substeps", "iterations", "relaxation",
            "error_moving", "error_settled", "error_999", "error_max", "noise", "jitter", "volume", "volume_lowest", "energy",
            "coincident", "escaped", "non_finite", "overflow", "ms_initial", "ms_moving", "ms_settled", "bytes",
        };

        /// <summary>m/s².</summary>
        public const float Gravity = 9.81f;

        /// <summary>A step of 1/60 s of water under gravity.</summary>
        public static StepInput Input(in SolverSettings settings) => Input(settings, FluidMaterial.Water);

        /// <summary>Returns the input for another material.</summary>
        public static StepInput Input(in SolverSettings settings, in FluidMaterial material) =>
            new StepInput { timeStep = 1f / 60f, gravity = new float3(0f, -Gravity, 0f), settings = settings, material = material };

        /// <summary>One for each column. Energy is the highest over that of the start; coincident the most in the last 2 s; bytes are a
        /// particle's.</summary>
        public static object[] Of(Experiment run)
        {
            SolverSettings settings = run.Input.settings;
            return new object[]
            {
                run.Scene.Name, run.Scene.Particles, run.Scene.Layers, run.Scene.Spacing, run.End,
                    settings.deepWater.ToString().ToLowerInvariant(), settings.substeps, settings.iterations, settings.relaxation,
                run.Moving(s => s.densityError), run.Settled(s => s.densityError), run.Settled(s => s.densityError999),
                    run.Samples.Max(s => s.densityErrorMax),
                run.Settled(s => s.speed), run.Settled(s => s.jitter), run.Settled(s => s.volumeRatio), run.Samples.Min(s => s.volumeRatio),
                    run.Samples.Max(s => s.Energy) / run.Samples[0].Energy,
                run.SettledSamples.Max(s => s.coincident), run.Samples.Max(s => s.escaped), run.Samples.Max(s => s.nonFinite),
                    run.Samples.Max(s => s.neighborOverflow),
                run.Milliseconds("initial"), run.Milliseconds("moving"), run.Milliseconds("settled"), run.Bytes / (double)run.Scene.Particles,
            };
        }
    }
}
