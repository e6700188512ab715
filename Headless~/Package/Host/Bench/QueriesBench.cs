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
using UnityEngine.Headless;
using Random = Unity.Mathematics.Random;

namespace Host.Bench
{
    /// <summary><c>bench queries</c>: what probes, detectors and a batch take of the GPU after a step, over a dam that breaks.</summary>
    static class QueriesBench
    {
        const string Stage = "Rill.Queries", BatchStage = "Rill.QueryBatch";
        const int First = 20, Last = 60;

        public static Command Create()
        {
            var particles = new Option<int>("--particles") {
                Description = "Particles of the fluid; the block's lattice comes as near as it can. 1000000 is what a GPU is asked for.",
                DefaultValueFactory = _ => 100_000 };
            var probes = new Option<int>("--probes") { Description = $"Probes, 0 to {Queries.MaxProbes}.",
                DefaultValueFactory = _ => Queries.MaxProbes };
            var detectors = new Option<int>("--detectors") {
                Description = $"Detectors, 0 to {Queries.MaxDetectors}: boxes of a third of the water's block along each side.",
                DefaultValueFactory = _ => Queries.MaxDetectors };
            var points = new Option<int>("--points") { Description = $"Points of a batch, 0 to {FluidQueryBatch.MaxPoints}.",
                DefaultValueFactory = _ => 1000 };
            var rays = new Option<int>("--rays") {
                Description = $"Rays of the same batch, 0 to {FluidQueryBatch.MaxRays}: from over the water into it.",
                DefaultValueFactory = _ => 1000 };
            var ball = new Option<float>("--ball") {
                Description = $"Radius of the balls that are cast along the rays in spacings, 0 to {RayQuery.MaxRadius}.",
                DefaultValueFactory = _ => 0f };
            var steps = new Option<int>("--steps") { Description = $"Steps measured, at least {StepTimes.MinSteps}.",
                DefaultValueFactory = _ => StepTimes.MinSteps };
            Option<bool> kernels = KernelsOption.Create();
            var csv = new Option<string>("--csv") { Description = "Also write the figures to this file." };
            Option<string> shaders = ShadersOption.Create();
            var command = new Command("queries", "Measures GPU milliseconds of probes, detectors and a batch after the step.") { particles,
                probes, detectors, points, rays, ball, steps, kernels, csv, shaders };
            command.SetAction(parsed =>
            {
                ShadersOption.Use(parsed.GetValue(shaders));
                KernelsOption.Use(parsed.GetValue(kernels));
                GivenNumber.CheckOption("--particles", parsed.GetValue(particles), ExperimentScene.MinDamParticles, SolverLayout.MaxCapacity);
                GivenNumber.CheckOption("--probes", parsed.GetValue(probes), 0, Queries.MaxProbes);
                GivenNumber.CheckOption("--detectors", parsed.GetValue(detectors), 0, Queries.MaxDetectors);
                GivenNumber.CheckOption("--points", parsed.GetValue(points), 0, FluidQueryBatch.MaxPoints);
                GivenNumber.CheckOption("--rays", parsed.GetValue(rays), 0, FluidQueryBatch.MaxRays);
                GivenNumber.CheckOption("--ball", parsed.GetValue(ball), 0f, RayQuery.MaxRadius);
                var counts = new Counts(parsed.GetValue(probes), parsed.GetValue(detectors), parsed.GetValue(points), parsed.GetValue(rays));
                if (counts.Probes + counts.Detectors + counts.Points + counts.Rays == 0)
                    throw new HostException("There is nothing to measure: give at least one of --probes, --detectors, --points and --rays.");
                if (parsed.GetValue(steps) < StepTimes.MinSteps)
                    throw new HostException($"--steps {parsed.GetValue(steps)}: a median needs at least {StepTimes.MinSteps}.");
                Execute(parsed.GetValue(particles), counts, parsed.GetValue(ball), parsed.GetValue(steps), parsed.GetValue(csv), Console.Out);
                return 0;
            });
            return command;
        }

        static void Execute(int particles, Counts counts, float ball, int steps, string csv, TextWriter output)
        {
            using var session = new Session(Session.Root());
            ExperimentScene scene = ExperimentScene.Dam(particles);
            string setting = string.Create(CultureInfo.InvariantCulture, $"{scene.Particles:N0} particles of a dam, d = " +
                $"{scene.Spacing:0.#####} m, steps {First} to {Last}, {counts.Probes} probes, {counts.Detectors} detectors, " +
                $"a batch of {counts.Points} points and {counts.Rays} rays{(ball > 0f ? $" with balls of {ball} d" : "")}");
            output.WriteLine(session.DescribeDevice());
            output.WriteLine(setting);
            if (session.Info.IsSoftware)
                output.WriteLine("This device is a CPU: the figures say nothing about a GPU.");
            output.WriteLine();
            StepInput input = ExperimentFigures.Input(SolverSettings.Default);
            using var solver = new PbfSolver(new SolverLayout(scene.Domain, scene.Spacing, scene.Particles, input.settings.neighborCapacity,
                input.settings.listMargin));
            QueryInput asked = Ask(scene, counts.Probes, counts.Detectors);
            solver.MakeQueries();
            using QueryBatch batch = counts.Points + counts.Rays > 0 ? new QueryBatch(counts.Points, counts.Rays, _ => { }) : null;
            var batches = new List<QueryBatch> { batch };
            using var points = new NativeArray<float4>(Math.Max(counts.Points, 1), Allocator.Persistent);
            using var rays = new NativeArray<RayQuery>(Math.Max(counts.Rays, 1), Allocator.Persistent);
            BatchInput batched = CreateBatch(scene, counts, ball, points, rays);
            Dictionary<string, StepTimes.Spread> times = StepTimes.Measure(solver, scene.Fill, input, First, Last, steps,
                cmd =>
                {
                    if (counts.Probes + counts.Detectors > 0)
                        solver.RecordQueries(cmd, asked, 0);
                    if (batch != null)
                    {
                        batch.Prepare(batched, 0);
                        solver.RecordBatches(cmd, batches);
                    }
                });
            var table = new ReportTable("particles", "probes", "detectors", "points", "rays", "stage", "median_ms", "p10_ms", "p90_ms",
                "steps") { MeasuredOn = $"{session.DescribeDevice()}; {setting}" };
            output.WriteLine($"{"",-34}{"median ms",12}{"10 %",10}{"90 %",10}");
            foreach ((string stage, StepTimes.Spread spread) in times.Where(time => time.Key == Stage || time.Key == BatchStage
                || time.Key == StepTimes.Step || time.Key.StartsWith("Queries", StringComparison.Ordinal)))
            {
                output.WriteLine(string.Create(CultureInfo.InvariantCulture,
                    $"{stage,-34}{spread.Median,12:0.0000}{spread.Low,10:0.0000}{spread.High,10:0.0000}"));
                table.Add(scene.Particles, counts.Probes, counts.Detectors, counts.Points, counts.Rays, stage, spread.Median, spread.Low,
                    spread.High, spread.Count);
            }
            if (csv != null)
                table.Save(Path.GetFullPath(csv));
        }

        // Points where probes are, and rays from over the block towards them.
        static BatchInput CreateBatch(ExperimentScene scene, Counts counts, float ball, NativeArray<float4> points, NativeArray<RayQuery> rays)
        {
            var random = new Random(6u);
            float3 block = scene.Blocks[0].counts, size = scene.Box, reach = math.min(new float3(1.5f, 1f, 1f) * block, size);
            for (int i = 0; i < counts.Points; i++)
                points[i] = new float4(random.NextFloat3(0f, reach), 0f);
            for (int i = 0; i < counts.Rays; i++)
            {
                float3 from = random.NextFloat3(new float3(0f, 0.95f, 0f) * size, size), to = random.NextFloat3(0f, reach);
                rays[i] = new RayQuery
                {
                    origin = from,
                    direction = math.normalize(to - from),
                    maxDistance = float.MaxValue,
                    radius = ball,
                    crossings = (uint)FluidCrossing.Enter,
                    lines = (uint)RayQuery.LinesFor(ball),
                };
            }
            return new BatchInput { points = points, rays = rays, pointCount = counts.Points, rayCount = counts.Rays,
                rayLength = math.csum(size), up = new float3(0f, 1f, 0f) };
        }

        // Anywhere over the floor that the water comes to.
        static QueryInput Ask(ExperimentScene scene, int probes, int detectors)
        {
            var random = new Random(5u);
            var asked = new QueryInput { pointCount = probes, detectorCount = detectors, up = new float3(0f, 1f, 0f) };
            float3 block = scene.Blocks[0].counts;
            for (int i = 0; i < probes; i++)
                asked.points[i] = new float4(random.NextFloat3(0f, math.min(new float3(1.5f, 1f, 1f) * block, scene.Box)), 0f);
            for (int i = 0; i < detectors; i++)
            {
                float3 half = block / 6f, center = random.NextFloat3(half, math.max(block - half, half));
                asked.detectors[i] = new DetectorRegion { rotation = quaternion.identity.value, center = center,
                    shape = (uint)DetectorShape.Box, size = half, low = center - half - 0.9f, high = center + half + 0.9f };
            }
            return asked;
        }

        readonly record struct Counts(int Probes, int Detectors, int Points, int Rays);
    }
}
