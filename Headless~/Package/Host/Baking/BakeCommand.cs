using System;
using System.CommandLine;
using System.Globalization;
using System.IO;
using System.Linq;
using Host.Assets;
using Host.Output;
using Rill;

namespace Host.Baking
{
    /// <summary><c>bake</c>: a mesh file becomes a distance field's asset and a picture of its slices, or the mesh colliders of a scene get
    /// theirs.</summary>
    static class BakeCommand
    {
        public static Command Create()
        {
            MeshSdfSettings normal = MeshSdfSettings.Default;
            var mesh = new Argument<string>("mesh") {
                Description =
                "A .obj or .glb file; or a scene, a .unity file or its name, whose mesh colliders without a usable field are baked." };
            var target = new Option<string>("--out") { Description = $"Folder for <name>.asset and <name>-slices.png; " +
                $"{ResultsFolder.Root}/<name> by default. Of a scene only for the pictures: new fields lie beside it." };
            var voxel = new Option<float?>("--voxel") { Description = "Edge of a voxel, m, instead of --resolution." };
            var resolution = new Option<int?>("--resolution") { Description = $"Voxels along the longest axis, " +
                $"{MeshSdfSettings.MinResolution} to {MeshSdfSettings.MaxResolution}; {normal.resolution} by default." };
            var padding = new Option<int>("--padding") {
                Description = $"Voxels around the mesh on every side, 1 to {MeshSdfSettings.MaxPadding}.", DefaultValueFactory = _
                => normal.padding };
            var sign = new Option<string>("--sign") { Description = "How inside is told from outside: " + Choices<MeshSdfSign>() + ".",
                DefaultValueFactory = _ => "automatic" };
            var shell = new Option<float>("--shell") { Description = "Thickness of the shell that an open surface becomes, m; 0 for two voxels." };
            var format = new Option<string>("--format") { Description = "Bits of a voxel: " + Choices<SdfFormat>() + " (16 or 32).",
                DefaultValueFactory = _ => "automatic" };
            var memory = new Option<string>("--memory") {
                Description = $"Most memory of the bake in bytes, or with K, M, G: 512M; {normal.memoryCap}M by default." };
            var scale = new Option<float>("--scale") {
                Description = "The mesh is scaled by it, as by Scale Factor in Unity's import settings: 0.01 for a file in centimeters.",
                DefaultValueFactory = _ => 1f };

            var leaveOutFar = new Option<bool>("--leave-out-far") {
                Description = "Leaves out small parts far from the others, and triangles at a corner that strayed, which make the voxels large." };

            var again = new Option<bool>("--again") {
                Description = "Of a scene also those fields that are up to date, with the settings that they have." };

            var command = new Command("bake", "Bakes a mesh file, or a scene's mesh colliders, to signed distance fields.") { mesh, target,
                voxel, resolution, padding, sign, shell, format, memory, scale, leaveOutFar, again };
            command.SetAction(parsed =>
            {
                if (parsed.GetValue(voxel) != null && parsed.GetValue(resolution) != null)
                    throw new HostException("--voxel and --resolution say the same thing; give one of them.");
                MeshSdfSettings settings = normal;
                settings.voxelSize = parsed.GetValue(voxel) is float size ? Positive(size, "--voxel") : 0f;
                settings.resolution = parsed.GetValue(resolution) ?? normal.resolution;
                settings.padding = parsed.GetValue(padding);
                settings.sign = Choice<MeshSdfSign>(parsed.GetValue(sign), "--sign");
                settings.shellThickness = parsed.GetValue(shell);
                settings.format = Choice<SdfFormat>(parsed.GetValue(format), "--format");
                settings.leaveOutFar = parsed.GetValue(leaveOutFar);
                settings.memoryCap = parsed.GetValue(memory) is string bytes ? MebiBytes(bytes) : normal.memoryCap;
                Tool.WarnOfMissing((Tool.Gnuplot, "picture of the slices"));

                string what = parsed.GetValue(mesh);
                if (IsScene(what))
                {
                    if (parsed.GetValue(scale) != 1f)
                        throw new HostException("--scale is for a mesh's file; a scene's meshes have the scale of their import settings.");
                    return BakeScene(what, settings, parsed.GetValue(again), parsed.GetValue(target));
                }
                if (parsed.GetValue(again))
                    throw new HostException("--again is for a scene; a mesh's file is always baked.");

                var run = new BakeRun(what, parsed.GetValue(target), settings, Positive(parsed.GetValue(scale), "--scale"), Console.Out);
                run.Read();
                using var session = new Session(Session.Root());
                run.Bake(session.Assets, session.DescribeDevice());
                return session.ErrorsLogged == 0 ? 0 : 1;
            });
            return command;
        }

        // A name without an ending is that of a scene or of its folder.
        static bool IsScene(string what) => what.EndsWith(".unity", StringComparison.OrdinalIgnoreCase) || Directory.Exists(what)
            || Path.GetExtension(what) == "";

        static int BakeScene(string what, MeshSdfSettings settings, bool again, string pictures)
        {
            LocatedScene located = Session.Locate(what);
            // Not strict: scripts that the host was not built with are nothing to a bake.
            using var session = new Session(located, strict: false);
            session.LoadScene(located);
            Console.Out.WriteLine(session.DescribeDevice());
            var run = new SceneBakeRun(located, session.Assets, settings, again, pictures, Console.Out);
            run.Run();
            return run.Failures == 0 ? 0 : 1;
        }

        static float Positive(float value, string option) => value > 0f && float.IsFinite(value) ? value
            : throw new HostException(string.Create(CultureInfo.InvariantCulture, $"{option} must be above 0, not {value}."));

        internal static int MebiBytes(string text)
        {
            int shift = text.Length == 0 ? 0 : char.ToUpperInvariant(text[^1]) switch { 'K' => 10, 'M' => 20, 'G' => 30, _ => 0 };
            if (!double.TryParse(shift > 0 ? text[..^1] : text, NumberStyles.Float, CultureInfo.InvariantCulture, out double number)
                || !(number >= 0))
                throw new HostException($"--memory {text}: give bytes, or a number with K, M or G, as in 512M.");
            double mebi = Math.Floor(number * (1L << shift) / (1 << 20));
            return mebi is >= 1 and <= int.MaxValue ? (int)mebi
                : throw new HostException($"--memory {text}: the least is 1M, the most {int.MaxValue}M.");
        }

        /// <summary>Parses a choice, such as "open-shell" for OpenShell.</summary>
        internal static T Choice<T>(string text, string option) where T : struct, Enum
        {
            foreach (T value in Enum.GetValues<T>())
                if (string.Equals(text.Replace("-", ""), value.ToString(), StringComparison.OrdinalIgnoreCase))
                    return value;
            throw new HostException($"{option} {text}: it is one of {Choices<T>()}.");
        }

        static string Choices<T>() where T : struct, Enum
            => string.Join(", ", Enum.GetNames<T>()
            .Select(name => string.Concat(name.Select((c, i) => (i > 0 && char.IsUpper(c) ? "-" : "") + char.ToLowerInvariant(c)))));
    }
}
