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
            var screens = new Option<string[]>("--screen") {
                Description = "Pixels of cameras that also draw it, 1920x1080 for one eye, 2x2064x2208 for two.", DefaultValueFactory = _
                => Array.Empty<string>(), AllowMultipleArgumentsPerToken = true };
            var quality = new Option<SurfaceQuality>("--quality") { Description = "low, medium or high.",
                DefaultValueFactory = _ => SurfaceQuality.Medium };
            var mesh = new Option<float>("--mesh") {
                Description = "Also find it as a mesh, with nodes this far apart in particle spacings: 0.5, 0.75 or 1." };
            Option<string> shaders = ShadersOption.Create();
            var command = new Command("surface",
                "Measures GPU milliseconds of the surface that is found once a frame, and of drawing it.") { particles, window, steps,
                screens, quality, mesh, kernels, csv, shaders };
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
                if (cell != 0f && parsed.GetValue(screens).Length > 0)
                    throw new HostException("--mesh with --screen: the passes of a screen draw ellipsoids. Give one of them.");
                var windows = Windows.Where(w => parsed.GetValue(window) == "all" || parsed.GetValue(window) == w.Name).ToList();
                if (windows.Count == 0)
                    throw new HostException($"--window {parsed.GetValue(window)}: give {string.Join(", ", Windows.Select(w => w.Name))} or all.");
                return Execute(parsed.GetValue(particles), windows, parsed.GetValue(screens).Select(Screen.Parse).ToArray(),
                    parsed.GetValue(quality), cell, parsed.GetValue(steps), parsed.GetValue(csv), Console.Out);
            });
            return command;
        }

        static int Execute(int[] counts, List<(string Name, int First, int Last)> windows, Screen[] screens, SurfaceQuality quality,
            float cell, int steps, string csv, TextWriter output)
        {
            using var session = new Session(Session.Root());
            StepInput input = ExperimentFigures.Input(SolverSettings.Default);
            output.WriteLine(session.DescribeDevice());
            output.WriteLine(
                $"a dam that breaks, {input.settings.substeps} substeps x {input.settings.iterations} iterations; the surface once a step");
            if (session.Info.IsSoftware)
                output.WriteLine("This device is a CPU: the figures say nothing about a GPU.");
            var table = new ReportTable("particles", "window", "screen", "stage", "median_ms", "p10_ms", "p90_ms", "steps", "drawn",
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
                        table.Add(scene.Particles, name, "", stage, spread.Median, spread.Low, spread.High, spread.Count, drawn, bytes);
                    foreach (Screen screen in screens)
                        Draw(solver, scene, input, (name, first, last), screen, quality, steps, drawn, table, output);
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

        static void Draw(PbfSolver solver, ExperimentScene scene, StepInput input, (string Name, int First, int Last) window, Screen screen,
            SurfaceQuality quality, int steps, uint drawn, ReportTable table, TextWriter output)
        {
            using var passes = new ScreenPasses(scene.Domain, scene.Spacing, screen.Width, screen.Height, screen.Eyes);
            Dictionary<string, StepTimes.Spread> times = StepTimes.Measure(solver, scene.Fill, input, window.First, window.Last, steps, cmd =>
            {
                solver.RecordSurface(cmd, input);
                passes.Record(cmd, solver, quality);
            });
            (int water, int all) = passes.Texels;
            output.WriteLine();
            output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{scene.Particles:N0} particles, {window.Name}, {screen}, " +
                $"{quality}: {water:N0} of {all:N0} texels of an eye hold water; textures take {passes.Bytes / 1048576.0:0.0} MiB"));
            output.WriteLine($"{"",-32}{"median ms",12}{"10 %",10}{"90 %",10}");
            foreach ((string stage, StepTimes.Spread spread) in times.Where(pair => pair.Key.StartsWith(Surface + ".",
                StringComparison.Ordinal)).OrderBy(pair => pair.Key))
            {
                output.WriteLine(string.Create(CultureInfo.InvariantCulture,
                    $"{stage,-32}{spread.Median,12:0.0000}{spread.Low,10:0.0000}{spread.High,10:0.0000}"));
                table.Add(scene.Particles, window.Name, screen.ToString(), stage, spread.Median, spread.Low, spread.High, spread.Count,
                    drawn, passes.Bytes);
            }
        }

        /// <summary>What a camera draws: pixels of an eye, and how many eyes.</summary>
        readonly record struct Screen(int Width, int Height, int Eyes)
        {
            public static Screen Parse(string text)
            {
                int[] numbers = text.Split('x')
                    .Select(part => int.TryParse(part, NumberStyles.None, CultureInfo.InvariantCulture, out int number) ? number : 0)
                    .ToArray();
                if (numbers.Length is 2 or 3 && numbers.All(number => number > 0 && number <= 16384) && (numbers.Length == 2 || numbers[0] <= 2))
                    return numbers.Length == 2 ? new Screen(numbers[0], numbers[1], 1) : new Screen(numbers[1], numbers[2], numbers[0]);
                throw new HostException($"--screen {text}: give width x height, 1 to 16384 each, as in 1920x1080, or 2x2064x2208 for two eyes.");
            }

            public override string ToString() => Eyes == 1 ? $"{Width}x{Height}" : $"{Eyes}x{Width}x{Height}";
        }

        static void Print(int particles, string window, Dictionary<string, StepTimes.Spread> times, uint drawn, long bytes, TextWriter output)
        {
            output.WriteLine();
            output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{particles:N0} particles, {window}: {drawn:N0} ellipsoids " +
                $"are drawn ({(double)drawn / particles:0.0 %} of the particles); the surface takes {bytes / 1048576.0:0.0} MiB, " +
                $"{bytes / (double)particles:0} bytes a particle"));
            output.WriteLine($"{"",-32}{"median ms",12}{"10 %",10}{"90 %",10}   of {times[StepTimes.Step].Count} steps");
            foreach ((string stage, StepTimes.Spread spread) in times.OrderBy(pair => pair.Key == StepTimes.Step ? 2 : pair.Key == Surface
                ? 1 : 0).ThenBy(pair => pair.Key))
                output.WriteLine(string.Create(CultureInfo.InvariantCulture,
                    $"{(stage == StepTimes.Step ? "step with the surface" : stage),-32}{spread.Median,12:0.0000}{spread.Low,10:0.0000}{spread.High,10:0.0000}"));
        }
    }
}
