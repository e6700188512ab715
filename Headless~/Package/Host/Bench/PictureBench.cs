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
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace Host.Bench
{
    /// <summary>
    /// <c>bench picture</c>: what drawing the water adds to a frame with one step, over a dam that breaks before a camera of the Built-in
    /// pipeline: what is found once a frame, and what the camera draws.
    /// </summary>
    static class PictureBench
    {
        const float FrameTime = 1f / 60f, FieldOfView = 40f;        // s, degrees
        const string CameraSample = "camera";
        static readonly (string Name, int First, int Last) Settled = ("settled", 600, 700);
        static readonly (string Name, int First, int Last) Moving = ("moving", 20, 120);

        static readonly (string Name, Action<FluidSurface> Set)[] Rows =
        {
            ("none", null),
            ("water", _ => { }),
            ("water without caustics", surface => surface.Caustics = false),
            ("none again", null),
        };

        public static Command Create()
        {
            var particles = new Option<int[]>("--particles") {
                Description = "Particles of the fluid; the block's lattice comes as near as it can.",
                DefaultValueFactory = _ => new[] { 100_000, 1_000_000 }, AllowMultipleArgumentsPerToken = true };
            var sizes = new Option<string[]>("--size") { Description = "Pixels of the picture, as in 1920x1080.",
                DefaultValueFactory = _ => new[] { "1920x1080" }, AllowMultipleArgumentsPerToken = true };
            var quality = new Option<SurfaceQuality>("--quality") { Description = "low, medium or high.",
                DefaultValueFactory = _ => SurfaceQuality.Medium };
            var stereo = new Option<bool>("--stereo") { Description = "Draw two eyes in one pass, each of that size." };
            var foam = new Option<int>("--foam") { Description = "Foam particles, all of which are there soon; 0: none." };
            var settled = new Option<bool>("--settled") { Description = $"Frames {Settled.First} to {Settled.Last} instead of {Moving.First} to " +
                $"{Moving.Last}." };
            var rows = new Option<string[]>("--rows") {
                Description = $"{string.Join(", ", Rows.Select(row => row.Name))}: those that are measured.",
                DefaultValueFactory = _ => Rows.Select(row => row.Name).ToArray(), AllowMultipleArgumentsPerToken = true };
            var csv = new Option<string>("--csv") { Description = "Also write the figures to this file." };
            Option<string> shaders = ShadersOption.Create();
            var command = new Command("picture", "Measures what drawing the water adds to a frame, with and without caustics.") {
                particles, sizes, rows, quality, foam, stereo, settled, csv, shaders };
            command.SetAction(parsed =>
            {
                ShadersOption.Use(parsed.GetValue(shaders));
                Player.Stereo = parsed.GetValue(stereo);
                foreach (int count in parsed.GetValue(particles))
                    GivenNumber.CheckOption("--particles", count, ExperimentScene.MinDamParticles, SolverLayout.MaxCapacity);
                string unknown = parsed.GetValue(rows).FirstOrDefault(name => Rows.All(row => row.Name != name));
                if (unknown != null)
                    throw new HostException($"--rows {unknown}: give {string.Join(", ", Rows.Select(row => row.Name))}.");
                Execute(parsed.GetValue(particles), parsed.GetValue(sizes).Select(ParseSize).ToArray(),
                    Rows.Where(row => parsed.GetValue(rows).Contains(row.Name)).ToArray(), parsed.GetValue(quality),
                    parsed.GetValue(foam), parsed.GetValue(settled) ? Settled : Moving, parsed.GetValue(csv), Console.Out);
                return 0;
            });
            return command;
        }

        static (int Width, int Height) ParseSize(string text)
        {
            int[] numbers = text.Split('x')
                .Select(part => int.TryParse(part, NumberStyles.None, CultureInfo.InvariantCulture, out int number) ? number : 0).ToArray();
            return numbers.Length == 2 && numbers.All(number => number > 0 && number <= 16384) ? (numbers[0], numbers[1])
                : throw new HostException($"--size {text}: give width x height, 1 to 16384 each, as in 1920x1080.");
        }

        static void Execute(int[] counts, (int Width, int Height)[] sizes, (string Name, Action<FluidSurface> Set)[] rows, SurfaceQuality quality,
            int foam, (string Name, int First, int Last) window, string csv, TextWriter output)
        {
            using var session = new Session(Session.Root());
            var table = new ReportTable("particles", "window", "size", "eyes", "row", "sample", "median_ms", "p10_ms", "p90_ms", "frames")
            {
                MeasuredOn = session.DescribeDevice(),
            };
            output.WriteLine(session.DescribeDevice());
            output.WriteLine($"a dam that breaks over a floor, a shadow map, {quality}; frames {window.First} to {window.Last}, a step in each");
            if (session.Info.IsSoftware)
                output.WriteLine("This device is a CPU: the figures say nothing about a GPU.");
            foreach (int count in counts)
                foreach ((int width, int height) in sizes)
                {
                    ExperimentScene scene = ExperimentScene.Dam(count);
                    output.WriteLine();
                    output.WriteLine(string.Create(CultureInfo.InvariantCulture,
                        $"{scene.Particles:N0} particles, {window.Name}, {width} x {height}{(Player.Stereo ? " for each of two eyes" : "")}"));
                    output.WriteLine($"{"",-40}{"median ms",12}{"10 %",10}{"90 %",10}");
                    foreach ((string name, Action<FluidSurface> set) in rows)
                    {
                        output.WriteLine(name);
                        foreach ((string sample, StepTimes.Spread time) in Measure(scene, set, quality, foam, width, height, window))
                        {
                            output.WriteLine(string.Create(CultureInfo.InvariantCulture,
                                $"  {sample,-38}{time.Median,12:0.0000}{time.Low,10:0.0000}{time.High,10:0.0000}"));
                            table.Add(scene.Particles, window.Name, $"{width}x{height}", Player.Stereo ? 2 : 1, name, sample, time.Median, time.Low,
                                time.High, time.Count);
                        }
                    }
                }
            if (csv != null)
                table.Save(Path.GetFullPath(csv));
        }

        // The water's own samples, the camera and the whole, in this order.
        static IEnumerable<(string Name, StepTimes.Spread Time)> Measure(ExperimentScene scene, Action<FluidSurface> set, SurfaceQuality quality,
            int foam, int width, int height, (string Name, int First, int Last) window)
        {
            var made = new List<Object>();
            var times = new SortedDictionary<string, List<double>>(StringComparer.Ordinal);
            List<double> drawn = new List<double>(), all = new List<double>();
            IGraphicsDevice device = Player.Device;
            Camera.CameraCallback begin = _ => device.BeginSample(CameraSample), end = _ => device.EndSample();
            Camera.onPreCull += begin;
            Camera.onPostRender += end;
            try
            {
                FluidSimulation fluid = Make(scene, set, quality, foam, width, height, made);
                for (int frame = 1; frame <= window.Last; frame++)
                {
                    device.Timing = frame >= window.First;
                    PlayerLoop.Frame(FrameTime);
                    device.Timing = false;
                    if (frame < window.First)
                        continue;
                    IReadOnlyList<DeviceSample> samples = device.CollectSamples();
                    drawn.Add(samples.Where(sample => sample.Name == CameraSample).Sum(sample => sample.Milliseconds));
                    all.Add(samples.Where(sample => sample.Depth == 0).Sum(sample => sample.Milliseconds));
                    foreach (IGrouping<string, DeviceSample> stage in samples.Where(IsOfSurface).GroupBy(sample => sample.Name))
                    {
                        if (!times.TryGetValue(stage.Key, out List<double> list))
                            times[stage.Key] = list = new List<double>();
                        list.Add(stage.Sum(sample => sample.Milliseconds));
                    }
                }
                device.WaitIdle();
            }
            finally
            {
                Camera.onPreCull -= begin;
                Camera.onPostRender -= end;
                made.ForEach(Object.DestroyImmediate);
            }
            return times.Select(pair => (pair.Key, StepTimes.Spread.Of(pair.Value)))
                .Append((CameraSample, StepTimes.Spread.Of(drawn))).Append(("all samples", StepTimes.Spread.Of(all)));
        }

        static bool IsOfSurface(DeviceSample sample) => sample.Name.StartsWith("Rill.Surface", StringComparison.Ordinal)
            || sample.Name.StartsWith("Rill.Caustics", StringComparison.Ordinal)
            || sample.Name.StartsWith("Rill.Water", StringComparison.Ordinal) || sample.Name == "Rill.Mesh" || sample.Name == "Rill.Foam";

        static FluidSimulation Make(ExperimentScene scene, Action<FluidSurface> set, SurfaceQuality quality, int foam, int width, int height,
            List<Object> made)
        {
            Vector3 domain = scene.Domain;
            GameObject floor = GameObject.CreatePrimitive(PrimitiveType.Plane);
            floor.transform.position = new Vector3(0f, -0.5f * domain.y, 0f);
            made.Add(floor);
            if (Player.Stereo)      // the stand-in for Unity's Standard shader takes no shadows for two eyes
            {
                var solid = new Material(Shader.Find("Rill/Solid"));
                made.Add(solid);
                floor.GetComponent<MeshRenderer>().sharedMaterial = solid;
            }
            var sun = new GameObject("Sun").AddComponent<Light>();
            sun.type = LightType.Directional;
            sun.shadows = LightShadows.Soft;
            sun.transform.rotation = Quaternion.Euler(50f, -30f, 0f);
            made.Add(sun.gameObject);
            var camera = new GameObject("Camera").AddComponent<Camera>();
            if (Player.Stereo)
                (Player.ScreenWidth, Player.ScreenHeight) = (2 * width, height);
            else
                made.Add(camera.targetTexture = new RenderTexture(width, height, 24));
            camera.fieldOfView = FieldOfView;
            float distance = 0.5f * domain.magnitude / Mathf.Tan(0.5f * FieldOfView * Mathf.Deg2Rad);
            Vector3 from = new Vector3(0.35f, 0.35f, -0.87f).normalized * distance;
            camera.transform.SetPositionAndRotation(from, Quaternion.LookRotation(-from));
            made.Insert(0, camera.gameObject);      // before its texture

            var box = new GameObject("Fluid");
            box.SetActive(false);
            made.Add(box);
            var fluid = box.AddComponent<FluidSimulation>();
            fluid.Configure(domain, scene.Spacing, scene.Particles);
            fluid.StatisticsInterval = 0;
            if (set != null)
            {
                var surface = box.AddComponent<FluidSurface>();
                surface.Quality = quality;
                surface.Sun = sun;
                set(surface);
                if (foam > 0)
                    box.AddComponent<FluidFoam>().Settings = FoamBench.FillOf(scene, foam);
            }
            box.SetActive(true);
            scene.Fill(fluid.Solver);
            return fluid;
        }
    }
}
