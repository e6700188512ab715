using System;
using System.Diagnostics;
using System.Linq;
using Host.Report;

namespace Host.Studies.Methods
{
    /// <summary>Accelerators of the passes and parameters of the two-level correction, each as a curve of error, noise and time.</summary>
    sealed class MethodsSection : ReportSection
    {
        public const string TableName = "methods";

        public override string Name => "methods";
        public override string Title => "Methods: what makes the passes converge";

        public override void Measure(ReportRun run)
        {
            var table = new ReportTable(MethodRun.Columns);
            MethodScene[] scenes = MethodScene.All(run.Quick).ToArray();
            foreach (MethodStudy study in MethodStudies.All(run.Quick))
            {
                var clock = Stopwatch.StartNew();
                foreach (MethodVariant variant in study.Variants)
                    foreach (MethodScene scene in scenes)
                        table.Add(MethodRun.Of(study, variant, scene).Row);
                run.Log($"  {study.Title}: {study.Variants.Length * scenes.Length} runs in {clock.Elapsed.TotalSeconds:0.0} s");
            }
            string where = string.Join("; ", scenes.Select(scene =>
                $"{scene.Title} ({scene.Scene.Particles:N0} particles; d {scene.Scene.Spacing:0.####} m; {scene.Seconds:0.#} s)"));
            run.Save(TableName, table, FormattableString.Invariant($"{(run.Quick ? Quick + "; " : "")}60 Hz; {where}"));
        }

        public override void Write(ReportPage page) => new MethodsPage(page, page.Load(TableName)).Write();

        /// <summary>Marks a table of small scenes on a CPU, whose times mean nothing.</summary>
        public const string Quick = "quick";
    }
}
