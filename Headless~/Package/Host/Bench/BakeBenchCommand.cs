using System;
using System.Collections.Generic;
using System.CommandLine;
using Host.Assets;
using Host.Baking;
using Rill;

namespace Host.Bench
{
    /// <summary><c>bench bake</c>: CPU and GPU time of bakes by the mesh's size. It prints figures and judges none.</summary>
    static class BakeBenchCommand
    {
        // A resolution that suits the triangles; the last two are those that are spoken of.
        static readonly (int Triangles, int Resolution)[] Sizes = { (10_000, 64), (100_000, 128), (1_000_000, 256) };

        public static Command Create()
        {
            var mesh = new Argument<string>("mesh") {
                Description = "A .obj or .glb file; without one, bumpy spheres of 10,000, 100,000 and 1,000,000 triangles.",
                Arity = ArgumentArity.ZeroOrOne };
            var triangles = new Option<int?>("--triangles") { Description = "One bumpy sphere of about so many." };
            var resolution = new Option<int?>("--resolution") {
                Description = $"Voxels along the longest axis, {MeshSdfSettings.MinResolution} to {MeshSdfSettings.MaxResolution}." };
            var sign = new Option<string>("--sign") {
                Description = "How inside is told from outside: automatic, winding-number or open-shell.", DefaultValueFactory = _
                => "automatic" };
            var repeats = new Option<int>("--repeats") { Description = "Bakes of each mesh, after one that warms up.", DefaultValueFactory = _ => 5 };
            var stages = new Option<bool>("--stages") {
                Description = "Also the parts of a bake: what the CPU prepares, and each kind of dispatch on the GPU." };
            var deforming = new Option<bool>("--deforming") {
                Description = "Instead, fields of a skinned mesh that are baked again in a frame: 10,000 and 100,000 triangles, 32 and 64 voxels." };

            var command = new Command("bake", "Measures milliseconds of bakes, on the CPU and on the GPU.") { mesh, triangles, resolution,
                sign, repeats, stages, deforming };
            command.SetAction(parsed =>
            {
                string file = parsed.GetValue(mesh);
                int? size = parsed.GetValue(triangles), asked = parsed.GetValue(resolution);
                int count = parsed.GetValue(repeats);
                if (file != null && size != null)
                    throw new HostException("a mesh's file and --triangles exclude each other; give one of them.");
                if (size < 16 || size > 20_000_000)
                    throw new HostException($"--triangles {size:N0}: give 16 to 20,000,000.");
                if (count < 1)
                    throw new HostException($"--repeats {count}: give 1 or more.");
                if (file != null && parsed.GetValue(deforming))
                    throw new HostException("a mesh's file has no bones: leave it or --deforming away.");
                MeshSdfSettings settings = MeshSdfSettings.Default;
                settings.sign = BakeCommand.Choice<MeshSdfSign>(parsed.GetValue(sign), "--sign");
                settings.memoryCap = 16384;

                var meshes = new List<(Func<TriangleMesh> Mesh, int Resolution)>();
                if (file != null)
                    meshes.Add((() => { MeshFile read = MeshFile.Read(file);
                        return new TriangleMesh(read.Name, read.Vertices, read.Triangles); }, asked ?? 128));
                else if (size is int one)
                    meshes.Add((() => BakeBench.Lump(one), asked ?? 128));
                else
                    foreach ((int each, int fitting) in Sizes)
                        meshes.Add((() => BakeBench.Lump(each), asked ?? fitting));

                using var session = new Session(Session.Root());
                Console.Out.WriteLine(session.DescribeDevice());
                if (parsed.GetValue(deforming))
                {
                    DeformingBench.Print(count, size, asked, parsed.GetValue(stages), Console.Out);
                    return session.ErrorsLogged == 0 ? 0 : 1;
                }
                Console.Out.WriteLine("prepare: before the first dispatch; record: between them; result: after the last; asset: into a " +
                    "texture, beside the whole");
                if (session.Info.IsSoftware)
                    Console.Out.WriteLine("This device is a CPU: its figures say nothing about a GPU, and the whole holds them.");
                BakeBench.PrintHead(Console.Out);
                foreach ((Func<TriangleMesh> make, int voxels) in meshes)
                {
                    settings.resolution = voxels;
                    TriangleMesh made = make();
                    BakeBench.Print(made, settings, count, Console.Out);
                    if (parsed.GetValue(stages))
                        BakeBench.PrintParts(made, settings, count, Console.Out);
                }
                return session.ErrorsLogged == 0 ? 0 : 1;
            });
            return command;
        }
    }
}
