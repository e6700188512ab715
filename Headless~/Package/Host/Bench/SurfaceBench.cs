using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using System.Linq;
using Host.Commands;
using Host.Experiments;
using Host.Report;
using Rill;
using UnityEngine.Headless;

namespace Host.Bench
{
    /// <summary><c>bench surface</c>: GPU time of finding the water's surface, beside that of the step, and how much is drawn.</summary>
    static class SurfaceBench
    {
        /// <summary>The stage's marker.</summary>
        const string Surface = "Rill.Surface";

        static readonly (string Name, int First, int Last)[] Windows = StepTimes.Windows.Append(StepTimes.Settled).ToArray();

        public static Command Create()
        {
            var particles = new Option<int[]>("--particles") {
                Description = "Numbers of particles; the block's lattice comes as near as it can.", DefaultValueFactory = _
                => new[] { 100_000, 1_000_000 }, AllowMultipleArgumentsPerToken = true };
            var window = new Option<string>("--window") { Description = $"{string.Join(", ", Windows.Select(w => w.Name))} or all.",
                DefaultValueFactory = _ => "moving" };
            var steps = new Option<int>("--steps") { Description = $"Steps measured of each, at least {StepTimes.MinSteps}.",
                DefaultValueFactory = _ => StepTimes.MinSteps };
            Option<bool> kernels = KernelsOption.Create();
            var csv = new Option<string>("--csv") { Description = "Also write the figures to this file." };
            var mesh = new Option<float>("--mesh") {
                Description = "Also find it as a mesh, with nodes this far apart in particle spacings: 0.5, 0.75 or 1." };
            Option<string> shaders = ShadersOption.Create();
            var command = new Command("surface",
                "Measures GPU milliseconds of the surface that is found once a frame.") { particles, window, steps, mesh, kernels, csv, shaders };
            command.SetAction(parsed =>
            {
                ShadersOption.Use(parsed.GetValue(shaders));
                KernelsOption.Use(parsed.GetValue(kernels));
                foreach (int count in parsed.GetValue(particles))
                    GivenNumber.CheckOption("--particles", count, ExperimentScene.MinDamParticles, SolverLayout.MaxCapacity);
                if (parsed.GetValue(steps) < StepTimes.MinSteps)
                    throw new HostException($"--steps {parsed.GetValue(steps)}: a median needs at least {StepTimes.MinSteps}.");
                float cell = parsed.GetValue(mesh);
                if (cell != 0f && !(cell >= 0.25f && cell <= 2f))
                    throw new HostException(string.Create(CultureInfo.InvariantCulture,
                        $"--mesh {cell}: nodes lie 0.25 to 2 spacings apart, e.g. 0.75."));
                var windows = Windows.Where(w => parsed.GetValue(window) == "all" || parsed.GetValue(window) == w.Name).ToList();
                if (windows.Count == 0)
                    throw new HostException($"--window {parsed.GetValue(window)}: give {string.Join(", ", Windows.Select(w => w.Name))} or all.");
                return Execute(parsed.GetValue(particles), windows, cell, parsed.GetValue(steps), parsed.GetValue(csv), Console.Out);
            });
            return command;
        }

        static int Execute(int[] counts, List<(string Name, int First, int Last)> windows, float cell, int steps, string csv, TextWriter output)
        {
            using var session = new Session(Session.Root());
            StepInput input = ExperimentFigures.Input(SolverSettings.Default);
            output.WriteLine(session.DescribeDevice());
            output.WriteLine(
                $"a dam that breaks, {input.settings.substeps} substeps x {input.settings.iterations} iterations; the surface once a step");
            if (session.Info.IsSoftware)
                output.WriteLine("This device is a CPU: the figures say nothing about a GPU.");
            var table = new ReportTable("particles", "window", "stage", "median_ms", "p10_ms", "p90_ms", "steps", "elements",
                "surface_bytes") { MeasuredOn = session.DescribeDevice() };
            foreach (int count in counts)
            {
                ExperimentScene scene = ExperimentScene.Dam(count);
                using var solver = new PbfSolver(scene.LayoutFor(input.settings)) { MeshCell = cell };
                foreach ((string name, int first, int last) in windows)
                {
                    Dictionary<string, StepTimes.Spread> times = StepTimes.Measure(solver, scene.Fill, input, first, last, steps,
                        cmd =>
                        {
                            solver.FollowMeshSize();
                            solver.RecordSurface(cmd, input);
                        });
                    var counters = new uint[solver.Surface.Counters.count];
                    solver.Surface.Counters.GetData(counters);
                    uint drawn = counters[(int)SurfaceParticles.Counter.Drawn];
                    long bytes = solver.Describe(input, 0).Single(stage => stage.Name == "Surface particles").Bytes;
                    Print(scene.Particles, name, times, drawn, bytes, output);
                    if (solver.Mesh != null)
                        PrintMesh(solver, input, output);
                    foreach ((string stage, StepTimes.Spread spread) in times)
                        table.Add(scene.Particles, name, stage, spread.Median, spread.Low, spread.High, spread.Count, drawn, bytes);
                }
            }
            if (csv != null)
                table.Save(Path.GetFullPath(csv));
            return 0;
        }

        static void PrintMesh(PbfSolver solver, StepInput input, TextWriter output)
        {
            var counters = new uint[solver.Mesh.Counters.count];
            solver.Mesh.Counters.GetData(counters);
            uint Of(SurfaceMesh.Counter counter) => counters[(int)counter];
            long bytes = solver.Describe(input, 0).Single(stage => stage.Name == "Surface mesh").Bytes;
            output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"mesh with nodes {solver.Mesh.Cell} d apart: " +
                $"{Of(SurfaceMesh.Counter.Bricks):N0} bricks, {Of(SurfaceMesh.Counter.Vertices):N0} vertices, " +
                $"{Of(SurfaceMesh.Counter.Quads):N0} quads, {Of(SurfaceMesh.Counter.Drops):N0} drops; " +
                $"{Of(SurfaceMesh.Counter.VerticesNeeded) - Of(SurfaceMesh.Counter.Vertices):N0} vertices have no room; " +
                $"{bytes / 1048576.0:0.0} MiB"));
        }

        static void Print(int particles, string window, Dictionary<string, StepTimes.Spread> times, uint drawn, long bytes, TextWriter output)
        {
            output.WriteLine();
            output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{particles:N0} particles, {window}: {drawn:N0} elements " +
                $"({(double)drawn / particles:0.0 %} of the particles); the surface takes {bytes / 1048576.0:0.0} MiB, " +
                $"{bytes / (double)particles:0} bytes a particle"));
            output.WriteLine($"{"",-32}{"median ms",12}{"10 %",10}{"90 %",10}   of {times[StepTimes.Step].Count} steps");
            foreach ((string stage, StepTimes.Spread spread) in times.OrderBy(pair => pair.Key == StepTimes.Step ? 2 : pair.Key == Surface
                ? 1 : 0).ThenBy(pair => pair.Key))
                output.WriteLine(string.Create(CultureInfo.InvariantCulture,
                    $"{(stage == StepTimes.Step ? "step with the surface" : stage),-32}{spread.Median,12:0.0000}{spread.Low,10:0.0000}{spread.High,10:0.0000}"));
        }
    }
}
