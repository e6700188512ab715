using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using Host.Assets;
using Host.Commands;
using Host.Output;
using Host.Pipelines;
using UnityEngine.Headless;

namespace Host
{
    /// <summary>Plays a scene for a while, measuring each step and drawing some, and leaves a folder that shows it.</summary>
    sealed class SceneRun
    {
        static readonly string[] OwnColumns = { "time_s", "step_ms", "gpu_ms" };

        readonly RunSettings settings;
        readonly TextWriter output;
        readonly Dictionary<string, double> stageTimes = new();
        readonly List<double> compilingSteps = new();       // ms of each: their time is that of compilers
        string folder;
        HostException toolFailure;

        public SceneRun(RunSettings settings, TextWriter output)
        {
            this.settings = settings;
            this.output = output;
        }

        /// <returns>The exit code: see <see cref="CommandLine"/>.</returns>
        public int Execute()
        {
            ForeignProject project = settings.Project == null ? null : ForeignProject.Open(settings.Project, settings.Scene, settings.Strict, output);
            LocatedScene scene = project?.Scene ?? Session.Locate(settings.Scene);
            folder = ResultsFolder.Of(settings.Target, Path.GetFileNameWithoutExtension(scene.File));
            Tool.WarnOfMissing((Tool.Gnuplot, "plots"), (Tool.Ffmpeg, FfmpegProducts()));
            Directory.CreateDirectory(folder);
            Player.ScreenWidth = settings.Width;
            Player.ScreenHeight = settings.Height;

            if (settings.Pipeline != null)
                PlayedPipeline.Load(settings.Pipeline.Version, Session.Root());      // before the session, which runs initializers
            using var session = project == null ? new Session(scene, settings.Strict, settings.Compute, player: true)
                : new Session(project.Scene.Root, project.Scene.Mounts, project.Scripts.Assemblies, strict: settings.Strict,
                    compute: settings.Compute, foreign: project.Scripts);
            output.WriteLine($"{Path.GetFileNameWithoutExtension(scene.File)} on {session.DescribeDevice()}");
            if (settings.Seed is int seed)
                UnityEngine.Random.InitState(seed);
            using PlayedPipeline pipeline = settings.Pipeline == null ? null
                : PlayedPipeline.Start(settings.Pipeline.Kind, settings.Pipeline.Version, Session.Root(), settings.Pipeline.ByExecute);
            session.LoadScene(scene);

            // Probes look into the package that the host was built with.
            List<IRunProbe> probes = project == null ? BuiltInPackage.Current.Probes() : new List<IRunProbe>();
            var statistics = new Statistics(OwnColumns.Concat(probes.SelectMany(probe => probe.Columns)));
            using (var frames = settings.Draw ? new FrameWriter(Path.Combine(folder, "frames")) : null)
            {
                Play(session, probes, statistics, frames);
                Report(new StatisticsPage
                {
                    Title = Path.GetFileNameWithoutExtension(scene.File),
                    Command = settings.Command,
                    Statistics = statistics,
                    Plots = new List<Plot> { new("step-time", "Time of a step", "ms", "step_ms",
                        "gpu_ms") }.Concat(probes.SelectMany(probe => probe.Plots)).ToList(),
                    Stages = stageTimes.Select(stage => (stage.Key,
                    stage.Value / Math.Max(statistics.Rows.Count - compilingSteps.Count, 1))).ToList(),
                    Settings = OwnSettings(scene, session).Concat(probes.SelectMany(probe => probe.Settings)).ToList(),
                }, frames);
                foreach (string line in probes.SelectMany(probe => probe.Summary))
                    output.WriteLine(line);
            }
            if (settings.Hash)
                output.WriteLine($"hash {(project == null ? BuiltInPackage.Current.StateHash() : null) ?? BufferDump.Hash()}");
            pipeline?.Dispose();
            int code = Close(session);
            if (project != null)
                code = Math.Max(code, project.Summarize(session, output));
            return toolFailure == null ? code : throw toolFailure;
        }

        void Play(Session session, List<IRunProbe> probes, Statistics statistics, FrameWriter frames)
        {
            int steps = (int)Math.Ceiling(settings.Seconds * settings.FramesPerSecond - 1e-6);
            IGraphicsDevice device = Player.Device;
            device.Timing = true;
            Output.Progress.Run(output, "simulating", steps, report =>
            {
                if (frames != null)
                {
                    // The state at the start: a frame in which no time passes.
                    PlayerLoop.Frame(0f);
                    session.ThrowFault();
                    frames.Add(0, Draw());
                }
                for (int step = 1; step <= steps; step++)
                {
                    int made = DeviceObjects.Made;
                    var clock = Stopwatch.StartNew();
                    PlayerLoop.Frame((float)(1 / settings.FramesPerSecond));
                    session.ThrowFault();
                    device.WaitIdle();
                    double milliseconds = clock.Elapsed.TotalMilliseconds;
                    double time = step / settings.FramesPerSecond;

                    bool compiled = DeviceObjects.Made > made;
                    if (compiled)
                        compilingSteps.Add(milliseconds);
                    statistics.Add(Row(time, compiled ? double.NaN : milliseconds, probes));
                    if (frames != null && step % settings.DrawEvery == 0)
                        frames.Add(time, Draw());
                    if (Array.IndexOf(settings.DumpAt, step) >= 0)
                        BufferDump.Write(settings.DumpFolder, step);
                    report(step, string.Create(CultureInfo.InvariantCulture,
                        $"{time:0.00} s of {settings.Seconds:0.##} s, {milliseconds:0.0} ms a step"));
                }
            });
        }

        /// <param name="milliseconds">NaN in a step that compiled shaders.</param>
        double[] Row(double time, double milliseconds, List<IRunProbe> probes)
        {
            List<DeviceSample> samples = Player.Device.CollectSamples();
            foreach (DeviceSample sample in samples.Where(_ => !double.IsNaN(milliseconds)))
                stageTimes[sample.Name] = stageTimes.GetValueOrDefault(sample.Name) + sample.Milliseconds;
            double gpu = samples.Where(sample => sample.Depth == 0).Sum(sample => sample.Milliseconds);
            var row = new List<double> { time, milliseconds, double.IsNaN(milliseconds) ? double.NaN : gpu };
            foreach (IRunProbe probe in probes)
            {
                var values = new double[probe.Columns.Length];
                probe.Sample(time, values);
                row.AddRange(values);
            }
            return row.ToArray();
        }

        static Func<byte[]> Draw()
        {
            byte[] rgba = Screenshot.ReadRgba();
            (int width, int height) = (Player.ScreenWidth, Player.ScreenHeight);
            return () => Png.Encode(rgba, width, height);
        }

        void Report(StatisticsPage page, FrameWriter frames)
        {
            page.Statistics.WriteCsv(Path.Combine(folder, "statistics.csv"));
            page.Plots.RemoveAll(plot => !IsMade(Tool.Gnuplot, () => plot.Draw(folder, page.Statistics, OwnColumns[0])));
            if (frames != null)
            {
                frames.Finish();
                page.HasContactSheet = IsMade(Tool.Ffmpeg, () => Video.ContactSheet(frames.Frames, Path.Combine(folder, "contact.png")));
                if (settings.Stills.Length > 0)
                    IsMade(Tool.Ffmpeg, () =>
                        Video.ContactSheet(Array.ConvertAll(settings.Stills,
                        time => frames.Frames.MinBy(frame => Math.Abs(frame.Time - time))), Path.Combine(folder, "stills.png"),
                        columns: settings.Stills.Length, rows: 1));
                page.HasVideo = settings.Video
                    && IsMade(Tool.Ffmpeg, () => Video.Encode(frames.Pattern, settings.FramesPerSecond / settings.DrawEvery,
                    Path.Combine(folder, "video.mp4")));
            }
            page.Write(folder);

            output.WriteLine(StepTimes(page.Statistics.Known("step_ms"), compilingSteps));
            output.WriteLine($"results in {folder}");
        }

        internal static string StepTimes(double[] steps, List<double> compiling)
        {
            string compiled = compiling.Count == 0 ? "" : string.Create(CultureInfo.InvariantCulture,
                $"{compiling.Count} that compiled shaders took {compiling.Sum():0} ms");
            if (steps.Length == 0)
                return $"no steps but {compiled}";
            return string.Create(CultureInfo.InvariantCulture, $"{steps.Length} steps, {steps.Average():0.0} ms a step, " +
                $"{StatisticsPage.Percentile(steps, 0.999):0.0} ms at the 99.9th percentile") + (compiled == "" ? "" : $"; beside them {compiled}");
        }

        // The output of a missing or failed tool is left out; the rest is written before the failure is reported.
        bool IsMade(Tool tool, Action make)
        {
            if (!tool.IsInstalled)
                return false;
            try
            {
                make();
                return true;
            }
            catch (HostException e)
            {
                toolFailure ??= e;
                return false;
            }
        }

        string FfmpegProducts() => !settings.Draw ? null
            : string.Join(", ", new[] { "contact sheet", settings.Stills.Length > 0 ? "stills" : null, settings.Video ? "film"
            : null }.Where(product => product != null));

        int Close(Session session)
        {
            List<string> left = session.End();
            output.WriteLine($"{left.Count} GPU objects left");
            foreach (string thing in left)
                output.WriteLine("  " + thing);
            if (left.Count > 0)
                return 3;
            if (session.ErrorsLogged == 0)
                return 0;
            Console.Error.WriteLine($"{CommandLine.Name}: errors logged: {session.ErrorsLogged}");
            return 1;
        }

        IEnumerable<(string, string)> OwnSettings(LocatedScene scene, Session session)
        {
            yield return ("scene", Path.GetRelativePath(scene.Root, scene.File));
            yield return ("device", session.DescribeDevice());
            yield return ("simulated time", string.Create(CultureInfo.InvariantCulture,
                $"{settings.Seconds} s at {settings.FramesPerSecond} frames a second"));
            yield return ("frames", settings.Draw ? $"{settings.Width} x {settings.Height}, one of {settings.DrawEvery} steps drawn" : "none drawn");
            if (settings.Seed is int seed)
                yield return ("seed", seed.ToString(CultureInfo.InvariantCulture));
            yield return ("date", DateTime.UtcNow.ToString("yyyy-MM-dd HH:mm 'UTC'", CultureInfo.InvariantCulture));
        }
    }
}
