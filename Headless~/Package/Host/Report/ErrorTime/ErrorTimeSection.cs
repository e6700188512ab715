using System.Collections.Generic;
using System.Linq;
using Host.Experiments;
using Host.Manual;

namespace Host.Report.ErrorTime
{
    /// <summary>Error against GPU time: method, iterations, relaxation and substeps over fixed scenes, with the front of what is worth its
    /// time.</summary>
    sealed class ErrorTimeSection : ReportSection
    {
        public const string Sweep = "error-time";
        const string Front = "front";
        const int SampleEvery = 10;

        readonly IReadOnlyList<ErrorTimePlan> full, quick;

        public ErrorTimeSection() : this(ErrorTimePlan.Full, ErrorTimePlan.Quick) { }

        public ErrorTimeSection(IReadOnlyList<ErrorTimePlan> full, IReadOnlyList<ErrorTimePlan> quick)
        {
            this.full = full;
            this.quick = quick;
        }

        public override string Name => "error-time";
        public override string Title => "Error against GPU time";

        public override void Measure(ReportRun run)
        {
            var sweep = new ReportTable(ExperimentFigures.Columns);
            foreach (ErrorTimePlan plan in run.Quick ? quick : full)
                foreach (SweepSetting setting in plan.Settings)
                {
                    Experiment experiment = Experiment.Run(plan.Scene, ExperimentFigures.Input(setting.Settings), plan.Seconds, SampleEvery);
                    sweep.Add(ExperimentFigures.Of(experiment));
                    run.Log($"{plan.Scene.Name} {plan.Scene.Particles}, {setting}");
                }
            run.Save(Sweep, sweep, $"steps of 1/60 s, smoothing {Rill.FluidMaterial.Water.velocitySmoothing}, " +
                $"{Rill.SolverSettings.Default.neighborCapacity} list entries, statistics every {SampleEvery} steps");
            run.Save(Front, FrontOf(SweepResult.All(sweep)),
                "the settings of error-time.csv that hold and that no other one beats, by scene and rising ms");
        }

        public override void Write(ReportPage page)
        {
            ReportTable table = page.Load(Sweep);
            page.DataFile(Front);
            ErrorTimePage.Write(page, SweepResult.All(table).ToList(), table);
        }

        public override void WriteOverview(ReportPage page)
        {
            List<SweepResult> results = SweepResult.All(page.Load(Sweep)).ToList();
            page.Line();
            page.Line("## All scenes at a glance");
            page.Line();
            page.Plot("error-time", "Error against milliseconds in all scenes: plain iterations, deep water, and the default",
                ErrorTimeOverview.Script(results, Default), ErrorTimeOverview.Width, ErrorTimeOverview.Height);
            page.Line($"Each point is a setting that [holds](#{Anchor.Of(Title)}) its scene; lines join those that no " +
                $"other one of their method beats. Lower left is better.");
        }

        SweepSetting? Default(SweepResult result)
        {
            ExperimentScene scene = full.Concat(quick).Select(plan => plan.Scene).FirstOrDefault(scene => scene.Name == result.Scene
                && scene.Particles == result.Particles);
            return scene == null ? null : SweepSetting.DefaultFor(scene.Particles / ((float)scene.Box.x * scene.Box.z));
        }

        static ReportTable FrontOf(IEnumerable<SweepResult> results)
        {
            var table = new ReportTable("scene", "particles", "layers", "substeps", "iterations", "relaxation", "deep", "ms", "ms_moving",
                "ms_settled", "error", "error_moving", "error_settled", "noise", "jitter", "bytes");
            foreach (IGrouping<string, SweepResult> scene in results.GroupBy(result => result.SceneId))
                foreach (SweepResult r in SweepResult.FrontOf(scene))
                    table.Add(r.Scene, r.Particles, r.Layers, r.Setting.Substeps, r.Setting.Iterations, r.Setting.Relaxation, r.Setting.Deep
                        ? "on" : "off", r.Milliseconds, r.MillisecondsMoving, r.MillisecondsSettled, r.Error, r.ErrorMoving, r.ErrorSettled,
                        r.Noise, r.Jitter, r.Bytes);
            return table;
        }
    }
}
