using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using Host.Baking;
using Host.Commands;
using Host.Experiments;
using Rill;
using Spectre.Console;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace Host.Bench
{
    /// <summary><c>bench</c>: GPU time of the solver's step, by stage, over windows of a breaking dam.</summary>
    static class BenchCommand
    {
        public static Command Create()
        {
            var particles = new Option<int>("--particles") { Description = "Particles; the block's lattice comes as near as it can.",
                DefaultValueFactory = _ => 100_000 };
            var iterations = new Option<int>("--iterations") { Description = "Iterations of a substep.",
                DefaultValueFactory = _ => SolverSettings.Default.iterations };
            var substeps = new Option<int>("--substeps") { Description = "Substeps of a step.",
                DefaultValueFactory = _ => SolverSettings.Default.substeps };
            var relaxation = new Option<float>("--relaxation") { Description = "Relaxation.",
                DefaultValueFactory = _ => SolverSettings.Default.relaxation };
            var neighbors = new Option<int>("--neighbors") { Description = "Entries of a neighbor list.",
                DefaultValueFactory = _ => SolverSettings.Default.neighborCapacity };
            var smoothing = new Option<float>("--smoothing") { Description = "Velocity smoothing, XSPH.",
                DefaultValueFactory = _ => FluidMaterial.Water.velocitySmoothing };
            var viscosity = new Option<float>("--dynamic-viscosity") { Description = "Pa s; 0 for none.",
                DefaultValueFactory = _ => FluidMaterial.Water.dynamicViscosity };
            var shearModulus = new Option<float>("--shear-modulus") { Description = "Of an elastic fluid, Pa; 0 for none.",
                DefaultValueFactory = _ => FluidMaterial.Water.shearModulus };
            var friction = new Option<float>("--friction-angle") { Description = "Of grains, degrees; 0 for a liquid.",
                DefaultValueFactory = _ => FluidMaterial.Water.frictionAngle };
            var contacts = new Option<bool>("--contacts") { Description = "Loose balls instead of a liquid." };
            var densityRatio = new Option<float>("--density-ratio") {
                Description = "The upper half is a liquid that is lighter by this factor; 1 for one liquid.", DefaultValueFactory = _ => 1f };
            var diffusion = new Option<float>("--diffusion") { Description = "With which the halves mix, m²/s; 0 for none.",
                DefaultValueFactory = _ => 0f };
            var smoke = new Option<float>("--smoke") { Description = "Side of a cell of the air with smoke over it, d; 0 for none.",
                DefaultValueFactory = _ => 0f };
            var deepWater = new Option<DeepWater>("--deep-water") { Description = "automatic, on or off.",
                DefaultValueFactory = _ => SolverSettings.Default.deepWater };
            var window = new Option<string>("--window") { Description = "initial, moving or all.", DefaultValueFactory = _ => "all" };
            var steps = new Option<int>("--steps") { Description = $"Steps measured in a window, at least {StepTimes.MinSteps}.",
                DefaultValueFactory = _ => StepTimes.MinSteps };
            Option<bool> kernels = KernelsOption.Create();
            var json = new Option<string>("--json") { Description = "Also write the figures to this file." };

            Option<string> shaders = ShadersOption.Create();

            var command = new Command("bench", "Measures GPU milliseconds of the solver's step by stage.") { particles, iterations,
                substeps, relaxation, neighbors, smoothing, viscosity, shearModulus, friction, contacts, densityRatio, diffusion, smoke, deepWater,
                window, steps, kernels, json, shaders,
                BakeBenchCommand.Create(), CollidersBench.Create(), FieldsBench.Create(), FoamBench.Create(), GameBench.Create(),
                PictureBench.Create(), QueriesBench.Create(), RecordingBench.Create(),
                SurfaceBench.Create() };
            command.SetAction(parsed =>
            {
                ShadersOption.Use(parsed.GetValue(shaders));
                KernelsOption.Use(parsed.GetValue(kernels));
                SolverSettings settings = SolverSettings.Default;
                settings.iterations = parsed.GetValue(iterations);
                settings.substeps = parsed.GetValue(substeps);
                settings.relaxation = parsed.GetValue(relaxation);
                settings.deepWater = parsed.GetValue(deepWater);
                settings.neighborCapacity = parsed.GetValue(neighbors);
                FluidMaterial material = FluidMaterial.Water;
                material.velocitySmoothing = parsed.GetValue(smoothing);
                material.dynamicViscosity = parsed.GetValue(viscosity);
                material.frictionAngle = parsed.GetValue(friction);
                material.contacts = parsed.GetValue(contacts);
                material.shearModulus = parsed.GetValue(shearModulus);
                if (!settings.Validate(out string problem) | !material.Validate(out string materialProblem))
                    System.Console.Error.WriteLine($"rill: bench: {problem} {materialProblem}".TrimEnd());
                GivenNumber.CheckOption("--particles", parsed.GetValue(particles), ExperimentScene.MinDamParticles, SolverLayout.MaxCapacity);
                if (parsed.GetValue(steps) < StepTimes.MinSteps)
                    throw new HostException($"--steps {parsed.GetValue(steps)}: a median needs at least {StepTimes.MinSteps}.");
                var windows = StepTimes.Windows.Where(w => parsed.GetValue(window) == "all" || parsed.GetValue(window) == w.Name).ToList();
                if (windows.Count == 0)
                    throw new HostException(
                        $"--window {parsed.GetValue(window)}: give {string.Join(", ", StepTimes.Windows.Select(w => w.Name))} or all.");

                var scene = ExperimentScene.Dam(parsed.GetValue(particles));
                var input = ExperimentFigures.Input(settings, material);
                float ratio = parsed.GetValue(densityRatio);
                if (!(ratio >= 1f) || ratio > PhaseMaterials.MaxRatio)
                    throw new HostException($"--density-ratio {ratio}: give 1 to {PhaseMaterials.MaxRatio}.");
                float mixing = parsed.GetValue(diffusion);
                if (!(mixing >= 0f) || mixing > FluidMaterialPair.MaxDiffusion)
                    throw new HostException($"--diffusion {mixing}: give 0 to {FluidMaterialPair.MaxDiffusion} m²/s.");
                if (ratio > 1f || mixing > 0f)
                    input.phases.Set(1, material.density / ratio, material.dynamicViscosity);
                if (mixing > 0f)
                    input.phases.SetPair(0, 1, mixing);
                float cell = parsed.GetValue(smoke);
                if (!(cell >= 0f) || cell > 10f)
                    throw new HostException($"--smoke {cell}: give 0 to 10 d.");
                input.hasSmoke = cell > 0f;
                input.smoke = SmokeSettings.Default;
                input.smoke.cellSize = cell * scene.Spacing;
                input.smoke.steam = 5f;
                return Execute(scene, input, windows, parsed.GetValue(steps), parsed.GetValue(json), System.Console.Out);
            });
            return command;
        }

        static void Fill(PbfSolver solver, ExperimentScene scene, bool hasMaterials)
        {
            if (!hasMaterials)
            {
                scene.Fill(solver);
                return;
            }
            float surface = 0.5f * scene.Layers * scene.Spacing;
            foreach (int phase in new[] { 0, 1 })
                scene.Fill((positions, velocities) =>
                {
                    float4[] own = positions.ToArray().Where(p => (p.y > surface ? 1 : 0) == phase).Select(p => p / scene.Spacing).ToArray();
                    using var of = new NativeArray<float4>(own, Allocator.Persistent);
                    using var still = new NativeArray<float4>(1, Allocator.Persistent);
                    solver.AddInSpacings(of, still, 0f, scene.Box, solver.TagFor(phase, 0));
                });
        }

        static int Execute(ExperimentScene scene, StepInput input, List<(string, int, int)> windows, int steps, string json, TextWriter output)
        {
            using var session = new Session(Session.Root());
            string setting = string.Create(CultureInfo.InvariantCulture, $"{scene.Particles:N0} particles ({scene.Blocks[0].counts.x} " +
                $"x {scene.Blocks[0].counts.y} x {scene.Blocks[0].counts.z}, d = {scene.Spacing:0.#####} m, h = 2 d), " +
                $"{input.settings.substeps} substeps x {input.settings.iterations} iterations, relaxation {input.settings.relaxation}, " +
                $"velocity smoothing {input.material.velocitySmoothing}, viscosity {input.material.dynamicViscosity} Pa s, shear " +
                $"modulus {input.material.shearModulus} Pa, contacts {(input.material.contacts ? "on" : "off")}, " +
                $"deep water {input.settings.deepWater}, density ratio {input.phases.Ratio(input.material)}, " +
                $"diffusion {input.phases.MaxDiffusion} m²/s, " +
                $"smoke {(input.hasSmoke ? $"in cells of {input.smoke.cellSize / scene.Spacing} d" : "off")}, " +
                $"{input.settings.neighborCapacity} list entries");
            output.WriteLine(session.DescribeDevice());
            output.WriteLine(setting);
            if (session.Info.IsSoftware)
                output.WriteLine("This device is a CPU: the figures say nothing about a GPU.");

            var results = new Dictionary<string, Dictionary<string, StepTimes.Spread>>();
            long bytes;
            using (var solver = new PbfSolver(new SolverLayout(scene.Domain, scene.Spacing, scene.Particles,
                input.settings.neighborCapacity, input.settings.listMargin)))
            {
                foreach ((string name, int first, int last) in windows)
                    results[name] = StepTimes.Measure(solver, s => Fill(s, scene, input.phases.Last > 0), input, first, last, steps);
                bytes = solver.Describe(input, 0).Sum(stage => stage.Bytes);
            }

            Print(results, output);
            output.WriteLine(string.Create(CultureInfo.InvariantCulture,
                $"memory: {bytes / 1048576.0:N1} MiB, {bytes / (double)scene.Particles:0} bytes a particle"));
            if (json != null)
                File.WriteAllText(json, Json(session, scene, input, results, bytes));
            return 0;
        }

        static void Print(Dictionary<string, Dictionary<string, StepTimes.Spread>> results, TextWriter output)
        {
            foreach ((string window, Dictionary<string, StepTimes.Spread> stages) in results)
            {
                double whole = stages["step"].Median;
                output.WriteLine();
                output.WriteLine($"{window,-32}{"median ms",12}{"10 %",10}{"90 %",10}{"fraction",10}   of {stages["step"].Count} steps");
                foreach ((string stage, StepTimes.Spread spread) in stages.OrderBy(pair => pair.Key == "step"))
                    output.WriteLine(string.Create(CultureInfo.InvariantCulture,
                        $"{stage,-32}{spread.Median,12:0.0000}{spread.Low,10:0.0000}{spread.High,10:0.0000}{spread.Median / whole,10:0.0 %}"));
            }
            output.WriteLine();
        }

        static string Json(Session session, ExperimentScene scene, in StepInput input, Dictionary<string, Dictionary<string,
            StepTimes.Spread>> results, long bytes)
        {
            return JsonSerializer.Serialize(new
            {
                device = session.Info.Name,
                driver = session.Info.Driver,
                api = session.Info.Api,
                software = session.Info.IsSoftware,
                particles = scene.Particles,
                lattice = new[] { scene.Blocks[0].counts.x, scene.Blocks[0].counts.y, scene.Blocks[0].counts.z },
                spacing_m = scene.Spacing,
                substeps = input.settings.substeps,
                iterations = input.settings.iterations,
                relaxation = input.settings.relaxation,
                smoothing = input.material.velocitySmoothing,
                deep_water = input.settings.deepWater.ToString(),
                neighbor_capacity = input.settings.neighborCapacity,
                bytes,
                milliseconds = results.ToDictionary(window => window.Key,
                    window => window.Value.ToDictionary(stage => stage.Key,
                    stage => new { median = stage.Value.Median, p10 = stage.Value.Low, p90 = stage.Value.High,
                    steps = stage.Value.Count })),
            }, new JsonSerializerOptions { WriteIndented = true });
        }
    }
}
