using System;
using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Linq;
using Host.Assets;
using Host.Experiments;
using Host.Output;
using Rill;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace Host.Commands
{
    /// <summary><c>export</c>: plays a scene and writes its particles into a sequence of files that other programs read.</summary>
    static class ExportCommand
    {
        const int FramesUntilRead = 8;      // after the last, until its particles are back

        public static Command Create()
        {
            var scene = new Argument<string>("scene") { Description = "A .unity file, or the name of a scene or sample." };
            var seconds = new Option<double>("--seconds") { Description = "Simulated time.", DefaultValueFactory = _ => 5 };
            var fps = new Option<double>("--fps") { Description = "Frames per second of the player.", DefaultValueFactory = _ => 60 };
            var every = new Option<int>("--every") { Description = "Write each Nth frame.", DefaultValueFactory = _ => 2 };
            var format = new Option<string>("--format") { Description = "ply or vtk.", DefaultValueFactory = _ => "ply" };
            var target = new Option<string>("--out") { Description = $"Folder for the files; {ResultsFolder.Root}/<scene> by default." };
            var command = new Command("export", "Writes the particles of a scene as PLY or VTK files.") { scene, seconds, fps, every,
                format, target };
            command.SetAction(parsed =>
            {
                GivenNumber.CheckOption("--seconds", parsed.GetValue(seconds), 1e-3, GivenNumber.MaxSeconds);
                GivenNumber.CheckOption("--fps", parsed.GetValue(fps), 1, 1000);
                GivenNumber.CheckOption("--every", parsed.GetValue(every), 1, 1000000);
                ParticleFileFormat chosen = FormatOf(parsed.GetValue(format));
                int frames = (int)Math.Ceiling(parsed.GetValue(seconds) * parsed.GetValue(fps) - 1e-6);
                return Run(parsed.GetValue(scene), frames, parsed.GetValue(fps), parsed.GetValue(every), chosen, parsed.GetValue(target),
                    Console.Out);
            });
            return command;
        }

        /// <exception cref="HostException">It is none.</exception>
        internal static ParticleFileFormat FormatOf(string name)
        {
            return name switch
            {
                "ply" => ParticleFileFormat.Ply,
                "vtk" => ParticleFileFormat.Vtk,
                _ => throw new HostException($"--format {name}: give ply or vtk."),
            };
        }

        // Before the scene is played, which may take long.
        static void CheckFolder(string folder)
        {
            try
            {
                Directory.CreateDirectory(folder);
                using (File.Create(Path.Combine(folder, Path.GetRandomFileName()), 1, FileOptions.DeleteOnClose))
                {
                }
            }
            catch (Exception refusal) when (refusal is IOException || refusal is UnauthorizedAccessException)
            {
                throw new HostException($"--out {folder}: no files can be written there ({refusal.Message.TrimEnd('.')}). Give another folder.");
            }
        }

        static int Run(string name, int frames, double framesPerSecond, int every, ParticleFileFormat format, string target, TextWriter output)
        {
            LocatedScene located = Session.Locate(name);
            string folder = ResultsFolder.Of(target, Path.GetFileNameWithoutExtension(located.File));
            CheckFolder(folder);
            using var session = new Session(located, player: true);
            session.LoadScene(located);
            FluidSimulation[] simulations = Object.FindObjectsOfType<FluidSimulation>();
            if (simulations.Length == 0)
                throw new HostException($"'{located.File}' has no FluidSimulation, so no particles can be written.");
            List<ParticleSequence> sequences =
                simulations.Select((simulation, i) => new ParticleSequence(simulation, folder, simulations.Length > 1
                ? $"{i}_{simulation.name}" : "particles", format)).ToList();
            Progress.Run(output, "simulating", frames, report =>
            {
                for (int frame = 1; frame <= frames; frame++)
                {
                    PlayerLoop.Frame((float)(1 / framesPerSecond));
                    session.ThrowFault();
                    if (frame % every == 0)
                        foreach (ParticleSequence sequence in sequences)
                            sequence.Capture();
                    report(frame, FormattableString.Invariant($"{frame / framesPerSecond:0.00} s"));
                }
            });
            for (int wait = 0; wait < FramesUntilRead && sequences.Any(sequence => sequence.Written < sequence.Captured); wait++)
                PlayerLoop.Frame(0f);
            foreach (ParticleSequence sequence in sequences)
                sequence.Dispose();
            output.WriteLine($"{sequences.Sum(sequence => sequence.Written)} files in {folder}");
            if (sequences.FirstOrDefault(sequence => sequence.Written < sequence.Captured) is ParticleSequence failed)
                throw new HostException($"{failed.Captured - failed.Written} of {failed.Captured} files are missing: " +
                    $"{failed.Problem ?? "their particles did not come back"}");
            return 0;
        }
    }
}
