using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using System.Linq;
using Host.Check;
using Host.Commands;
using Host.Experiments;
using Host.Report;
using Rill;

namespace Host.Bench
{
    /// <summary>Times what the fields of a Fluid Simulation add to a step, each changed alone.</summary>
    static class FieldsBench
    {
        delegate void Change(ref SolverSettings settings, ref FluidMaterial material);

        static readonly (string Name, Change Apply)[] Fields =
        {
            (PerformancePage.Defaults, (ref SolverSettings s, ref FluidMaterial m) => { }),
            ("Deep Water on", (ref SolverSettings s, ref FluidMaterial m) => s.deepWater = DeepWater.On),
            ("Deep Water off", (ref SolverSettings s, ref FluidMaterial m) => s.deepWater = DeepWater.Off),
            ("Iterations + 1", (ref SolverSettings s, ref FluidMaterial m) => s.iterations++),
            ("Substeps 2", (ref SolverSettings s, ref FluidMaterial m) => s.substeps = 2),
            ("List Margin 1.2", (ref SolverSettings s, ref FluidMaterial m) => s.listMargin = 1.2f),
            ("Neighbor Capacity 128", (ref SolverSettings s, ref FluidMaterial m) => s.neighborCapacity = 128),
            ("Numerical Damping 0.5", (ref SolverSettings s, ref FluidMaterial m) => s.numericalDamping = 0.5f),
            ("Sleep Speed 0.05", (ref SolverSettings s, ref FluidMaterial m) => s.sleepSpeed = 0.05f),
            ("Velocity Smoothing 0", (ref SolverSettings s, ref FluidMaterial m) => m.velocitySmoothing = 0f),
            ("Dynamic Viscosity 1", (ref SolverSettings s, ref FluidMaterial m) => m.dynamicViscosity = 1f),
            ("Vorticity 0.1", (ref SolverSettings s, ref FluidMaterial m) => m.vorticity = 0.1f),
            ("Artificial Pressure 0.1", (ref SolverSettings s, ref FluidMaterial m) => m.artificialPressure = 0.1f),
            ("Surface Tension 1", (ref SolverSettings s, ref FluidMaterial m) => m.surfaceTension = 1f),
            ("Friction Angle 31", (ref SolverSettings s, ref FluidMaterial m) => m.frictionAngle = 31f),
            ("Shear Modulus 1000", (ref SolverSettings s, ref FluidMaterial m) => m.shearModulus = 1000f),
        };

        public static Command Create()
        {
            var particles = new Option<int[]>("--particles") { Description = "Particles of a breaking dam; several after each other.",
                DefaultValueFactory = _ => new[] { 100_000, 1_000_000 }, AllowMultipleArgumentsPerToken = true };
            var steps = new Option<int>("--steps") { Description = $"Steps measured of each, at least {StepTimes.MinSteps}.",
                DefaultValueFactory = _ => StepTimes.MinSteps };
            var csv = new Option<string>("--csv") { Description = "Also write the figures to this file." };
            var page = new Option<bool>("--page") {
                Description = $"Also write the figures to {PerformancePage.Figures} and their table to {new PerformancePage().Path}." };
            var writeOnly = new Option<bool>("--write-only") { Description = "Only the table of the page, from the figures that are there." };
            var command = new Command("fields", "Measures what fields of a Fluid Simulation add to a step, each changed alone.") {
                particles, steps, csv, page, writeOnly };
            command.SetAction(parsed =>
            {
                if (parsed.GetValue(writeOnly))
                    return WritePage();
                foreach (int size in parsed.GetValue(particles))
                    GivenNumber.CheckOption("--particles", size, ExperimentScene.MinDamParticles, SolverLayout.MaxCapacity);
                if (parsed.GetValue(steps) < StepTimes.MinSteps)
                    throw new HostException($"--steps {parsed.GetValue(steps)}: a median needs at least {StepTimes.MinSteps}.");
                ReportTable table = Execute(parsed.GetValue(particles), parsed.GetValue(steps), parsed.GetValue(page), Console.Out);
                if (parsed.GetValue(csv) is string file)
                    table.Save(Path.GetFullPath(file));
                if (!parsed.GetValue(page))
                    return 0;
                table.Save(Path.Combine(Session.Root(), PerformancePage.Figures));
                return WritePage();
            });
            return command;
        }

        static int WritePage() => GenerateCommand.Write(new GeneratedFiles[] { new PerformancePage() });

        static ReportTable Execute(int[] sizes, int steps, bool forPage, TextWriter output)
        {
            using var session = new Session(Session.Root());
            (string window, int first, int last) = StepTimes.Windows[1];
            string setting = $"a dam, steps {first} to {last} ({window})";
            output.WriteLine(session.DescribeDevice());
            output.WriteLine(setting);
            if (session.Info.IsSoftware && forPage)
                throw new HostException("bench fields --page: this device is a CPU, whose figures say nothing about a GPU. Leave --page out.");
            if (session.Info.IsSoftware)
                output.WriteLine("This device is a CPU: the figures say nothing about a GPU.");
            var table = new ReportTable(PerformancePage.Columns) {
                MeasuredOn = $"{session.DescribeDevice()}; {setting}; {DateTime.UtcNow:yyyy-MM-dd}, commit {SourceCommit.Describe()}" };
            foreach (int particles in sizes)
                Measure(ExperimentScene.Dam(particles), first, last, steps, table, output);
            return table;
        }

        static void Measure(ExperimentScene scene, int first, int last, int steps, ReportTable table, TextWriter output)
        {
            output.WriteLine($"\n{scene.Particles + " particles",-26}{"median ms",12}{"10 %",10}{"90 %",10}{"more, ms",10}{"bytes a particle",18}");
            double defaults = 0;
            foreach ((string name, Change apply) in Fields)
            {
                SolverSettings settings = SolverSettings.Default;
                FluidMaterial material = FluidMaterial.Water;
                apply(ref settings, ref material);
                StepInput input = ExperimentFigures.Input(settings, material);
                using var solver = new PbfSolver(scene.LayoutFor(settings));
                StepTimes.Spread step = StepTimes.Measure(solver, scene.Fill, input, first, last, steps)[StepTimes.Step];
                long bytes = solver.Describe(input, 0).Sum(stage => stage.Bytes) / scene.Particles;
                defaults = name == PerformancePage.Defaults ? step.Median : defaults;
                output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{name,-26}{step.Median,12:0.0000}{step.Low,10:0.0000}") +
                    string.Create(CultureInfo.InvariantCulture, $"{step.High,10:0.0000}{step.Median - defaults,10:+0.000;-0.000;0}{bytes,18}"));
                table.Add(scene.Particles, name, step.Median, step.Low, step.High, step.Count, bytes);
            }
        }
    }
}
