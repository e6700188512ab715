using System;
using System.Linq;
using Host.Experiments;
using Rill;

namespace Host.Studies.Methods
{
    /// <summary>One method in one scene: its figures, and whether it stood.</summary>
    sealed class MethodRun
    {
        /// <summary>A closed scene whose energy rose by more than this fraction has diverged.</summary>
        const double MaxRise = 0.05;

        /// <summary>A run is broken off where it is lost beyond doubt: the energy, or the volume, that shows it.</summary>
        const double LostEnergy = 1.2, LostVolume = 0.75;

        /// <summary>Water at less than this fraction of its volume is collapsed; still water at more than that has boiled.</summary>
        const double MinVolume = 0.9, MaxVolume = 1.1;

        const int SampleEvery = 10;

        public static readonly string[] Columns =
        {
            "study", "series", "scene", "particles", "value", "label", "two_level", "substeps", "iterations", "relaxation", "passes",
            "error_moving", "error_settled", "interior", "volume", "volume_lowest", "speed", "jitter", "energy", "ms_moving", "ms_settled",
                "seconds", "state",
        };

        readonly MethodStudy study;
        readonly MethodVariant variant;
        readonly MethodScene scene;
        readonly Experiment run;

        MethodRun(MethodStudy study, MethodVariant variant, MethodScene scene, Experiment run)
        {
            this.study = study;
            this.variant = variant;
            this.scene = scene;
            this.run = run;
        }

        public static MethodRun Of(MethodStudy study, MethodVariant variant, MethodScene scene)
        {
            StepInput input = variant.Input();
            using var solver = new PackageSolver(new StudySolver(scene.Scene.LayoutFor(input.settings), variant.Method(), variant.Coarse), input);
            return new MethodRun(study, variant, scene, Experiment.Run(solver, scene.Scene, input, scene.Seconds, SampleEvery, IsLost));
        }

        public string State => StateOf(MaxEnergy, run.Samples.Min(s => s.volumeRatio), run.Settled(s => s.volumeRatio),
            run.Samples[^1].nonFinite, scene.IsStill);

        public static string StateOf(double energy, double minVolume, double settledVolume, int nonFinite, bool isStill) =>
            nonFinite > 0 || !(energy <= 1 + MaxRise) ? "diverged"
            : !(minVolume >= MinVolume) ? "collapsed"
            : isStill && !(settledVolume <= MaxVolume) ? "boiled"
            : "stands";

        // Over its start; not a number if it ever was none, which Max would pass over.
        double MaxEnergy => run.Samples.Aggregate(0.0, (highest, s) => double.IsNaN(s.Energy) ? double.NaN : Math.Max(highest, s.Energy))
            / run.Samples[0].Energy;

        public object[] Row => new object[]
        {
            study.Name, variant.Series.Replace(",", ""), scene.Name, scene.Scene.Particles, variant.Value, variant.Label ?? "",
                variant.TwoLevel ? 1 : 0, variant.Substeps, variant.Iterations, variant.Relaxation, variant.Passes,
            run.Moving(s => s.densityError), run.Settled(s => s.densityError), run.Settled(s => s.interiorError),
                run.Settled(s => s.volumeRatio), run.Samples.Min(s => s.volumeRatio),
            run.Settled(s => s.speed), run.Settled(s => s.jitter), MaxEnergy,
            run.Milliseconds("moving"), run.Milliseconds("settled"), run.End, State,
        };

        static bool IsLost(Experiment run)
        {
            FluidStatistics last = run.Samples[^1];
            return last.nonFinite > 0 || !(last.Energy <= LostEnergy * run.Samples[0].Energy) || !(last.volumeRatio >= LostVolume);
        }
    }
}
