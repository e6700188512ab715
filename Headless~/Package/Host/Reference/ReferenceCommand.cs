using System;
using System.CommandLine;
using System.IO;
using Host.Commands;
using Host.Experiments;
using Host.Output;

namespace Host.Reference
{
    /// <summary><c>reference</c>: the same frame by a path tracer, beside ours, with what differs as figures.</summary>
    static class ReferenceCommand
    {
        public static Command Create()
        {
            var scene = new Argument<string>("scene") { Description = "A .unity file, or the name of a scene or sample; none with --board.",
                Arity = ArgumentArity.ZeroOrOne };
            var board = new Option<string>("--board") { Description = $"Draws water of a known shape before a checkerboard instead: {string.Join(", ", Boards.Names)}." };
            var samples = new Option<int?>("--samples") { Description = $"Paths of a pixel; {Boards.Samples} with --board." };
            var size = new Option<string>("--size") { Description = $"Pixels of the picture; {Boards.Size}x{Boards.Size} with --board." };
            var seed = new Option<int>("--seed") { Description = "Of the path tracer.", DefaultValueFactory = _ => 1 };
            var target = new Option<string>("--out") { Description = $"Folder for the pictures; {ResultsFolder.Root}/<scene>-reference by default." };
            var command = new Command("reference", "Draws a frame of a scene by Blender's Cycles too, and compares.") { scene, board, samples, size,
                seed, target };
            command.SetAction(parsed =>
            {
                if (parsed.GetValue(samples) is int paths)
                    GivenNumber.CheckOption("--samples", paths, 1, 65536);
                if (parsed.GetValue(board) is string name)
                {
                    (int width, int height) = RunCommand.Size(parsed.GetValue(size) ?? $"{Boards.Size}x{Boards.Size}");
                    if (width != height)
                        throw new HostException($"--size {width}x{height}: a board's picture is as wide as high.");
                    Console.Out.WriteLine(Boards.Draw(name, ResultsFolder.Of(parsed.GetValue(target), "boards"), width,
                        parsed.GetValue(samples) ?? Boards.Samples, parsed.GetValue(seed)));
                    return 0;
                }
                throw new HostException("reference needs a scene or --board.");
            });
            return command;
        }
    }
}
