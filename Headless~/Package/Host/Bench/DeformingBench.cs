using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using Host.Baking;
using Rill;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace Host.Bench
{
    /// <summary>Times what a Fluid Deforming Mesh does in a frame in which its mesh has moved: a whole field, all in one frame.</summary>
    static class DeformingBench
    {
        const int Bones = 60;
        const string Whole = "Deform";

        static readonly int[] Resolutions = { 32, 64 };
        static readonly int[] Triangles = { 10_000, 100_000 };

        public static void Print(int repeats, int? triangles, int? resolution, bool stages, TextWriter output)
        {
            output.WriteLine($"{"triangles",10}  {"voxels",-16}{"follow",10}{"record",10}{"GPU",10}   medians, ms: {Bones} bones on the CPU, " +
                "the commands on the CPU, one field on the GPU");
            foreach (int size in triangles is int one ? new[] { one } : Triangles)
                foreach (int voxels in resolution is int asked ? new[] { asked } : Resolutions)
                    Print(size, voxels, repeats, stages, output);
        }

        static void Print(int triangles, int resolution, int repeats, bool stages, TextWriter output)
        {
            TriangleMesh lump = BakeBench.Lump(triangles);
            (GameObject owner, Mesh source, Transform[] bones) = Rig(lump);
            DeformedMesh mesh = DeformedMesh.Of(owner.GetComponent<SkinnedMeshRenderer>(), MeshSdfSign.Automatic, out string problem)
                ?? throw new InvalidOperationException(problem);
            Bounds box = mesh.Bounds;
            box.Expand(0.2f * math.cmax((float3)box.size));
            MeshSdfSettings settings = MeshSdfSettings.Default;
            (settings.resolution, settings.padding) = (resolution, 2);
            using var field = new DeformingField(mesh, new SdfGrid(box, settings, mesh.IsShell));
            var times = new List<(double Follow, double Record, DeviceSample[] Gpu)>();
            for (int i = 0; i <= repeats; i++)
            {
                (double, double, DeviceSample[]) frame = Frame(mesh, field, bones, i);
                if (i > 0)      // the first warms up
                    times.Add(frame);
            }
            string Of(Func<(double Follow, double Record, DeviceSample[] Gpu), double> part)
                => times.Select(part).OrderBy(t => t).ElementAt(times.Count / 2).ToString("0.000", CultureInfo.InvariantCulture);
            int3 size = field.Resolution;
            output.WriteLine(string.Create(CultureInfo.InvariantCulture,
                $"{mesh.TriangleCount,10:N0}  " +
                $"{size.x + " x " + size.y + " x " + size.z,-16}{Of(t => t.Follow),10}{Of(t => t.Record),10}{Of(t => Sum(t.Gpu, Whole)),10}"));
            foreach (string name in stages ? times[0].Gpu.Select(sample => sample.Name).Distinct().Where(name => name != Whole)
                : Array.Empty<string>())
                output.WriteLine($"{"",12}{name,-30}{Of(t => Sum(t.Gpu, name)),36}");
            Object.DestroyImmediate(owner);
            Object.DestroyImmediate(source);
        }

        static double Sum(DeviceSample[] samples, string name) => samples.Where(sample => sample.Name == name).Sum(sample => sample.Milliseconds);

        static (double Follow, double Record, DeviceSample[] Gpu) Frame(DeformedMesh mesh, DeformingField field, Transform[] bones, int frame)
        {
            foreach (Transform bone in bones)
                bone.localRotation = Quaternion.Euler(0f, 0f, 3f * MathF.Sin(frame + 1f));
            using var gpu = new DeviceTimes();
            var clock = Stopwatch.StartNew();
            mesh.Follow(0f);
            double followed = clock.Elapsed.TotalMilliseconds;
            Player.Device.BeginSample(Whole);
            field.Begin();
            field.Advance(mesh.TriangleCount);
            Player.Device.EndSample();
            double recorded = clock.Elapsed.TotalMilliseconds;
            Player.Device.WaitIdle();
            return (followed, recorded - followed, gpu.Collect().ToArray());
        }

        // Bones in a row along x, each vertex between the two that are nearest.
        static (GameObject Owner, Mesh Mesh, Transform[] Bones) Rig(TriangleMesh lump)
        {
            var owner = new GameObject("Lump");
            var bones = new Transform[Bones];
            for (int i = 0; i < Bones; i++)
            {
                bones[i] = new GameObject("Bone").transform;
                bones[i].SetParent(owner.transform, false);
                bones[i].localPosition = new Vector3(-1.5f + 3f * i / (Bones - 1), 0f, 0f);
            }
            var source = new Mesh
            {
                name = lump.Name, indexFormat = UnityEngine.Rendering.IndexFormat.UInt32, vertices = lump.Vertices, triangles = lump.Triangles,
                bindposes = Array.ConvertAll(bones, bone => bone.worldToLocalMatrix), boneWeights = Array.ConvertAll(lump.Vertices, Weight),
            };
            var renderer = owner.AddComponent<SkinnedMeshRenderer>();
            (renderer.sharedMesh, renderer.bones) = (source, bones);
            return (owner, source, bones);
        }

        static BoneWeight Weight(Vector3 vertex)
        {
            float at = Math.Clamp((vertex.x + 1.5f) / 3f * (Bones - 1), 0f, Bones - 1.001f);
            return new BoneWeight { boneIndex0 = (int)at, weight0 = 1f - (at - (int)at), boneIndex1 = (int)at + 1, weight1 = at - (int)at };
        }
    }
}
