using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using System.Linq;
using Host.Assets;
using Rill;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace Host.Commands
{
    /// <summary><c>explain</c>: what a scene's simulations cost in stages, kernels, variants and bytes, and why.</summary>
    static class ExplainCommand
    {
        // Enough for everything that is made when first needed: by default a measurement comes every ten steps.
        const int Frames = 12;

        public static Command Create()
        {
            var scene = new Argument<string>("scene") { Description = "A .unity file, or the name of a scene or sample." };
            var command = new Command("explain", "Names the stages that a scene uses, their kernels and memory, and the reason for each.") { scene };
            command.SetAction(parsed =>
            {
                LocatedScene located = Session.Locate(parsed.GetValue(scene));
                using var session = new Session(located, player: true);
                session.LoadScene(located);
                for (int i = 0; i < Frames; i++)
                    PlayerLoop.Frame(1f / 60f);
                foreach (FluidSimulation simulation in Object.FindObjectsOfType<FluidSimulation>())
                    Write(simulation.name, simulation.Results.Describe(), System.Console.Out);
                WriteBuild(Object.FindObjectsOfType<MonoBehaviour>(true), System.Console.Out);
                return 0;
            });
            return command;
        }

        /// <summary>The stages that a build of the scene contains, and the components that ask for each.</summary>
        internal static void WriteBuild(IEnumerable<MonoBehaviour> components, TextWriter output)
        {
            output.WriteLine();
            output.WriteLine("A build of this scene contains");
            var users = components.OfType<IUsesFeatures>()
                .SelectMany(user => user.StageReferences.Stages.Where(stage => stage != null)
                .Select(stage => (stage, user: (MonoBehaviour)user))).ToList();
            foreach (var use in users.GroupBy(use => use.stage).OrderBy(use => use.Key.name, System.StringComparer.Ordinal))
                output.WriteLine($"      {use.Key.name}: {Contents(use.Key)}, for " +
                    $"{string.Join(", ", use.GroupBy(u => u.user.GetType().Name).OrderBy(kind => kind.Key, System.StringComparer.Ordinal).Select(kind => $"{kind.Key} {string.Join(" and ", kind.Select(u => $"'{u.user.name}'").OrderBy(name => name, System.StringComparer.Ordinal))}"))}");
            if (users.Count == 0)
                output.WriteLine("      no stage");
        }

        static string Contents(StageShader stage)
        {
            if (stage.Compute == null)
                return $"the shader {stage.Shader.name}";
            ComputeShaderSource source = stage.Compute.Source;
            string shader = stage.Shader != null ? $"the shader {stage.Shader.name} and " : "";
            return $"{shader}{source.Kernels.Count} kernels{(source.Keywords.Count > 0 ? $" with {string.Join(", ", source.Keywords)}" : "")}";
        }

        internal static void Write(string name, List<StageDescription> stages, TextWriter output)
        {
            output.WriteLine($"Simulation '{name}'");
            foreach (StageDescription stage in stages)
            {
                output.WriteLine();
                output.WriteLine($"{(stage.IsUsed ? "on " : "off")} {stage.Name}: {stage.Reason}");
                foreach ((string kernel, int perStep) in stage.Kernels)
                    output.WriteLine($"      {kernel}{(perStep > 0 ? $" x {perStep}" : ", when measuring")}");
                foreach ((string buffer, long bytes) in stage.Buffers)
                    output.WriteLine($"      {buffer} {bytes.ToString("N0", CultureInfo.InvariantCulture)} bytes");
            }
            output.WriteLine();
            output.WriteLine(
                $"{stages.Sum(stage => stage.Kernels.Sum(kernel => kernel.perStep)).ToString("N0", CultureInfo.InvariantCulture)} " +
                $"dispatches and draws a step, {stages.Sum(stage => stage.Bytes).ToString("N0", CultureInfo.InvariantCulture)} bytes in buffers");
        }
    }
}
