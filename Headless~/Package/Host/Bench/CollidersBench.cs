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
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace Host.Bench
{
    /// <summary><c>bench colliders</c>: what colliders add to the GPU time of the solver's step, by stage and number of them, without and
    /// with their forces.</summary>
    static class CollidersBench
    {
        const float WaterFraction = 0.03f;       // of the block's volume that the most colliders take
        const float MinRadius = 1.5f;         // d
        const float Voxel = 0.5f;               // d
        const string With = "in pairs: step", Without = "the same water without";
        static readonly (string Name, int First, int Last)[] Windows = StepTimes.Windows.Append(StepTimes.Settled).ToArray();
        static readonly ColliderShape[] Mixed = { ColliderShape.Sphere, ColliderShape.Box, ColliderShape.Capsule, ColliderShape.Mesh };

        public static Command Create()
        {
            var particles = new Option<int>("--particles") {
                Description = "Particles; the block's lattice comes as near as it can. 1000000 is what a GPU is asked for.",
                DefaultValueFactory = _ => 100_000 };
            var counts = new Option<int[]>("--counts") { Description = $"Numbers of colliders, 0 to {ColliderSet.MaxCount}.",
                DefaultValueFactory = _ => new[] { 0, 1, 16, ColliderSet.MaxCount }, AllowMultipleArgumentsPerToken = true };
            var shape = new Option<string>("--shape") {
                Description = "sphere, box, capsule, mesh (the field of a ball), or mixed: these in turn.", DefaultValueFactory = _
                => "mixed" };
            var iterations = new Option<int>("--iterations") { Description = "Iterations of a substep.",
                DefaultValueFactory = _ => SolverSettings.Default.iterations };
            var substeps = new Option<int>("--substeps") { Description = "Substeps of a step.",
                DefaultValueFactory = _ => SolverSettings.Default.substeps };
            var deepWater = new Option<DeepWater>("--deep-water") { Description = "automatic, on or off.",
                DefaultValueFactory = _ => SolverSettings.Default.deepWater };
            var window = new Option<string>("--window") { Description = $"{string.Join(" or ", Windows.Select(w => w.Name))}.",
                DefaultValueFactory = _ => Windows[0].Name };
            var steps = new Option<int>("--steps") { Description = $"Steps measured of each, at least {StepTimes.MinSteps}.",
                DefaultValueFactory = _ => StepTimes.MinSteps };
            Option<bool> kernels = KernelsOption.Create();
            var csv = new Option<string>("--csv") { Description = "Also write the figures to this file." };
            Option<string> shaders = ShadersOption.Create();
            var command = new Command("colliders", "Measures GPU milliseconds of the step among colliders, by stage.") { particles, counts,
                shape, iterations, substeps, deepWater, window, steps, kernels, csv, shaders };
            command.SetAction(parsed =>
            {
                ShadersOption.Use(parsed.GetValue(shaders));
                KernelsOption.Use(parsed.GetValue(kernels));
                SolverSettings settings = SolverSettings.Default;
                settings.iterations = parsed.GetValue(iterations);
                settings.substeps = parsed.GetValue(substeps);
                settings.deepWater = parsed.GetValue(deepWater);
                if (!settings.Validate(out string problem))
                    Console.Error.WriteLine($"rill: bench: {problem}");
                ColliderShape[] shapes = parsed.GetValue(shape) == "mixed" ? Mixed
                    : Enum.TryParse(parsed.GetValue(shape), true, out ColliderShape one) && Mixed.Contains(one) ? new[] { one }
                    : throw new HostException($"--shape {parsed.GetValue(shape)}: give sphere, box, capsule, mesh or mixed.");
                GivenNumber.CheckOption("--particles", parsed.GetValue(particles), ExperimentScene.MinDamParticles, SolverLayout.MaxCapacity);
                if (parsed.GetValue(counts).Any(count => count < 0 || count > ColliderSet.MaxCount))
                    throw new HostException($"--counts {string.Join(" ", parsed.GetValue(counts))}: give 0 to {ColliderSet.MaxCount}.");
                if (parsed.GetValue(steps) < StepTimes.MinSteps)
                    throw new HostException($"--steps {parsed.GetValue(steps)}: a median needs at least {StepTimes.MinSteps}.");
                (string Name, int First, int Last) played = Windows.FirstOrDefault(w => w.Name == parsed.GetValue(window));
                if (played.Name == null)
                    throw new HostException($"--window {parsed.GetValue(window)}: give {string.Join(" or ", Windows.Select(w => w.Name))}.");
                Execute(parsed.GetValue(particles), parsed.GetValue(counts), shapes, settings, played, parsed.GetValue(steps),
                    parsed.GetValue(csv), Console.Out);
                return 0;
            });
            return command;
        }

        static void Execute(int particles, int[] counts, ColliderShape[] shapes, SolverSettings settings,
            (string Name, int First, int Last) window, int steps, string csv, TextWriter output)
        {
            using var session = new Session(Session.Root());
            ExperimentScene scene = ExperimentScene.Dam(particles);
            int3 lattice = scene.Blocks[0].counts;
            float radius = math.max(math.pow(WaterFraction * scene.Particles / (ColliderSet.MaxCount * 4f / 3f * math.PI), 1f / 3f), MinRadius);
            string setting = string.Create(CultureInfo.InvariantCulture, $"{scene.Particles:N0} particles (a dam of {lattice.x} x " +
                $"{lattice.y} x {lattice.z} and as many layers more as colliders take room; d = {scene.Spacing:0.#####} m), " +
                $"{settings.substeps} substeps x {settings.iterations} iterations, deep water {settings.deepWater}, steps " +
                $"{window.First} to {window.Last}; colliders at rest in the water, {string.Join(", ", shapes)} of radius {radius:0.0} d");
            output.WriteLine(session.DescribeDevice());
            output.WriteLine(setting);
            if (session.Info.IsSoftware)
                output.WriteLine("This device is a CPU: the figures say nothing about a GPU.");

            Texture3D ball = shapes.Contains(ColliderShape.Mesh) ? Ball(radius) : null;
            var runs = new List<(int Count, bool Forces, Dictionary<string, StepTimes.Spread> Times)>();
            foreach (bool forces in new[] { false, true })
                foreach (int count in counts.Where(count => count > 0 || !forces))
                {
                    ColliderMotion[] colliders = Colliders(count, shapes, lattice, radius, forces, ball);
                    runs.Add((count, forces, Measure(scene, colliders, radius, settings, window, steps)));
                }
            Object.DestroyImmediate(ball);
            Print(runs, output);
            if (csv == null)
                return;
            var table = new ReportTable("particles", "colliders", "forces", "stage", "median_ms", "p10_ms", "p90_ms",
                "steps") { MeasuredOn = $"{session.DescribeDevice()}; {setting}" };
            foreach ((int count, bool forces, Dictionary<string, StepTimes.Spread> times) in runs)
                foreach ((string stage, StepTimes.Spread spread) in times)
                    table.Add(scene.Particles, count, forces, stage, spread.Median, spread.Low, spread.High, spread.Count);
            table.Save(Path.GetFullPath(csv));
        }

        static Dictionary<string, StepTimes.Spread> Measure(ExperimentScene scene, ColliderMotion[] colliders, float radius,
            SolverSettings settings, (string, int First, int Last) window, int steps)
        {
            StepInput input = ExperimentFigures.Input(settings);
            if (colliders.Length > 0)
            {
                input.colliders = new ColliderSet { Count = colliders.Length, Version = 1, Order = 1 };
                colliders.CopyTo(input.colliders.Items, 0);
                input.frameTo = 1f;
            }
            using NativeArray<float4> positions = Water(scene, colliders, radius);
            using var velocities = new NativeArray<float4>(positions.Length, Allocator.Persistent);
            using var solver = new PbfSolver(scene.LayoutFor(settings));
            NativeArray<float4> points = positions, speeds = velocities;
            Dictionary<string, StepTimes.Spread> Play(Action before)
                => StepTimes.Measure(solver, s => s.Add(points, speeds), input, window.First, window.Last, steps,
                cmd => solver.Reactions?.RecordTake(cmd), before);
            Dictionary<string, StepTimes.Spread> times = Play(null);
            if (colliders.Length == 0)
                return times;
            // Apart from the stages: a GPU that waits for the copies may lower its clock, for both of a pair.
            using var without = new SameWater(scene.LayoutFor(settings), input, positions, velocities);
            times[With] = Play(() => without.Time(solver))[StepTimes.Step];
            times[Without] = without.Times;
            return times;
        }

        // Evenly through the dam, each turned differently.
        static ColliderMotion[] Colliders(int count, ColliderShape[] shapes, int3 lattice, float radius, bool forces, Texture3D ball)
        {
            var colliders = new ColliderMotion[count];
            int along = (int)math.ceil(math.pow(count, 1f / 3f) - 1e-3f);
            var random = new Unity.Mathematics.Random(3);
            for (int i = 0; i < count; i++)
            {
                ColliderShape shape = shapes[i % shapes.Length];
                var cell = new int3(i % along, i / along % along, i / (along * along));
                var pose = new RigidPose(((float3)cell + 0.5f) / along * lattice, random.NextQuaternionRotation());
                colliders[i] = new ColliderMotion
                {
                    shape = shape,
                    // All have about the same volume.
                    size = shape == ColliderShape.Box ? 0.8f * radius : shape == ColliderShape.Capsule
                        ? new float3(0.8f * radius, 0.64f * radius, 0f) : shape == ColliderShape.Mesh ? 0.5f * Voxel * FieldSide(radius)
                        : radius,
                    start = pose,
                    end = pose,
                    contributesDensity = true,
                    reacts = forces,
                    field = shape == ColliderShape.Mesh ? ball : null,
                    voxel = Voxel,
                    fieldUnit = 1f,
                };
            }
            return colliders;
        }

        // The dam's particles on its lattice where no collider is, from the floor up until there are as many.
        static NativeArray<float4> Water(ExperimentScene scene, ColliderMotion[] colliders, float radius)
        {
            int3 lattice = scene.Blocks[0].counts;
            var taken = new HashSet<int3>();
            foreach (ColliderMotion collider in colliders)
            {
                float reach = 1.5f * radius + 1f;       // a box's corners are the farthest
                int3 low = (int3)math.floor(collider.end.position - reach), high = (int3)math.ceil(collider.end.position + reach);
                for (int z = low.z; z <= high.z; z++)
                    for (int y = low.y; y <= high.y; y++)
                        for (int x = low.x; x <= high.x; x++)
                            if (Distance(collider, radius, new float3(x, y, z) + 0.5f) < 0.5f)
                                taken.Add(new int3(x, y, z));
            }
            var random = new Unity.Mathematics.Random(7);
            var positions = new NativeArray<float4>(scene.Particles, Allocator.Persistent);
            int filled = 0;
            for (int y = 0; filled < positions.Length; y++)
                for (int z = 0; z < lattice.z; z++)
                    for (int x = 0; x < lattice.x && filled < positions.Length; x++)
                        if (!taken.Contains(new int3(x, y, z)))
                            positions[filled++] = new float4((new float3(x, y, z) + 0.5f + random.NextFloat3(-0.02f, 0.02f)) * scene.Spacing, 0f);
            return positions;
        }

        static float Distance(in ColliderMotion collider, float radius, float3 p)
        {
            float3 local = math.mul(math.conjugate(collider.end.rotation), p - collider.end.position);
            switch (collider.shape)
            {
                case ColliderShape.Box:
                    float3 beyond = math.abs(local) - collider.size;
                    return math.length(math.max(beyond, 0f)) + math.min(math.cmax(beyond), 0f);
                case ColliderShape.Capsule:
                    return math.length(local - new float3(0f, math.clamp(local.y, -collider.size.y, collider.size.y), 0f)) - collider.size.x;
                default:
                    return math.length(local) - radius;
            }
        }

        // Side of the ball's field: three voxels around it.
        static int FieldSide(float radius) => (int)math.ceil(2f * radius / Voxel) + 6;

        static Texture3D Ball(float radius)
        {
            int side = FieldSide(radius);
            var distances = new float[side * side * side];
            for (int i = 0; i < distances.Length; i++)
                distances[i] = math.length((new float3(i % side, i / side % side, i / (side * side)) + 0.5f - 0.5f * side) * Voxel) - radius;
            var texture = new Texture3D(side, side, side, TextureFormat.RFloat, false);
            texture.SetPixelData(distances, 0);
            texture.Apply(false, false);
            return texture;
        }

        static void Print(List<(int Count, bool Forces, Dictionary<string, StepTimes.Spread> Times)> runs, TextWriter output)
        {
            string[] stages = runs.SelectMany(run => run.Times.Keys).Distinct()
                .OrderBy(stage => Array.IndexOf(new[] { StepTimes.Step, With, Without }, stage)).ToArray();
            int width = stages.Max(stage => stage.Length) + 2;
            string Row(string name, Func<Dictionary<string, StepTimes.Spread>, string> cell)
                => name.PadRight(width) + string.Concat(runs.Select(run => $"{cell(run.Times),14}"));
            output.WriteLine();
            output.WriteLine("colliders".PadRight(width) + string.Concat(runs.Select(run => $"{run.Count + (run.Forces ? " + forces" : ""),14}")));
            foreach (string stage in stages)
                output.WriteLine(Row(stage, times => times.TryGetValue(stage, out StepTimes.Spread spread)
                    ? spread.Median.ToString("0.0000", CultureInfo.InvariantCulture) : "–"));
            string Over(double step, double other) => (step / other - 1).ToString("+0.0 %;-0.0 %", CultureInfo.InvariantCulture);
            output.WriteLine(Row("over the same water", times => times.TryGetValue(Without, out StepTimes.Spread same)
                ? Over(times[With].Median, same.Median) : "–"));
            if (runs[0].Count == 0)
                output.WriteLine(Row("step over none", times => Over(times[StepTimes.Step].Median, runs[0].Times[StepTimes.Step].Median)));
            output.WriteLine($"ms, medians of {runs[0].Times[StepTimes.Step].Count} steps");
        }
    }
}
