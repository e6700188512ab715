using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using Host.Assets;
using Host.Output;
using Rill;
using Rill.Editor;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace Host.Baking
{
    /// <summary>From a mesh file to the asset and the picture, saying at each stage what was found and what comes of it.</summary>
    sealed class BakeRun
    {
        readonly string file, folder;
        readonly MeshSdfSettings settings;
        readonly float scale;
        readonly TextWriter output;
        MeshReport report;

        /// <param name="folder">For the results; null for out~/name.</param>
        public BakeRun(string file, string folder, MeshSdfSettings settings, float scale, TextWriter output)
        {
            this.file = file;
            this.folder = ResultsFolder.Of(folder, Path.GetFileNameWithoutExtension(file));
            this.settings = settings;
            this.scale = scale;
            this.output = output;
        }

        public TriangleMesh Mesh { get; private set; }

        public string AssetFile => Path.Combine(folder, Path.GetFileNameWithoutExtension(file) + ".asset");
        public string SlicesFile => Path.Combine(folder, Path.GetFileNameWithoutExtension(file) + "-slices.png");

        /// <summary>Reads and checks the mesh, which takes no device.</summary>
        /// <exception cref="AssetException">The file cannot be read.</exception>
        /// <exception cref="HostException">The mesh or the settings cannot be baked.</exception>
        public void Read()
        {
            MeshFile read = MeshFile.Read(file);
            Mesh = new TriangleMesh(read.Name, scale == 1f ? read.Vertices : Array.ConvertAll(read.Vertices, v => scale * v), read.Triangles);
            Say($"{Path.GetFileName(file)}: {Mesh.TriangleCount:N0} triangles, {Mesh.Vertices.Length:N0} vertices{(read.Parts > 1 ? $", {read.Parts:N0} parts" : "")}; x mirrored into Unity's left-handed frame");
            foreach (string note in read.Notes)
                output.WriteLine("  " + note);

            if (!settings.Validate(out string problem))
                throw new HostException($"'{Mesh.Name}' cannot be baked. {problem}");
            report = MeshCheck.Run(Mesh);
            if (report.Problem != null)
                throw new HostException(report.Problem);
            Say($"check: {(report.IsWatertight ? "watertight" : "not watertight")}, {report.Area:G4} m² of surface, {Math.Abs(report.SignedVolume):G4} m³");
            Say($"  {report.Holes:N0} holes, {report.BoundaryEdges:N0} open edges, {report.NonManifoldEdges:N0} edges of more than two triangles, {report.FlippedTriangles:N0} flipped triangles, {report.ZeroAreaTriangles:N0} without area, {report.SelfIntersections:N0} pairs that cross");
            foreach (string text in report.Texts)
                output.WriteLine("  " + text);
            if (report.Texts.Count == 0)
                output.WriteLine("  nothing is wrong with it");
        }

        /// <summary>With the option that is its remedy.</summary>
        internal static string Text(in MeshLoss loss, in MeshSdfSettings settings)
        {
            if (loss.Remedy is not MeshSdfSettings remedy)
                return loss.Text;
            return loss.Text + (remedy.leaveOutFar != settings.leaveOutFar ? " (--leave-out-far)"
                : remedy.sign != settings.sign ? " (--sign open-shell)"
                : string.Create(CultureInfo.InvariantCulture, $" (--voxel {remedy.voxelSize:G3})"));
        }

        /// <summary>Bakes on the player's device and writes the files. An asset that is there keeps its GUID.</summary>
        public void Bake(ProjectAssets package, string device)
        {
            string script = ScriptGuid(package);
            MeshSdfEstimate estimate = MeshSdfBaker.Estimate(Mesh, settings);
            Say($"estimate: {Text(estimate.Resolution)} voxels of {estimate.VoxelSize:G4} m; {Mega(estimate.TotalBytes)} MiB for the bake, at most {Mega(estimate.TextureBytes)} MiB for the texture; the cap is {settings.memoryCap:N0} MiB");
            if (estimate.Problem != null)
                throw new HostException($"'{Mesh.Name}' cannot be baked. {estimate.Problem}");

            // Which voxels would be too many is the device's to say.
            foreach (MeshLoss loss in report.LossesOf(settings))
                output.WriteLine($"  WARNING: {Text(loss, settings)}");

            SdfBake bake = Measured(out double gpu, out double seconds);
            SignedDistanceField field = SignedDistanceField.Create(bake, SourceGuid());
            string guid;
            try
            {
                guid = AssetWriter.Write(AssetFile, field, script);
            }
            finally
            {
                Object.DestroyImmediate(field.Texture);
                Object.DestroyImmediate(field);
            }

            float inside = bake.Distances.Count(distance => distance < 0f) / (float)bake.Distances.Length;
            Say($"baked on {device}: {gpu:N1} ms on the GPU, {seconds:N2} s in all");
            Say($"  {Text(bake.Resolution)} voxels of {bake.VoxelSize:G6} m, from {Text(bake.Bounds.min)} to {Text(bake.Bounds.max)} m, {100 * inside:0.0} % of them inside");
            Say($"  sign by {(bake.Sign == MeshSdfSign.OpenShell ? $"open shell, {bake.ShellThickness:G4} m thick" : "winding number")}; {(bake.Format == SdfFormat.Half ? 16 : 32)} bits a voxel, storage error at most {bake.StorageError:G3} m ({bake.StorageError / bake.VoxelSize:G3} voxel)");
            output.WriteLine($"{AssetFile} (GUID {guid})");
            if (SlicePicture.Draw(SdfVolume.Of(bake), SlicesFile))
                output.WriteLine(SlicesFile);
        }

        SdfBake Measured(out double gpu, out double seconds)
        {
            IGraphicsDevice device = Player.Device;
            using var times = new DeviceTimes();
            var clock = Stopwatch.StartNew();
            SdfBake bake = null;
            Output.Progress.Run(output, "baking " + Mesh.Name, 1, report =>
            {
                device.BeginSample("Bake");
                bake = MeshSdfBaker.Bake(Mesh, settings, (fraction, stage) =>
                {
                    // The bar shows what the device has done, not what waits for it.
                    device.EndSample();
                    device.WaitIdle();
                    report(fraction, stage);
                    device.BeginSample("Bake");
                    return true;
                });
                device.EndSample();
            });
            seconds = clock.Elapsed.TotalSeconds;
            gpu = times.Collect().Where(sample => sample.Depth == 0).Sum(sample => sample.Milliseconds);
            return bake;
        }

        /// <summary>GUID of the mesh's own asset in a project; "" elsewhere.</summary>
        string SourceGuid()
        {
            string meta = file + ".meta";
            if (!File.Exists(meta))
                return "";
            return MetaFile.TryRead(meta, meta, out MetaFile read, out string problem) ? read.Guid : throw new AssetException(problem);
        }

        internal static string ScriptGuid(ProjectAssets package)
        {
            IEnumerable<AssetEntry> scripts = package.Index.Entries.Where(entry => entry.Extension == ".cs"
                && entry.Name == nameof(SignedDistanceField));
            return scripts.FirstOrDefault()?.Guid ?? throw new HostException($"{nameof(SignedDistanceField)}.cs is not in the project: " +
                $"run rill in Rill's package or in a project that has it, or set RILL_ROOT.");
        }

        void Say(FormattableString text) => output.WriteLine(text.ToString(CultureInfo.InvariantCulture));

        static string Text(Vector3Int v) => $"{v.x} x {v.y} x {v.z}";
        static string Text(Vector3 v) => string.Create(CultureInfo.InvariantCulture, $"({v.x:G5}, {v.y:G5}, {v.z:G5})");
        static string Mega(long bytes) => (bytes / (1024.0 * 1024.0)).ToString("N1", CultureInfo.InvariantCulture);
    }
}
