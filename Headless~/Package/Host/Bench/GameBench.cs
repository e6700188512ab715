using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Diagnostics;
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
    /// <c>bench game</c>: what the parts by which a game talks to its water add to a frame with one step, over a dam that breaks:
    /// each alone and all together, as components.
    /// </summary>
    static class GameBench
    {
        const int First = 20;       // frames before those that are measured
        const int WarmUpFrames = 1000;      // a GPU raises its clock under steady load
        const float FrameTime = 1f / 60f;
        const int Bodies = 8, Contacts = 16;

        [Flags]
        enum Parts
        {
            None = 0, Queries = 1, Colliders = 2, Contacts = 4, Bodies = 8, Recorder = 16, Particles = 32, Wait = 64,
            All = Queries | Colliders | Contacts | Bodies | Recorder | Particles,
        }

        // Contacts need the colliders that they are of: their cost is the difference to the row before. A GPU that waits for a main thread lowers its
        // clock: a frame without anything that lasts as long as that of the row before tells how much of a cost that is.
        static readonly (string Name, Parts Parts)[] Rows =
        {
            ("all off", Parts.None), ("probes and detectors", Parts.Queries), ("colliders", Parts.Colliders),
            ("colliders and contacts", Parts.Colliders | Parts.Contacts), ("floating bodies", Parts.Bodies), ("recorder", Parts.Recorder),
            ("particle requests", Parts.Particles), ("nothing but the wait", Parts.Wait), ("all on", Parts.All), ("all off again", Parts.None),
        };

        public static Command Create()
        {
            var particles = new Option<int[]>("--particles") {
                Description = "Particles of the fluid; the block's lattice comes as near as it can.",
                DefaultValueFactory = _ => new[] { 100_000, 1_000_000 }, AllowMultipleArgumentsPerToken = true };
            var frames = new Option<int>("--frames") { Description = $"Frames measured of each, at least {StepTimes.MinSteps}.",
                DefaultValueFactory = _ => StepTimes.MinSteps };
            Option<bool> kernels = KernelsOption.Create();
            var csv = new Option<string>("--csv") { Description = "Also write the figures to this file." };
            Option<string> shaders = ShadersOption.Create();
            var command = new Command("game", "Measures what probes, contacts, floating bodies, recorder and requests add to a frame.") {
                particles, frames, kernels, csv, shaders };
            command.SetAction(parsed =>
            {
                ShadersOption.Use(parsed.GetValue(shaders));
                KernelsOption.Use(parsed.GetValue(kernels));
                foreach (int count in parsed.GetValue(particles))
                    GivenNumber.CheckOption("--particles", count, ExperimentScene.MinDamParticles, SolverLayout.MaxCapacity);
                if (parsed.GetValue(frames) < StepTimes.MinSteps)
                    throw new HostException($"--frames {parsed.GetValue(frames)}: a median needs at least {StepTimes.MinSteps}.");
                Execute(parsed.GetValue(particles), parsed.GetValue(frames), parsed.GetValue(csv), Console.Out);
                return 0;
            });
            return command;
        }

        static void Execute(int[] counts, int frames, string csv, TextWriter output)
        {
            using var session = new Session(Session.Root());
            var table = new ReportTable("particles", "parts", "gpu_ms", "gpu_p10_ms", "gpu_p90_ms", "cpu_ms", "frames")
            {
                MeasuredOn = session.DescribeDevice(),
            };
            output.WriteLine(session.DescribeDevice());
            output.WriteLine($"{Queries.MaxProbes} probes and {Queries.MaxDetectors} detectors; {Contacts} boxes; {Bodies} balls that float; " +
                $"all fields recorded and requested each frame; frames {First + 1} to {First + frames}, a step in each");
            if (session.Info.IsSoftware)
                output.WriteLine("This device is a CPU: the figures say nothing about a GPU.");
            foreach (int count in counts)
            {
                ExperimentScene scene = ExperimentScene.Dam(count);
                output.WriteLine();
                output.WriteLine(string.Create(CultureInfo.InvariantCulture,
                    $"{scene.Particles:N0} particles, d = {scene.Spacing:0.#####} m"));
                output.WriteLine($"{"",-24}{"GPU ms",10}{"10 %",10}{"90 %",10}{"over off",10}{"CPU ms",10}");
                if (!session.Info.IsSoftware)
                    Measure(scene, Parts.None, 0.0, WarmUpFrames, null, output);
                double off = double.NaN, before = 0.0;
                foreach ((string name, Parts parts) in Rows)
                {
                    var stages = Player.TimesKernels ? new Dictionary<string, List<double>>() : null;
                    (StepTimes.Spread gpu, StepTimes.Spread cpu) = Measure(scene, parts, before, frames, stages, output);
                    before = cpu.Median;
                    off = double.IsNaN(off) ? gpu.Median : off;
                    output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{name,-24}{gpu.Median,10:0.0000}" +
                        $"{gpu.Low,10:0.0000}{gpu.High,10:0.0000}{gpu.Median - off,10:0.0000}{cpu.Median,10:0.000}"));
                    table.Add(scene.Particles, name, gpu.Median, gpu.Low, gpu.High, cpu.Median, gpu.Count);
                    foreach ((string stage, List<double> times) in stages ?? new Dictionary<string, List<double>>())
                        output.WriteLine(string.Create(CultureInfo.InvariantCulture,
                            $"  {stage,-54}{StepTimes.Spread.Of(times).Median,10:0.0000}"));
                }
            }
            if (csv != null)
                table.Save(Path.GetFullPath(csv));
        }

        // least: ms that a frame lasts with Parts.Wait.
        static (StepTimes.Spread Gpu, StepTimes.Spread Cpu) Measure(ExperimentScene scene, Parts parts, double least, int frames,
            Dictionary<string, List<double>> stages, TextWriter output)
        {
            string file = Path.Combine(Path.GetTempPath(), $"rill-bench-{Guid.NewGuid():N}.rillrec");
            var readback = new ParticleReadback();
            var made = new List<GameObject>();
            List<double> gpu = new List<double>(), cpu = new List<double>();
            IGraphicsDevice device = Player.Device;
            try
            {
                FluidSimulation fluid = Make(scene, parts, made);
                if ((parts & Parts.Recorder) != 0)
                    fluid.GetComponent<FluidRecorder>().Record(file);
                for (int frame = 0; frame < First + frames; frame++)
                {
                    if ((parts & Parts.Particles) != 0)
                        fluid.RequestParticles(readback, ParticleFields.All);
                    device.Timing = frame >= First;
                    var watch = Stopwatch.StartNew();
                    PlayerLoop.Frame(FrameTime);
                    while ((parts & Parts.Wait) != 0 && watch.Elapsed.TotalMilliseconds < least)
                        continue;
                    double passed = watch.Elapsed.TotalMilliseconds;
                    device.Timing = false;
                    if (frame < First)
                        continue;
                    cpu.Add(passed);
                    IReadOnlyList<DeviceSample> samples = device.CollectSamples();
                    gpu.Add(samples.Where(sample => sample.Depth == 0).Sum(sample => sample.Milliseconds));
                    if (stages != null)
                        Add(stages, samples);
                }
                device.WaitIdle();
                FluidRecorder recorder = fluid.GetComponent<FluidRecorder>();
                if (recorder != null && !recorder.IsRecording)
                    output.WriteLine("The recorder stopped before the end, since frames follow each other without a pause here: what it adds " +
                        "is not in the next row. See rill bench recording.");
            }
            finally
            {
                readback.Dispose();
                made.ForEach(Object.DestroyImmediate);
                File.Delete(file);
            }
            return (StepTimes.Spread.Of(gpu), StepTimes.Spread.Of(cpu));
        }

        static void Add(Dictionary<string, List<double>> stages, IReadOnlyList<DeviceSample> samples)
        {
            foreach (IGrouping<string, DeviceSample> stage in samples.GroupBy(sample => sample.Name))
            {
                if (!stages.TryGetValue(stage.Key, out List<double> times))
                    stages[stage.Key] = times = new List<double>();
                times.Add(stage.Sum(sample => sample.Milliseconds));
            }
        }

        static FluidSimulation Make(ExperimentScene scene, Parts parts, List<GameObject> made)
        {
            GameObject box = Make(made, "Fluid", Vector3.zero);
            var fluid = box.AddComponent<FluidSimulation>();
            fluid.Configure(scene.Domain, scene.Spacing, scene.Particles);
            fluid.StatisticsInterval = 0;
            if ((parts & Parts.Recorder) != 0)
                box.AddComponent<FluidRecorder>();
            if ((parts & Parts.Queries) != 0)
            {
                for (int i = 0; i < Queries.MaxProbes; i++)
                    Add<FluidProbe>(box, OnFloor(scene, i, Queries.MaxProbes, 0.3f));
                for (int i = 0; i < Queries.MaxDetectors; i++)
                    Add<FluidDetector>(box, OnFloor(scene, i, Queries.MaxDetectors, 0.3f)).Size = (Vector3)(scene.Domain / 6f);
            }
            float ball = 0.1f * scene.Domain.y;
            if ((parts & (Parts.Colliders | Parts.Contacts)) != 0)
                for (int i = 0; i < Contacts; i++)
                {
                    var collider = Add<FluidCollider>(Make(made, "Box", Vector3.zero), OnFloor(scene, i, Contacts, 0.05f));
                    collider.Shape = ColliderShape.Box;
                    collider.Size = 0.5f * ball * Vector3.one;
                    if ((parts & Parts.Contacts) != 0)
                        collider.OnHit += _ => { };
                }
            if ((parts & Parts.Bodies) != 0)
                for (int i = 0; i < Bodies; i++)
                    MakeBall(Make(made, "Ball", OnFloor(scene, i, Bodies, 0.55f)), ball);
            made.ForEach(thing => thing.SetActive(true));
            scene.Fill(fluid.Solver);
            return fluid;
        }

        static void MakeBall(GameObject thing, float size)
        {
            var collider = thing.AddComponent<FluidCollider>();
            collider.Shape = ColliderShape.Sphere;
            collider.Radius = 0.5f * size;
            thing.AddComponent<Rigidbody>().mass = 500f * Mathf.PI / 6f * size * size * size;
            thing.AddComponent<FluidBuoyancy>();
        }

        // Evenly over the floor of the box, at a fraction of its height; the box stands around the origin.
        static Vector3 OnFloor(ExperimentScene scene, int index, int count, float height)
        {
            int rows = Mathf.CeilToInt(Mathf.Sqrt(count / 2f)), columns = (count + rows - 1) / rows;
            float x = (index % columns + 0.5f) / columns, z = (index / columns + 0.5f) / rows;
            return Vector3.Scale(new Vector3(x - 0.5f, height - 0.5f, z - 0.5f), scene.Domain);
        }

        static T Add<T>(GameObject parent, Vector3 at) where T : Component
        {
            var thing = new GameObject(typeof(T).Name);
            thing.transform.SetParent(parent.transform, false);
            thing.transform.localPosition = at;
            return thing.AddComponent<T>();
        }

        static GameObject Make(List<GameObject> made, string name, Vector3 at)
        {
            var thing = new GameObject(name);
            thing.SetActive(false);
            thing.transform.position = at;
            made.Add(thing);
            return thing;
        }
    }
}
