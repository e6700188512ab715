using System;
using System.CommandLine;
using System.Globalization;
using System.IO;
using System.Linq;
using Host.Output;

namespace Host.Commands
{
    /// <summary><c>run</c>: plays a scene, draws frames, and makes a film, a contact sheet and statistics of it.</summary>
    static class RunCommand
    {
        public static Command Create()
        {
            var scene = new Argument<string>("scene") {
                Description = "A .unity file, or the name of a scene or sample; with --project, the first scene of the build by default.",
                Arity = ArgumentArity.ZeroOrOne };
            var project = new Option<string>("--project") {
                Description =
                "A Unity project's folder: its scripts are compiled, and its scene is played as Unity would, logging and going on." };
            var seconds = new Option<double>("--seconds") { Description = "Simulated time.", DefaultValueFactory = _ => 5 };
            var frames = new Option<int?>("--frames") { Description = "Frames to play, instead of --seconds." };
            var fps = new Option<double>("--fps") { Description = "Frames per second of the player; frame time is its inverse.",
                DefaultValueFactory = _ => 60 };
            var every = new Option<int>("--every") { Description = "Draw each Nth frame.", DefaultValueFactory = _ => 2 };
            var size = new Option<string>("--size") { Description = "Pixels of a frame.", DefaultValueFactory = _ => "1280x720" };
            var target = new Option<string>("--out") { Description = $"Folder for the results; {ResultsFolder.Root}/<scene> by default." };
            var noVideo = new Option<bool>("--no-video") { Description = "No video.mp4." };
            var noFrames = new Option<bool>("--no-frames") { Description = "Draw nothing: no frames, contact sheet and film." };
            var stills = new Option<string>("--stills") {
                Description = "Also put the frames nearest to these seconds side by side in stills.png: 0,0.5,1,2,5." };
            var hash = new Option<bool>("--hash") { Description = "Print a hash of all buffers after the last frame." };
            var dump = new Option<string>("--dump") { Description = "Folder for the bytes of all buffers after the frames of --at." };
            var at = new Option<string>("--at") { Description = "Frames to dump, by number from 1: 1,60,300." };
            var seed = new Option<int?>("--seed") { Description = "Seed of UnityEngine.Random." };
            var noCompute = new Option<bool>("--no-compute") { Description = "Pretend that the machine cannot run compute shaders." };
            var strict = new Option<bool>("--strict") { Description = "With --project: stop where Unity logs and goes on or is undefined." };
            var notStrict = new Option<bool>("--not-strict") { Description = "Where Unity logs and goes on, do so, instead of stopping." };
            var stereo = new Option<bool>("--stereo") { Description = "Draw two eyes in one pass, as for a headset, beside each other." };
            var pipeline = new Option<string>("--pipeline") { Description = $"Render pipeline whose stand-in draws, with the package's " +
                $"adapter: {string.Join(", ", PipelineChoice.Names)}. Built-in by default." };
            Option<string> shaders = ShadersOption.Create();
            Option<string> limits = LimitsOption.Create();

            var command = new Command("run", "Plays a scene without Unity and shows it.") { scene, project, seconds, frames, fps, every,
                size, target, noVideo, noFrames, stills, hash, dump, at, seed, noCompute, strict, notStrict, stereo, pipeline, shaders,
                limits };
            command.SetAction(parsed =>
            {
                ShadersOption.Use(parsed.GetValue(shaders));
                UnityEngine.Headless.Player.Stereo = parsed.GetValue(stereo);
                LimitsOption.Use(parsed.GetValue(limits));
                (int width, int height) = Size(parsed.GetValue(size));
                double rate = Positive(parsed.GetValue(fps), "--fps");
                if (parsed.GetValue(scene) == null && parsed.GetValue(project) == null)
                    throw new HostException("run needs a scene: a .unity file or the name of one, or --project <folder>.");
                var settings = new RunSettings
                {
                    Scene = parsed.GetValue(scene),
                    Project = parsed.GetValue(project),
                    Seconds = parsed.GetValue(frames) is int count ? Positive(count, "--frames") / rate
                        : Positive(parsed.GetValue(seconds), "--seconds"),
                    FramesPerSecond = rate,
                    DrawEvery = (int)Positive(parsed.GetValue(every), "--every"),
                    Width = width,
                    Height = height,
                    Target = parsed.GetValue(target),
                    Video = !parsed.GetValue(noVideo),
                    Draw = !parsed.GetValue(noFrames),
                    Stills = Times(parsed.GetValue(stills)),
                    Hash = parsed.GetValue(hash),
                    DumpFolder = parsed.GetValue(dump),
                    DumpAt = Frames(parsed.GetValue(at)),
                    Seed = parsed.GetValue(seed),
                    Pipeline = PipelineChoice.Of(parsed.GetValue(pipeline), parsed.GetValue(project)),
                    Compute = !parsed.GetValue(noCompute),
                    Strict = parsed.GetValue(project) == null ? !parsed.GetValue(notStrict) : parsed.GetValue(strict),
                    Command = CommandLine.Name + " "
                        + string.Join(" ", parsed.Tokens.Select(token => token.Value.Contains(' ') ? $"\"{token.Value}\"" : token.Value)),
                };
                if (settings.Stills.Length > 0 && !settings.Draw)
                    throw new HostException("--stills needs frames; leave out --no-frames.");
                if (settings.DumpFolder == null != (settings.DumpAt.Length == 0))
                    throw new HostException("--dump <folder> and --at <frame,...> go together.");
                int outcome = new SceneRun(settings, Console.Out).Execute();
                ShadersOption.Report(Console.Out);
                return outcome;
            });
            return command;
        }

        internal static (int Width, int Height) Size(string text)
        {
            string[] parts = text.Split('x');
            if (parts.Length == 2 && int.TryParse(parts[0], out int width) && int.TryParse(parts[1], out int height)
                && width is > 0 and <= 16384 && height is > 0 and <= 16384)
                return (width, height);
            throw new HostException($"--size {text}: give width and height as 1280x720, each 1 to 16384.");
        }

        internal static int[] Frames(string text)
        {
            if (string.IsNullOrEmpty(text))
                return Array.Empty<int>();
            return Array.ConvertAll(text.Split(','), part => int.TryParse(part, out int frame) && frame >= 1
                ? frame
                : throw new HostException($"--at {text}: \"{part}\" is not a frame number; they count from 1, as in 1,60,300."));
        }

        internal static double[] Times(string text)
        {
            if (string.IsNullOrEmpty(text))
                return Array.Empty<double>();
            return Array.ConvertAll(text.Split(','),
                part => double.TryParse(part, NumberStyles.Float, CultureInfo.InvariantCulture, out double time) && time >= 0
                ? time
                : throw new HostException($"--stills {text}: \"{part}\" is not a time in seconds, as in 0,0.5,1."));
        }

        static double Positive(double value, string option) => value > 0 && double.IsFinite(value) ? value
            : throw new HostException($"{option} must be above 0, not {value}.");
    }

    sealed class RunSettings
    {
        public string Scene, Project, Target, DumpFolder, Command;
        public double Seconds, FramesPerSecond;
        public int Width, Height, DrawEvery;
        public bool Video, Draw, Hash, Compute, Strict;
        public int[] DumpAt;
        public double[] Stills;
        public int? Seed;
        /// <summary>Null: the Built-in one.</summary>
        public PipelineChoice Pipeline;
    }
}
