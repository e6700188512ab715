using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.Linq;
using Host.Bench;
using Host.Experiments;
using Host.Report.Obstacles;
using Rill;

namespace Host.Commands
{
    /// <summary><c>measure</c>: one scene with one setting, its errors and its GPU time.</summary>
    static class MeasureCommand
    {
        public static Command Create()
        {
            var scene = new Argument<string>("scene") { Description = "dam:<particles>:<spacing in m, 1 m of water without one>, " +
                "column:<layers>:<spacing in m>, tank:<layers>:<side>:<spacing in m>, drop:<scale>:<spacing in m>, " +
                "spill:<layers>:<side>:<spacing in m>, " +
                "bucket:<particles across the radius>:<friction of its wall> or " +
                "cup:<thickness of its walls in spacings>:<acceleration in m/s²>:<degrees of its path to the grid>." };
            var seconds = new Option<double>("--seconds") { Description = "Fluid time; a cup always takes 5/3 s.", DefaultValueFactory = _ => 6 };
            var iterations = new Option<int>("--iterations") { DefaultValueFactory = _ => SolverSettings.Default.iterations };
            var substeps = new Option<int>("--substeps") { DefaultValueFactory = _ => SolverSettings.Default.substeps };
            var relaxation = new Option<float>("--relaxation") { DefaultValueFactory = _ => SolverSettings.Default.relaxation };
            var deep = new Option<DeepWater>("--deep-water") { DefaultValueFactory = _ => DeepWater.Automatic };
            var neighbors = new Option<int>("--neighbors") { Description = "Entries of a neighbor list.",
                DefaultValueFactory = _ => SolverSettings.Default.neighborCapacity };
            var every = new Option<int>("--every") { Description = "Steps between statistics; a prime number does not fall in step with what " +
                "is done every few steps.", DefaultValueFactory = _ => 7 };
            var sleep = new Option<float>("--sleep") { Description = "Speed below which water sleeps, m/s; 0 for never." };
            var damping = new Option<float>("--damping") { Description = "Numerical damping, as a fraction of a first-order step's.",
                DefaultValueFactory = _ => SolverSettings.Default.numericalDamping };
            var smoothing = new Option<float>("--smoothing") { Description = "XSPH's.",
                DefaultValueFactory = _ => FluidMaterial.Water.velocitySmoothing };
            var stages = new Option<bool>("--stages") { Description = "Also print the milliseconds of each stage." };
            var series = new Option<bool>("--series") { Description = "Also print every sample of the statistics." };
            var sheet = new Option<bool>("--sheet") {
                Description = "Also print how thick the water lies on the floor for what there is of it: for a few layers." };
            var command = new Command("measure", "Runs one scene with one setting and prints errors and GPU milliseconds.") { scene,
                seconds, iterations, substeps, relaxation, deep, neighbors, every, sleep, damping, smoothing, stages, series, sheet };
            command.SetAction(parsed =>
            {
                SolverSettings settings = SolverSettings.Default;
                settings.iterations = parsed.GetValue(iterations);
                settings.substeps = parsed.GetValue(substeps);
                settings.relaxation = parsed.GetValue(relaxation);
                settings.deepWater = parsed.GetValue(deep);
                settings.neighborCapacity = parsed.GetValue(neighbors);
                settings.sleepSpeed = parsed.GetValue(sleep);
                settings.numericalDamping = parsed.GetValue(damping);
                FluidMaterial material = FluidMaterial.Water;
                material.velocitySmoothing = parsed.GetValue(smoothing);
                GivenNumber.Clamp("measure", ref settings, ref material);
                StepInput input = ExperimentFigures.Input(settings, material);
                string text = parsed.GetValue(scene), kind = text.Split(':')[0];
                GivenNumber.CheckOption("--seconds", parsed.GetValue(seconds), kind == "bucket" ? BucketPeriod + 0.1 : 0.05,
                    GivenNumber.MaxSeconds);
                GivenNumber.CheckOption("--every", parsed.GetValue(every), 1, 1_000_000);
                // Before there is a device: what cannot be played is refused at once.
                Action<string> print = null;
                if (kind == "bucket")
                {
                    (int across, float friction) = ParseBucket(text);
                    print = device => PrintBucket(text, across, friction, input, parsed.GetValue(seconds), device);
                }
                else if (kind == "cup")
                {
                    (float wall, double acceleration, double degrees) = ParseCup(text);
                    print = device => PrintCup(text, wall, acceleration, degrees, input, device);
                }
                ExperimentScene experiment = print == null ? ExperimentScene.Parse(text) : null;
                using var session = new Session(Session.Root());
                if (print != null)
                {
                    print(session.DescribeDevice());
                    return 0;
                }
                using var solver = new PackageSolver(experiment.LayoutFor(settings), input);
                var sheets = new List<(double time, Sheet sheet)>();
                Experiment run = Experiment.Run(solver, experiment, input, parsed.GetValue(seconds), parsed.GetValue(every), sampled =>
                {
                    if (parsed.GetValue(sheet))
                        sheets.Add((sampled.End, new Sheet(solver.ReadPositions(sampled.Samples[^1].particles), experiment.Box.xz)));
                    return false;
                });
                Print(run, session.DescribeDevice(), parsed.GetValue(stages));
                if (parsed.GetValue(series))
                    PrintSeries(run);
                PrintSheets("0.75 to 2 s", sheets.Where(s => s.time > 0.74 && s.time <= 2.001));
                PrintSheets("after 2 s", sheets.Where(s => s.time > 2.001));
                return 0;
            });
            return command;
        }

        const double BucketPeriod = 1.6;        // s

        /// <summary>"bucket:24:1": particles across the radius, friction of the wall.</summary>
        public static (int Across, float Friction) ParseBucket(string text)
        {
            // Each ring that is averaged needs particles; the water is as deep as its radius, π across³ particles in all.
            double max = Math.Floor(0.98 * Math.Cbrt(SolverLayout.MaxCapacity / Math.PI));
            double[] numbers = GivenNumber.Parse(text, "bucket:24:1",
                new GivenNumber("particles across the radius", RotatingBucket.Rings, max),
                new GivenNumber("friction of its wall", 0, 1, false));
            return ((int)numbers[0], (float)numbers[1]);
        }

        // The mean over the last period of the first round wave, as in the report.
        static void PrintBucket(string scene, int across, float friction, StepInput input, double seconds, string device)
        {
            const double period = BucketPeriod;
            int positions = RotatingBucket.PositionsFor(across);
            RotatingBucket bucket = RotatingBucket.Run(across, BucketReport.Speed, false, input, seconds - period, period, friction,
                runs: positions);
            double expected = RotatingBucket.TurningLeft(BucketReport.Speed, input.timeStep / input.settings.substeps, seconds - period / 2);
            Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{scene} N {bucket.Particles:N0}, {input.settings.substeps} " +
                $"x {input.settings.iterations}, deep water {input.settings.deepWater}, {seconds:0.#} s, " +
                $"mean over {positions} positions in the grid, {device}"));
            Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"  turning left {bucket.Turning:0.0000} of " +
                $"{expected:0.0000} by the step alone ({bucket.Turning / expected - 1:+0.0000;-0.0000}) | steepness for its own " +
                $"turning {bucket.OwnSteepness:0.000}, for the bucket's {bucket.Steepness:0.000}"));
            foreach (var ring in bucket.Profile)
                Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"  at {ring.Radius:0.000} m: height " +
                    $"{ring.Height:0.0000} m of {ring.OwnTheory:0.0000} for its own turning, {ring.Turning:0.000} rad/s"));
        }

        /// <summary>"cup:2:4:20": thickness of the walls in spacings, acceleration in m/s², degrees of the path to the grid.</summary>
        public static (float Wall, double Acceleration, double Degrees) ParseCup(string text)
        {
            double[] numbers = GivenNumber.Parse(text, "cup:2:4:20", new GivenNumber("thickness of its walls", 0.5, 16, false),
                new GivenNumber("acceleration", 0.5, 8, false), new GivenNumber("degrees of its path", 0, 90, false));
            return ((float)numbers[0], numbers[1], numbers[2]);
        }

        static void PrintCup(string scene, float wall, double acceleration, double degrees, StepInput input, string device)
        {
            double[] slopes = Enumerable.Range(0, 4).Select(shift => MovingCup.Run(input, wall, acceleration, degrees, shift)).ToArray();
            Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{scene} N {MovingCup.Inside * MovingCup.Inside * MovingCup.Layers:N0}, " +
                $"{input.settings.substeps} x {input.settings.iterations}, deep water {input.settings.deepWater}, {device}"));
            Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"  slope over a / g, from places 0 to 3 d along the path: " +
                $"{string.Join(", ", slopes.Select(s => s.ToString("0.000", CultureInfo.InvariantCulture)))}; mean {slopes.Average():0.000}"));
        }

        static void PrintSheets(string window, IEnumerable<(double time, Sheet sheet)> sheets)
        {
            if (sheets.Any())
                Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"  sheet {window}: local volume " +
                    $"{sheets.Average(s => s.sheet.LocalVolume):0.000} high {sheets.Average(s => s.sheet.High):0.0000} unevenness " +
                    $"{sheets.Average(s => s.sheet.Unevenness):0.00} layers"));
        }

        static void PrintSeries(Experiment run)
        {
            foreach (FluidStatistics s in run.Samples)
                Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"  {run.Time(s):0.0000} s: C+ {s.densityError:0.00000} " +
                    $"p99.9 {s.densityError999:0.000} max {s.densityErrorMax:0.00} | interior {s.interiorError:0.0000} volume " +
                    $"{s.volumeRatio:0.000} | jitter {s.jitter:0.0000} speed {s.speed:0.000} max {s.speedMax:0.0} m/s | energy " +
                    $"{s.Energy / run.Samples[0].Energy:0.0000} | furthest {s.furthest.x / run.Scene.Spacing:0.0} " +
                    $"{s.furthest.y / run.Scene.Spacing:0.0} d | coincident {s.coincident} overflow {s.neighborOverflow}"));
        }

        static void Print(Experiment run, string device, bool stages)
        {
            SolverSettings settings = run.Input.settings;
            double start = run.Samples[0].Energy;
            Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{run.Scene.Name} N {run.Scene.Particles:N0} d " +
                $"{run.Scene.Spacing:0.#####} m, {settings.substeps} x {settings.iterations}, relaxation {settings.relaxation}, deep " +
                $"water {settings.deepWater}, numerical damping {settings.numericalDamping}, {run.End:0.#} s, {device}"));
            Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"  C+ moving {run.Moving(s => s.densityError):0.00000} " +
                $"settled {run.Settled(s => s.densityError):0.00000} highest {run.Samples.Max(s => s.densityError):0.000} p99.9 " +
                $"{run.Settled(s => s.densityError999):0.0000} ever max {run.Samples.Max(s => s.densityErrorMax):0.00} | interior " +
                $"{run.Settled(s => s.interiorError):0.0000} volume {run.Settled(s => s.volumeRatio):0.0000} lowest " +
                $"{run.Samples.Min(s => s.volumeRatio):0.0000} height {run.Settled(s => s.furthest.y):0.000} m | jitter " +
                $"{run.Settled(s => s.jitter):0.0000} speed {run.Settled(s => s.speed):0.0000} max " +
                $"{run.Samples.Max(s => s.speedMax):0.0} m/s | energy max/start {run.Samples.Max(s => s.Energy) / start:0.0000} | " +
                $"coincident {run.Samples[^1].coincident} (most {run.Samples.Max(s => s.coincident)}) escaped " +
                $"{run.Samples.Max(s => s.escaped)} overflow {run.Samples.Max(s => s.neighborOverflow)} non-finite " +
                $"{run.Samples[^1].nonFinite}"));
            Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"  ms, mean (median, a tenth above) initial " +
                $"{Times(run, "initial")} moving {Times(run, "moving")} settled {Times(run, "settled")} | {run.Bytes / (double)run.Scene.Particles:0} bytes a particle"));
            if (stages)
                foreach (var window in run.Times)
                    Console.WriteLine($"  {window.Key}: "
                        + string.Join(", ", window.Value.Keys.Select(stage => string.Create(CultureInfo.InvariantCulture,
                        $"{stage} {run.TimesOf(window.Key, stage).Mean:0.0000}"))));
        }

        static string Times(Experiment run, string window)
        {
            StepTimes.Spread times = run.TimesOf(window);
            return string.Create(CultureInfo.InvariantCulture, $"{times.Mean:0.000} ({times.Median:0.000}, {times.High:0.000})");
        }
    }
}
