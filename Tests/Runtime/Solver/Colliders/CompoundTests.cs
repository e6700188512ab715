using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Rill.Tests.Reference;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>Colliders put together from several bodies, side by side or in one another: as one body of the same outline. Lengths in d.</summary>
    [Category("LongRun")]
    public class CompoundTests
    {
        const float Spacing = 0.05f;
        const float FloorTop = 4f;

        public enum Kind
        {
            Slab, Tiles, Stacked, LStanding, LThrough, LAdjacent, T, Corner, Twice, Crossing, Bend, HalfSunk, MeshOnBox,
        }

        SignedDistanceField ball;

        [OneTimeTearDown]
        public void DestroyField()
        {
            if (ball == null)
                return;
            Object.DestroyImmediate(ball.Texture);
            Object.DestroyImmediate(ball);
        }

        // If edges of two overlapping boxes lie in one line, the edge counts as if it were a face: by half of what lies beyond a face.
        // For a round surface the half space beyond it counts, which is more than it holds.
        [TestCase(Kind.Slab, 0.012f)]
        [TestCase(Kind.Tiles, 0.012f)]
        [TestCase(Kind.Stacked, 0.012f)]
        [TestCase(Kind.LStanding, 0.02f)]
        [TestCase(Kind.LThrough, 0.02f)]
        [TestCase(Kind.LAdjacent, 0.02f)]
        [TestCase(Kind.T, 0.02f)]
        [TestCase(Kind.Corner, 0.11f)]
        [TestCase(Kind.Twice, 0.11f)]
        [TestCase(Kind.Crossing, 0.11f)]
        [TestCase(Kind.Bend, 0.08f)]
        [TestCase(Kind.HalfSunk, 0.08f)]
        public void A_compound_adds_the_density_of_all_that_is_solid_once(Kind kind, float error)
        {
            ColliderMotion[] bodies = Make(kind);
            var random = new Unity.Mathematics.Random(3u);
            var positions = new List<float3>();
            while (positions.Count < 200)
            {
                float3 p = random.NextFloat3(2.1f, 21.9f);
                if (Distance(bodies, p) > 0.45 && Distance(bodies, p) < 1.2)
                    positions.Add(p);
            }
            float4[] boundary = BoundaryOver(positions.ToArray(), bodies);
            double worst = 0.0;
            for (int i = 0; i < positions.Count; i++)
            {
                double off = boundary[i].w - DensityOf(bodies, positions[i]);
                worst = Math.Max(worst, Math.Abs(off));
                Assert.That(off, Is.EqualTo(0.0).Within(error), $"too much at {positions[i]}");
            }
            TestContext.Out.WriteLine($"{worst:0.000} at most");
        }

        [TestCase(Kind.Tiles)]
        [TestCase(Kind.Stacked)]
        public void A_floor_of_several_bodies_adds_what_one_does_wherever_they_meet(Kind kind)
        {
            float3[] positions = Enumerable.Range(0, 900)
                .Select(i => new float3(6f + 0.4f * (i % 30), FloorTop + 0.5f + 0.03f * (i / 30 % 7), 6f + 0.4f * (i / 30))).ToArray();
            float4[] one = BoundaryOver(positions, Make(Kind.Slab)), several = BoundaryOver(positions, Make(kind));
            for (int i = 0; i < positions.Length; i++)
                Assert.That(math.length(several[i] - one[i]), Is.LessThan(0.01f * math.length(one[i])),
                    $"{several[i]} instead of {one[i]} at {positions[i]}");
        }

        [Test]
        public void A_floor_on_the_floor_of_the_domain_counts_once([Values(ColliderShape.Plane, ColliderShape.Box)] ColliderShape shape,
            [Values(1, 2)] int times)
        {
            var position = new[] { new float3(9f, 0.5f, 9f) };
            ColliderMotion floor = ColliderTests.Still(shape, shape == ColliderShape.Box ? new float3(30f, 2f, 30f) : 0f,
                new float3(9f, shape == ColliderShape.Box ? -2f : 0f, 9f), quaternion.identity);
            Assert.That(BoundaryOver(position, Enumerable.Repeat(floor, times).ToArray())[0].w, Is.EqualTo(0f).Within(1e-4f),
                "the domain's own floor is there already");
            var above = new[] { new float3(9f, 4.5f, 9f) };
            floor.start.position.y = floor.end.position.y += 4f;
            Assert.That(BoundaryOver(above, Enumerable.Repeat(floor, times).ToArray())[0].w,
                Is.EqualTo((float)Walls.PlaneDensity(0.5)).Within(1e-3f));
        }

        [Test]
        public void Water_rests_on_tiles_as_on_one_body([Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            Rest one = RestOn(deepWater, Make(Kind.Slab));
            foreach (float overlap in new[] { 0f, 1f })
            {
                Rest tiles = RestOn(deepWater, Tiles(overlap));
                Assert.That(tiles.densityError, Is.LessThan(one.densityError + 0.002f), "C+");
                Assert.That(tiles.jitter, Is.LessThan(one.jitter + 0.02f), "jitter");
                Assert.That(tiles.height, Is.EqualTo(one.height).Within(0.03f), "mean height");
                Assert.That(tiles.overSeams, Is.EqualTo(one.overSeams).Within(0.06f), "height of the lowest layer over the seams");
                // The grid's fraction of the force is counted in faces of its cells, which the seams divide.
                Assert.That(tiles.force.y, Is.EqualTo(one.force.y)
                    .Within((deepWater == DeepWater.On ? 0.1f : 0.01f) * math.abs(one.force.y)),
                    "the sum of the forces, in the water's weight");
                Assert.That(math.length(tiles.force.xz), Is.LessThan(0.005f), "nothing pushes sideways");
            }
        }

        // Bodies that overlap, and edges that others hide, must not stop what slides along them.
        [Test]
        public void A_film_keeps_its_speed_across_seams([Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            float one = SlideOver(deepWater, new[] { Box(new float3(-4f, 0f, -4f), new float3(84f, FloorTop, 16f)) });
            foreach (float overlap in new[] { 0f, 1f })
            {
                ColliderMotion[] tiles = Enumerable.Range(0, 22)
                    .Select(i => Box(new float3(7.3f * (i / 2) - 4f - overlap, 0f, i % 2 == 0 ? -4f : 6f - overlap),
                    new float3(7.3f * (i / 2) + 3.3f, FloorTop, i % 2 == 0 ? 6f : 16f))).ToArray();
                Assert.That(SlideOver(deepWater, tiles), Is.EqualTo(one).Within(0.007f),
                    $"fraction of the speed that is left, with an overlap of {overlap} d");
            }
        }

        [Test]
        public void Nobody_gets_into_a_compound([Values(Kind.LAdjacent, Kind.T, Kind.Corner, Kind.Crossing, Kind.Bend, Kind.HalfSunk,
            Kind.MeshOnBox)] Kind kind, [Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            ColliderMotion[] bodies = Make(kind);
            using (TestFluid fluid = Water(24f, deepWater, 2000))
            {
                ParticleState block = ParticleState.Lattice(0f, 0.5f, new int3(14, 16, 8), 0.02f);
                fluid.Add(block.positions.Select(p => p.xyz + new float3(5f, 7f, 8f)).Where(p => Distance(bodies, p) >= 0.5)
                    .Select(p => p * Spacing).ToArray(), new float3(3f, -4f, 2f));
                ColliderTests.Use(fluid, bodies);
                for (int i = 0; i < 8; i++)
                {
                    fluid.Step(4).MeasureWhole();
                    float4 worst = fluid.Read().positions.OrderBy(p => Distance(bodies, p.xyz)).First();
                    Assert.That(Distance(bodies, worst.xyz), Is.GreaterThan(kind == Kind.MeshOnBox ? 0.4 : 0.45),
                        $"at {worst.xyz} after {4 * i + 4} steps");
                }
            }
        }

        // Each of the eight is as small as a cell of the coarse grid, which looks at eight points of it.
        [Test]
        public void Eight_boxes_are_lifted_as_the_one_that_they_make()
        {
            var center = new float3(9f, 8f, 11f);
            quaternion turn = quaternion.Euler(0.3f, 0.2f, 0.1f);
            const float half = 4f;
            ColliderMotion whole = ColliderTests.Still(ColliderShape.Box, half, center, turn);
            ColliderMotion[] eight = Enumerable.Range(0, 8)
                .Select(i => ColliderTests.Still(ColliderShape.Box, 0.5f * half,
                center + math.mul(turn, (new float3(i & 1, i >> 1 & 1, i >> 2) - 0.5f) * half), turn)).ToArray();
            float3 one = LiftOf(whole, whole), all = LiftOf(whole, eight);
            Assert.That(all.y, Is.EqualTo(one.y).Within(0.2f), "lift, in the displaced water's weight");
            Assert.That(math.length(all.xz), Is.LessThan(0.06f), "nothing pushes sideways");
        }

        // Force on bodies under still water, in the weight of the water in their outline.
        static float3 LiftOf(ColliderMotion outline, params ColliderMotion[] bodies)
        {
            using (TestFluid fluid = Water(new float3(20f, 20f, 20f), DeepWater.On, 7000))
            {
                fluid.AddAround(outline, 0f, new float3(20f, 16f, 20f));
                UseReacting(fluid, bodies);
                fluid.Step(30);
                ReadForce(fluid);
                float3 force = ReadForce(fluid.Step(30))
                    / (FluidMaterial.Water.density * 9.81f * 8f * outline.size.x * outline.size.y * outline.size.z * math.pow(Spacing, 3));
                TestContext.Out.WriteLine($"{bodies.Length}: {force} of the displaced water's weight");
                return force;
            }
        }

        struct Rest
        {
            public float densityError, jitter, height, overSeams;
            public float3 force;
        }

        // Six layers on a floor, after 50 steps; the force is the mean over the next 20, in the water's weight.
        static Rest RestOn(DeepWater deepWater, ColliderMotion[] floor)
        {
            using (TestFluid fluid = Water(new float3(24f, 14f, 12f), deepWater, 2000))
            {
                UseReacting(fluid, floor);
                fluid.AddBlock(new float3(0f, FloorTop, 0f) * Spacing, new float3(24f, 6f, 12f) * Spacing);
                FluidStatistics settled = fluid.Step(50).MeasureWhole();
                ReadForce(fluid);
                float3 force = ReadForce(fluid.Step(20));
                float4[] lowest = fluid.Read().positions.Where(p => p.y < FloorTop + 1f).ToArray();
                var result = new Rest
                {
                    densityError = settled.densityError,
                    jitter = settled.jitter,
                    height = settled.centerOfMass.y / Spacing,
                    overSeams = lowest.Where(p => Seams.Any(seam => math.abs(p.x - seam) < 0.7f || math.abs(p.z - seam) < 0.7f)).Average(p => p.y),
                    force = force / (fluid.Added * fluid.Input.material.density * math.pow(Spacing, 3) * 9.81f),
                };
                TestContext.Out.WriteLine($"{floor.Length}: C+ {result.densityError:0.0000}, jitter {result.jitter:0.000} m/s, height " +
                    $"{result.height:0.000}, over seams {result.overSeams:0.000}, force {result.force}");
                return result;
            }
        }

        // Three layers for half a second: the fraction of their speed that is left.
        static float SlideOver(DeepWater deepWater, ColliderMotion[] floor)
        {
            using (TestFluid fluid = Water(new float3(76f, 20f, 12f), deepWater, 1000))
            {
                ColliderTests.Use(fluid, floor);
                fluid.AddBlock(new float3(4f, FloorTop, 0f) * Spacing, new float3(24f, 3f, 12f) * Spacing, new float3(1.5f, 0f, 0f));
                double before = fluid.Read().velocities.Average(v => v.x);
                for (int i = 0; i < 30; i++)
                    Assert.That(fluid.Step().Read().positions.Min(p => Distance(floor, p.xyz)), Is.GreaterThan(0.45), $"step {i}");
                fluid.MeasureWhole();
                float kept = (float)(fluid.Read().velocities.Average(v => v.x) / before);
                TestContext.Out.WriteLine($"{floor.Length}: {kept:0.0000} of the speed is left");
                return kept;
            }
        }

        static readonly float[] Seams = { 8f, 16f };

        static ColliderMotion[] Tiles(float overlap)
        {
            var edges = new[] { -4f, Seams[0], Seams[1], 28f };
            return Enumerable.Range(0, 9).Select(i => Box(new float3(edges[i % 3] - overlap, 0f, edges[i / 3] - overlap),
                new float3(edges[i % 3 + 1], FloorTop, edges[i / 3 + 1]))).ToArray();
        }

        ColliderMotion[] Make(Kind kind)
        {
            ColliderMotion slab = Box(new float3(-4f, 0f, -4f), new float3(28f, FloorTop, 28f));
            switch (kind)
            {
                case Kind.Slab: return new[] { slab };
                case Kind.Tiles: return Tiles(0f);
                case Kind.Stacked: return Enumerable.Range(0, 4).Select(i => Box(new float3(-4f, i, -4f), new float3(28f, i + 1f, 28f))).ToArray();
                case Kind.LStanding: return new[] { slab, Box(new float3(-4f, FloorTop, -4f), new float3(8f, 14f, 28f)) };
                case Kind.LThrough: return new[] { slab, Box(new float3(-4f, 0f, -4f), new float3(8f, 14f, 28f)) };
                case Kind.LAdjacent:
                    return new[] { Box(new float3(8f, 0f, -4f), new float3(28f, FloorTop, 28f)),
                    Box(new float3(-4f, 0f, -4f), new float3(8f, 14f, 28f)) };
                case Kind.T:
                    return new[] { Box(new float3(10f, 4f, 8f), new float3(14f, 10f, 16f)),
                    Box(new float3(6f, 10f, 8f), new float3(18f, 14f, 16f)) };
                case Kind.Corner:
                    return new[] { Box(new float3(6f, 4f, 6f), new float3(10f, 14f, 18f)),
                    Box(new float3(6f, 4f, 6f), new float3(18f, 14f, 10f)) };
                case Kind.Twice:
                    return new[] { Box(new float3(6f, 4f, 6f), new float3(18f, 14f, 18f)),
                    Box(new float3(6f, 4f, 6f), new float3(18f, 14f, 18f)) };
                case Kind.Crossing:
                    return new[] { 0f, 45f }.Select(angle => ColliderTests.Still(ColliderShape.Box, new float3(8f, 3f, 3f),
                    new float3(12f, 9f, 12f), quaternion.RotateY(math.radians(angle)))).ToArray();
                case Kind.Bend: return Bend(6);
                case Kind.HalfSunk:
                    return new[] { Box(new float3(5f, 2f, 5f), new float3(19f, 8f, 19f)),
                    ColliderTests.Still(ColliderShape.Sphere, 4f, new float3(12f, 8f, 12f), quaternion.identity) };
                default: return new[] { Box(new float3(5f, 2f, 5f), new float3(19f, 8f, 19f)), Ball(new float3(12f, 10f, 12f)) };
            }
        }

        // A pipe of capsules through a quarter of a circle.
        static ColliderMotion[] Bend(int pieces)
        {
            float3[] joints = Enumerable.Range(0, pieces + 1).Select(i => 0.5f * math.PI * i / pieces)
                .Select(angle => new float3(5f, 5f, 12f) + 13f * new float3(math.sin(angle), 1f - math.cos(angle), 0f)).ToArray();
            return Enumerable.Range(0, pieces).Select(i =>
            {
                float3 path = joints[i + 1] - joints[i];
                return ColliderTests.Still(ColliderShape.Capsule, new float3(2.5f, 0.5f * math.length(path), 0f),
                    0.5f * (joints[i] + joints[i + 1]), quaternion.RotateZ(math.atan2(path.y, path.x) - 0.5f * math.PI));
            }).ToArray();
        }

        // A sphere of radius 3 as a mesh.
        const float BallRadius = 3f;

        ColliderMotion Ball(float3 center)
        {
            if (ball == null)
            {
                MeshSdfSettings settings = MeshSdfSettings.Default;
                settings.voxelSize = 0.5f;
                ball = SignedDistanceField.Create(MeshSdfBaker.Bake(TestMeshes.Sphere(BallRadius, 32, Vector3.zero), settings));
            }
            Bounds bounds = ball.Bounds;
            var pose = new RigidPose(center + (float3)bounds.center, quaternion.identity);
            return new ColliderMotion
            {
                shape = ColliderShape.Mesh, size = bounds.extents, start = pose, end = pose,
                contributesDensity = true, field = ball.Texture, voxel = ball.VoxelSize, fieldUnit = 1f
            };
        }

        static double Distance(ColliderMotion[] bodies, double3 p)
            => bodies.Min(body => body.shape == ColliderShape.Mesh ? math.distance(p, (double3)body.end.position) - BallRadius
            : Shapes.Distance(body, p));

        // Density of all that is solid within the support, like water at rest, by points spread evenly in it.
        static double DensityOf(ColliderMotion[] bodies, double3 p)
        {
            const double step = 0.2;
            var random = new Unity.Mathematics.Random(11u);
            double sum = 0.0;
            for (int x = -10; x < 10; x++)
                for (int y = -10; y < 10; y++)
                    for (int z = -10; z < 10; z++)
                    {
                        double3 offset = ((double3)random.NextFloat3() + new double3(x, y, z)) * step;
                        double weight = Kernels.Poly6(math.length(offset));
                        if (weight > 0.0 && Distance(bodies, p + offset) <= 0.0)
                            sum += weight;
                    }
            return sum * step * step * step * 2.0 * Walls.PlaneDensity(0.0);
        }

        static ColliderMotion Box(float3 low, float3 high)
            => ColliderTests.Still(ColliderShape.Box, 0.5f * (high - low), 0.5f * (low + high), quaternion.identity);

        static TestFluid Water(float3 box, DeepWater deepWater, int capacity)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = deepWater;
            return new TestFluid(box * Spacing, Spacing, capacity, settings);
        }

        static float4[] BoundaryOver(float3[] positions, params ColliderMotion[] motions)
        {
            using (TestFluid fluid = Water(24f, DeepWater.Off, positions.Length))
            {
                ColliderTests.Use(fluid, motions);
                fluid.Step();
                fluid.Add(positions.Select(p => p * Spacing).ToArray());
                GpuTest.Run(cmd => fluid.Solver.RecordStatistics(cmd, fluid.Input));
                return GpuTest.Read<float4>(fluid.Solver.Colliders.Boundary, positions.Length);
            }
        }

        static void UseReacting(TestFluid fluid, ColliderMotion[] bodies)
        {
            ColliderTests.Use(fluid, bodies);
            for (int i = 0; i < bodies.Length; i++)
                fluid.Input.colliders.Items[i].reacts = true;
        }

        // Mean of the sum of the forces on all bodies since the last call, N.
        static float3 ReadForce(TestFluid fluid)
        {
            ColliderReactions reactions = fluid.Solver.Reactions;
            GpuTest.Run(reactions.RecordTake);
            reactions.Request();
            AsyncGPUReadback.WaitAllRequests();
            double3 all = new double3(0.0);
            for (int i = 0; i < fluid.Input.colliders.Count; i++)
            {
                reactions.Get(i, out double3 sum, out _);
                all += sum;
            }
            float substep = fluid.Input.timeStep / fluid.Input.settings.substeps;
            return (float3)(all * (-fluid.Input.material.density * math.pow(Spacing, 4) / (substep * reactions.Duration)));
        }
    }
}
