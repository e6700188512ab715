using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using Host.Baking;
using Rill;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace Host.Bench
{
    /// <summary>Times bakes part by part: what the CPU does before, between and after the dispatches, and what the GPU does.</summary>
    static class BakeBench
    {
        /// <summary>Milliseconds of one bake; the whole is from the mesh to the numbers in memory, the asset comes on top.</summary>
        public readonly record struct Times(double Prepare, double Record, double Gpu, double Result, double Whole, double Asset);

        /// <summary>A closed surface with bumps of all sizes, as near to so many triangles as its rings allow: what a scan is like, at any
        /// size.</summary>
        public static TriangleMesh Lump(int triangles)
        {
            int rings = Math.Max(4, (int)Math.Round(Math.Sqrt(triangles / 4.0))), across = 2 * rings;
            var vertices = new Vector3[2 + (rings - 1) * across];
            vertices[0] = PointOn(0, 0);
            vertices[^1] = PointOn(0, Math.PI);
            for (int ring = 1; ring < rings; ring++)
                for (int i = 0; i < across; i++)
                    vertices[1 + (ring - 1) * across + i] = PointOn(2 * Math.PI * i / across, Math.PI * ring / rings);

            var indices = new List<int>();
            int At(int ring, int i) => ring == 0 ? 0 : ring == rings ? vertices.Length - 1 : 1 + (ring - 1) * across + i % across;
            for (int ring = 0; ring < rings; ring++)
                for (int i = 0; i < across; i++)
                {
                    if (ring > 0)
                        indices.AddRange(new[] { At(ring, i), At(ring, i + 1), At(ring + 1, i) });
                    if (ring < rings - 1)
                        indices.AddRange(new[] { At(ring, i + 1), At(ring + 1, i + 1), At(ring + 1, i) });
                }
            return new TriangleMesh("Lump", vertices, indices.ToArray());
        }

        static Vector3 PointOn(double around, double down)
        {
            double x = Math.Sin(down) * Math.Cos(around), y = Math.Cos(down), z = Math.Sin(down) * Math.Sin(around), radius = 1;
            for (int octave = 1; octave <= 32; octave *= 2)
                radius += 0.12 / octave * Math.Sin(3 * octave * x + octave) * Math.Sin(4 * octave * y) * Math.Cos(2 * octave * z + 1);
            return new Vector3((float)(radius * x), (float)(radius * y), (float)(radius * z));
        }

        /// <summary>One bake on the player's device.</summary>
        public static Times Run(TriangleMesh mesh, in MeshSdfSettings settings, out SdfBake bake)
        {
            IGraphicsDevice device = Player.Device;
            using var gpu = new DeviceTimes();
            var clock = Stopwatch.StartNew();
            using var baker = new MeshSdfBaker(mesh, settings);
            double prepared = clock.Elapsed.TotalMilliseconds;
            device.BeginSample("Bake");
            while (baker.Stage != MeshSdfBaker.ReadingBack)
                baker.Step();
            device.EndSample();
            double recorded = clock.Elapsed.TotalMilliseconds;
            device.WaitIdle();
            double waited = clock.Elapsed.TotalMilliseconds;
            bake = baker.Complete();
            double done = clock.Elapsed.TotalMilliseconds;

            SignedDistanceField field = SignedDistanceField.Create(bake);
            device.WaitIdle();
            double stored = clock.Elapsed.TotalMilliseconds;
            Object.DestroyImmediate(field.Texture);
            Object.DestroyImmediate(field);
            double dispatched = gpu.Collect().Where(sample => sample.Name == "Bake").Sum(sample => sample.Milliseconds);
            return new Times(prepared, recorded - prepared, dispatched, done - waited, done, stored - done);
        }

        /// <summary>Milliseconds of one bake's parts, in order: what the CPU prepares, and each kind of dispatch on the GPU.</summary>
        public static List<(string Part, double Milliseconds)> Parts(TriangleMesh mesh, in MeshSdfSettings settings)
        {
            var parts = new List<(string, double)>();
            var clock = new Stopwatch();
            T Timed<T>(string part, Func<T> work)
            {
                clock.Restart();
                T result = work();
                parts.Add(("CPU " + part, clock.Elapsed.TotalMilliseconds));
                return result;
            }
            MeshSdfSettings asked = settings;
            BakedTriangles triangles = Timed("areas", () => new BakedTriangles(mesh));
            MeshEdges edges = Timed("edges", () => new MeshEdges(triangles));
            bool isShell = asked.sign == MeshSdfSign.OpenShell || asked.sign == MeshSdfSign.Automatic
                && MeshReport.SignOf(edges) == MeshSdfSign.OpenShell;
            var grid = new SdfGrid(triangles.Bounds, asked, isShell);
            BakeGeometry geometry = Timed("order",
                () => new BakeGeometry(mesh, TriangleOrder.Of(triangles), edges.Turned, grid, edges.SignedVolume < 0));
            Timed("hash", mesh.Hash);
            using (Timed("buffers", () => new MeshSdfPasses(geometry, grid))) { }

            using var gpu = new DeviceTimes();
            SdfBake bake = MeshSdfBaker.Bake(mesh, settings);
            Timed("format", () => new SdfBake(mesh.Name, grid, bake.Distances, asked, bake.Sign, bake.TriangleCount));
            foreach (IGrouping<string, DeviceSample> kind in gpu.Collect().GroupBy(sample => sample.Name))
                parts.Add(($"GPU {kind.Key} ({kind.Count()} dispatches)", kind.Sum(sample => sample.Milliseconds)));
            return parts;
        }

        /// <summary>A line for each part of a bake, medians of so many.</summary>
        public static void PrintParts(TriangleMesh mesh, in MeshSdfSettings settings, int repeats, TextWriter output)
        {
            var runs = new List<List<(string Part, double Milliseconds)>>();
            for (int i = 0; i < repeats; i++)
                runs.Add(Parts(mesh, settings));
            for (int part = 0; part < runs[0].Count; part++)
            {
                double median = Median(runs.Select(run => run[part].Milliseconds));
                output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{median,20:0.00}  {runs[0][part].Part}"));
            }
        }

        /// <summary>A line for a mesh: medians of so many bakes after one that warms up.</summary>
        public static void Print(TriangleMesh mesh, in MeshSdfSettings settings, int repeats, TextWriter output)
        {
            Run(mesh, settings, out SdfBake bake);
            var times = new List<Times>();
            for (int i = 0; i < repeats; i++)
                times.Add(Run(mesh, settings, out _));
            string Of(Func<Times, double> part) => Median(times.Select(part)).ToString("0.0", CultureInfo.InvariantCulture);
            output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{mesh.TriangleCount,10:N0}  " +
                $"{bake.Resolution.x + " x " + bake.Resolution.y + " x " + bake.Resolution.z,-16}{Of(t => t.Prepare),10}{Of(t => t.Record),10}{Of(t => t.Result),10}{Of(t => t.Gpu),10}{Of(t => t.Whole),10}{Of(t => t.Asset),10}   {mesh.Name}"));
        }

        static double Median(IEnumerable<double> values)
        {
            List<double> sorted = values.OrderBy(value => value).ToList();
            return sorted[sorted.Count / 2];
        }

        public static void PrintHead(TextWriter output)
            => output.WriteLine(
            $"{"triangles",10}  {"voxels",-16}{"prepare",10}{"record",10}{"result",10}{"GPU",10}{"whole",10}{"asset",10}   medians, ms");
    }
}
