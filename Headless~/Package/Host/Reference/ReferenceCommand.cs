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
            var scene = new Argument<string>("scene")
            {
                Description = "A .unity file, or the name of a scene or sample; none with --board.",
                Arity = ArgumentArity.ZeroOrOne
            };
            var board = new Option<string>("--board")
            {
                Description = $"Draws water of a known shape before a checkerboard instead: {string.Join(", ", Boards.Names)}."
            };
            var frame = new Option<int>("--frame") { Description = "Frame of the player, 60 a second, from 1.", DefaultValueFactory = _ => 60 };
            var mesh = new Option<string>("--mesh")
            {
                Description =
                "The water's surface by another program, .obj or .ply, in the coordinates of rill export; meshed here by default."
            };
            var foam = new Option<bool>("--foam") { Description = "Our picture with its foam, which the reference does not have." };
            var samples = new Option<int?>("--samples") { Description = $"Paths of a pixel; 64, and {Boards.Samples} with --board." };
            var size = new Option<string>("--size")
            {
                Description = $"Pixels of the picture; 640x360, and {Boards.Size}x{Boards.Size} with --board."
            };
            var seed = new Option<int>("--seed") { Description = "Of the path tracer.", DefaultValueFactory = _ => 1 };
            var target = new Option<string>("--out") { Description = $"Folder for the pictures; {ResultsFolder.Root}/<scene>-reference by default." };
            var command = new Command("reference", "Draws a frame of a scene by Blender's Cycles too, and compares.") { scene, board, frame, size,
                samples, mesh, foam, seed, target };
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
                if (parsed.GetValue(scene) == null)
                    throw new HostException("reference needs a scene, a .unity file or the name of one, or --board.");
                GivenNumber.CheckOption("--frame", parsed.GetValue(frame), 1, 1000000);
                (int across, int high) = RunCommand.Size(parsed.GetValue(size) ?? "640x360");
                return new ReferenceRun(new ReferenceSettings
                {
                    Scene = parsed.GetValue(scene),
                    Mesh = parsed.GetValue(mesh),
                    Folder = parsed.GetValue(target),
                    Frame = parsed.GetValue(frame),
                    Width = across,
                    Height = high,
                    Samples = parsed.GetValue(samples) ?? 64,
                    Seed = parsed.GetValue(seed),
                    Foam = parsed.GetValue(foam),
                }, Console.Out).Execute();
            });
            return command;
        }
    }
}
