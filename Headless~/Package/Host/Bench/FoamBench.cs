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
    /// <summary><c>bench foam</c>: what foam adds to the GPU time of the solver's step, with so many foam particles over a dam that breaks.</summary>
    static class FoamBench
    {
        const string Stage = "Rill.Foam";
        // After the wave has met the wall; the budget is full by then.
        const int First = 100, Last = 200;

        public static Command Create()
        {
            var particles = new Option<int>("--particles") {
                Description = "Particles of the fluid; the block's lattice comes as near as it can. 1000000 is what a GPU is asked for.",
                DefaultValueFactory = _ => 100_000 };
            var budgets = new Option<int[]>("--budgets") {
                Description = $"Foam particles, 1 to {FoamSettings.MaxBudget:N0}: as many as can be and are.", DefaultValueFactory = _
                => new[] { 100_000, 500_000 }, AllowMultipleArgumentsPerToken = true };
            var steps = new Option<int>("--steps") { Description = $"Steps measured of each, at least {StepTimes.MinSteps}.",
                DefaultValueFactory = _ => StepTimes.MinSteps };
            Option<bool> kernels = KernelsOption.Create();
            var csv = new Option<string>("--csv") { Description = "Also write the figures to this file." };
            Option<string> shaders = ShadersOption.Create();
            var command = new Command("foam", "Measures GPU milliseconds of foam within the step.") { particles, budgets, steps, kernels,
                csv, shaders };
            command.SetAction(parsed =>
            {
                ShadersOption.Use(parsed.GetValue(shaders));
                KernelsOption.Use(parsed.GetValue(kernels));
                GivenNumber.CheckOption("--particles", parsed.GetValue(particles), ExperimentScene.MinDamParticles, SolverLayout.MaxCapacity);
                if (parsed.GetValue(budgets).Any(budget => budget < 1 || budget > FoamSettings.MaxBudget))
                    throw new HostException($"--budgets {string.Join(" ", parsed.GetValue(budgets))}: give 1 to {FoamSettings.MaxBudget}.");
                if (parsed.GetValue(steps) < StepTimes.MinSteps)
                    throw new HostException($"--steps {parsed.GetValue(steps)}: a median needs at least {StepTimes.MinSteps}.");
                Execute(parsed.GetValue(particles), parsed.GetValue(budgets), parsed.GetValue(steps), parsed.GetValue(csv), Console.Out);
                return 0;
            });
            return command;
        }

        static void Execute(int particles, int[] budgets, int steps, string csv, TextWriter output)
        {
            using var session = new Session(Session.Root());
            ExperimentScene scene = ExperimentScene.Dam(particles);
            string setting = string.Create(CultureInfo.InvariantCulture,
                $"{scene.Particles:N0} particles of a dam, d = {scene.Spacing:0.#####} m, steps {First} to {Last}");
            output.WriteLine(session.DescribeDevice());
            output.WriteLine(setting);
            if (session.Info.IsSoftware)
                output.WriteLine("This device is a CPU: the figures say nothing about a GPU.");
            output.WriteLine();
            output.WriteLine($"{"foam particles",-16}{"foam ms",12}{"10 %",10}{"90 %",10}{"step ms",12}{"MiB",9}");
            var table = new ReportTable("particles", "foam_particles", "stage", "median_ms", "p10_ms", "p90_ms",
                "steps") { MeasuredOn = $"{session.DescribeDevice()}; {setting}" };
            foreach (int budget in budgets)
                Measure(scene, budget, steps, table, output);
            if (csv != null)
                table.Save(Path.GetFullPath(csv));
        }

        /// <summary>Foam of more than a hundred times what a scene has, so that all of the budget is there.</summary>
        public static FoamSettings FillOf(ExperimentScene scene, int budget)
        {
            float depth = scene.Blocks[0].counts.y * scene.Spacing;
            FoamSettings settings = FoamSettings.Default;
            settings.budget = budget;
            settings.amount = 10f;
            settings.lifetime = 200f;
            settings.referenceSpeed = (float)Math.Sqrt(9.81 * depth);
            settings.referenceDepth = 0.2f * depth;
            return settings;
        }

        static void Measure(ExperimentScene scene, int budget, int steps, ReportTable table, TextWriter output)
        {
            StepInput input = ExperimentFigures.Input(SolverSettings.Default);
            input.foam = FillOf(scene, budget);
            using var solver = new PbfSolver(new SolverLayout(scene.Domain, scene.Spacing, scene.Particles, input.settings.neighborCapacity,
                input.settings.listMargin));
            Dictionary<string, StepTimes.Spread> times = StepTimes.Measure(solver, scene.Fill, input, First, Last, steps);
            var counters = new uint[Foam.CounterCount];
            solver.Foam.Counters.GetData(counters);
            uint alive = counters[(int)FoamCounter.Alive];
            StepTimes.Spread foam = times[Stage];
            double bytes = solver.Describe(input, 0).Single(stage => stage.Name == "Foam").Bytes;
            output.WriteLine(string.Create(CultureInfo.InvariantCulture,
                $"{alive,-16:N0}{foam.Median,12:0.0000}{foam.Low,10:0.0000}{foam.High,10:0.0000}{times[StepTimes.Step].Median,12:0.0000}{bytes / 1048576.0,9:0.0}"));
            foreach ((string kernel, StepTimes.Spread spread) in times.Where(time => time.Key.StartsWith("Foam", StringComparison.Ordinal)))
                output.WriteLine(string.Create(CultureInfo.InvariantCulture,
                    $"  {kernel,-40}{spread.Median,10:0.0000}{spread.Low,10:0.0000}{spread.High,10:0.0000}"));
            foreach ((string stage, StepTimes.Spread spread) in times)
                table.Add(scene.Particles, alive, stage, spread.Median, spread.Low, spread.High, spread.Count);
        }
    }
}
