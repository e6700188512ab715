using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using System.Linq;
using Host.Experiments;
using Rill;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Host.Studies
{
    /// <summary>
    /// <c>study</c>: relaxation against stability. A tank that should stay still and a dam, each for a sweep of ω and
    /// iterations: what the clamp of <see cref="SolverSettings.MaxRelaxation"/> and the defaults rest on.
    /// </summary>
    static class StudyCommand
    {
        static readonly float[] Relaxations = { 0.3f, 0.5f, 0.8f, 1f, 1.1f, 1.2f, 1.3f, 1.4f, 1.5f, 1.7f, 2f };
        static readonly int[] Iterations = { 1, 2, 3, 4, 8 };
        const float Spacing = 0.05f;

        // A block of this many particles at the low corner of a box of that many spacings.
        static readonly (string Name, int3 Block, int3 Box)[] Scenes =
        {
            ("tank", new int3(24, 10, 24), new int3(24, 30, 24)),
            ("dam", new int3(20, 16, 20), new int3(60, 40, 20)),
        };

        public static Command Create()
        {
            var seconds = new Option<float>("--seconds") { Description = "Fluid time of a run; the last two seconds are averaged.",
                DefaultValueFactory = _ => 8f };
            var csv = new Option<string>("--csv") { Description = "Also write the table to this file." };
            var command = new Command("study", "Sweeps relaxation and iterations over a still tank and a dam.") { seconds, csv };
            command.SetAction(parsed => Execute(parsed.GetValue(seconds), parsed.GetValue(csv), System.Console.Out));
            return command;
        }

        static int Execute(float seconds, string csv, TextWriter output)
        {
            if (!(seconds >= 4f))
                throw new HostException($"--seconds {seconds}: the last two are averaged after settling; give at least 4.");
            using var session = new Session(Session.Root());
            output.WriteLine(session.DescribeDevice());
            var lines =
                new List<string> {
                "scene,particles,iterations,relaxation,density_error,volume_ratio,noise_m_s,jitter_m_s,highest_energy_over_start,coincident" };
            output.WriteLine(lines[0]);
            foreach ((string name, int3 block, int3 box) in Scenes)
                foreach (int iterations in Iterations)
                    foreach (float relaxation in Relaxations)
                    {
                        lines.Add(Run(name, block, box, iterations, relaxation, seconds));
                        output.WriteLine(lines[^1]);
                    }
            if (csv != null)
                File.WriteAllLines(csv, lines);
            return 0;
        }

        static string Run(string name, int3 block, int3 box, int iterations, float relaxation, float seconds)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = DeepWater.Off;      // the limits of plain iterations
            settings.iterations = iterations;
            settings.relaxation = relaxation;       // not validated: what lies beyond the clamp is the question
            var input = ExperimentFigures.Input(settings);

            Experiment run = Experiment.Run(ExperimentScene.Block(name, block, box, Spacing), input, seconds, sampleEvery: 10);
            double start = run.Samples[0].Energy;
            return string.Create(CultureInfo.InvariantCulture,
                $"{name},{run.Scene.Particles},{iterations},{relaxation},{run.Settled(s => s.densityError):0.00000},{run.Settled(s => s.volumeRatio):0.0000},{run.Settled(s => s.speed):0.0000},{run.Settled(s => s.jitter):0.0000},{run.Samples.Max(s => s.Energy) / start:0.0000},{run.SettledSamples.Max(s => s.coincident)}");
        }
    }
}
