using System;
using System.Collections.Generic;
using System.Linq;
using Host.Experiments;
using Host.Report.Obstacles;
using Rill;
using Rill.Tests;
using Rill.Tests.Reference;
using Unity.Mathematics;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Host.Report.Extremes
{
    /// <summary>Thin meshes, pistons and cups.</summary>
    static class ObstacleCases
    {
        const string Meshes = "Thin meshes", Pistons = "Pistons", Cups = "Open cups";
        const float Spacing = 0.05f;

        public static IEnumerable<ExtremeCase> All(bool quick)
        {
            int size = quick ? 8 : 24;
            foreach (float tilt in new[] { 0f, 0.5f })
            {
                yield return OnThinMesh(size, "plate 1 d thick", MeshSdfSettings.Default, side => TestMeshes.Box(new Vector3(side, 1f, side)), tilt);
                yield return OnThinMesh(size, "open sheet baked as a shell of 0.5 d", Shell(), TestMeshes.Sheet, tilt);
            }
            foreach (int layers in new[] { 12, 50 })
                foreach (double fraction in new[] { 0.02, 0.2 })
                    yield return Piston(layers, fraction, quick ? 12 : 24, quick ? 2 : 6);
            int seconds = quick ? 2 : 60;
            foreach ((string name, Func<OpenCup> cup) in new (string, Func<OpenCup>)[] { ("wall and floor of 1 d", () => OpenCup.Solid(1f)),
                ("wall and floor of 2 d", () => OpenCup.Solid(2f)), ("open shell of 0.5 d", () => OpenCup.Shell(0.5f)) })
            {
                yield return Cup(name, cup, "gently", OpenCup.Gently, true, seconds);
                yield return Cup(name, cup, "at up to 4 g", OpenCup.Hard, false, seconds);
            }
        }

        static MeshSdfSettings Shell()
        {
            MeshSdfSettings settings = MeshSdfSettings.Default;
            settings.shellThickness = 0.5f;
            return settings;
        }

        static ExtremeCase OnThinMesh(int size, string name, MeshSdfSettings bake, Func<float, TriangleMesh> mesh, float tilt)
            => new(Meshes, FormattableString.Invariant(
            $"block of {size} x {size} x {size} at 100 m/s onto a mesh: {name}; {(tilt == 0f ? "level" : "leaning by 0.5 rad")}; 1 s"),
            (setting, check) =>
        {
            float3 box = new float3(2f, 3f, 2f) * size;
            bake.voxelSize = bake.shellThickness > 0f ? 0.25f : 0.5f;
            // Wider than the box at any tilt, so that nothing goes around it.
            using var field = new BakedMesh(mesh(4f * size), bake);
            ColliderMotion plate = field.Obstacle;
            plate.end.rotation = quaternion.Euler(0f, 0f, tilt);
            plate.end.position = box * new float3(0.5f, 0.35f, 0.5f);
            using var fluid = new ExtremeFluid(box, Spacing, size * size * size, setting.Solver)
                .AddLattice(new float3(0.5f, 1.7f, 0.5f) * size, size, new float3(0f, -100f, 0f));
            int below = 0;
            fluid.StepAmong(plate, _ => plate.end, 60, 2, pose =>
            {
                quaternion back = math.conjugate(pose.rotation);
                below = Math.Max(below, fluid.Read().Count(p => math.mul(back, p - pose.position).y < 0f));
            });
            check.Exactly("most particles through it", below, 0);
            check.AtMost("highest energy over the start's", fluid.MaxEnergy, 1.001);
            check.AtMost("speed", fluid.Counts.SpeedMax, 101, "m/s");
            return fluid.Counts;
        });

        // Layers at rest that fill the box to the piston, which then closes. It reaches the domain's wall wherever it is, as the manual asks for:
        // free volume beyond it would count as room.
        static ExtremeCase Piston(int layers, double fraction, int side, double seconds)
            => new(Pistons, FormattableString.Invariant(
            $"closed box of {side} x {layers} x {side} d of water that a piston presses to {1 + fraction:0.00} of its density in 1 s; ") +
            FormattableString.Invariant($"{seconds:0} s after that"), (setting, check) =>
        {
            const float thickness = 4f, half = 12f;
            float path = (float)(layers - layers / (1 + fraction));
            using var fluid = new ExtremeFluid(new float3(side, layers + thickness, side), Spacing, side * layers * side, setting.Solver)
                .AddLattice(0f, new int3(side, layers, side));
            ColliderMotion piston = Solids.Still(ColliderShape.Box, new float3(2f * side, half, 2f * side), 0f);
            RigidPose Pose(float time) => new RigidPose(new float3(0.5f * side, layers + half - path * math.saturate(time),
                0.5f * side), quaternion.identity);
            int beyond = 0;
            fluid.StepAmong(piston, Pose, (int)Math.Round((1 + seconds) / fluid.Input.timeStep), 10,
                pose => beyond = Math.Max(beyond, fluid.Read().Count(p => p.y > pose.position.y)));
            check.Exactly("most particles past the piston", beyond, 0);
            check.Between("C+ settled", fluid.Settled(s => s.densityError, 1), 0.5 * fraction, 1.3 * fraction, "%");
            check.AtMost("p99.9 of C+ over its mean", fluid.Settled(s => s.densityError999, 1) / fluid.Settled(s => s.densityError, 1), 3);
            check.AtMost("jitter", fluid.Settled(s => s.jitter, 1), 0.05, "m/s");
            check.Exactly("closer than 0.05 d", fluid.Last.coincident, 0);
            return fluid.Counts;
        });

        static ExtremeCase Cup(string name, Func<OpenCup> make, string how, Func<float, RigidPose> motion, bool holds, int seconds)
            => new(Cups, $"cup of {OpenCup.Radius:0} x {OpenCup.Depth:0} d with {name} shaken {how} for {seconds} s", (setting, check) =>
        {
            OpenCup cup = make();
            SignedDistanceField field = cup.Bake(cup.ShellThickness > 0f ? 0.25f : 0.5f);
            try
            {
                float3[] water = OpenCup.Water(motion(0f));
                using var fluid = new ExtremeFluid(OpenCup.Box, Spacing, water.Length, setting.Solver).Add(water);
                var tracer = new OpenCup.Tracer(cup);
                float time = 0f;
                fluid.StepAmong(OpenCup.Obstacle(field, motion(0f)), at => OpenCup.OfField(field, motion(time = at)), seconds * 60, 30,
                    _ => tracer.Observe(fluid.ReadIds(), fluid.Read().Select(p => new float4(p, 0f)).ToArray(), motion(time)));
                check.Exactly("through wall or floor", tracer.Through, 0);
                if (holds)
                    check.Exactly("inside at the end", tracer.Inside, fluid.Added);
                else
                    check.AtLeast("thrown over the rim", tracer.OverTheRim, 0.1 * fluid.Added);
                return fluid.Counts;
            }
            finally
            {
                Object.DestroyImmediate(field.Texture);
                Object.DestroyImmediate(field);
            }
        });

        sealed class BakedMesh : IDisposable
        {
            readonly SignedDistanceField baked;

            /// <param name="mesh">d.</param>
            public BakedMesh(TriangleMesh mesh, in MeshSdfSettings settings) => baked = SignedDistanceField.Create(MeshSdfBaker.Bake(mesh, settings));

            /// <summary>Its field's center is the mesh's.</summary>
            public ColliderMotion Obstacle
            {
                get
                {
                    ColliderMotion motion = Solids.Still(ColliderShape.Mesh, baked.Bounds.extents, 0f);
                    motion.field = baked.Texture;
                    motion.voxel = baked.VoxelSize;
                    motion.fieldUnit = 1f;
                    return motion;
                }
            }

            public void Dispose()
            {
                Object.DestroyImmediate(baked.Texture);
                Object.DestroyImmediate(baked);
            }
        }
    }
}
