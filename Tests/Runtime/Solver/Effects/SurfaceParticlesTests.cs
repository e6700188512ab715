using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Rill.Tests.Reference;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>Visible parts of the water, against double precision, and on every path to them.</summary>
    public class SurfaceParticlesTests
    {
        // A center and a shape as an element of 32 bytes keeps them: 10 bits for each component of a rotation, halves for lengths.
        const double CenterTolerance = 0.02, ShapeTolerance = 0.05;

        [TestCaseSource(typeof(GpuTest), nameof(GpuTest.Sizes))]
        public void Ellipsoids_of_random_water_are_those_of_the_reference(int count)
        {
            using (var found = new Found(ParticleState.Random(count, seed: count)))
                found.AssertIsReference();
        }

        [Test]
        public void Ellipsoids_of_a_block_in_the_middle_and_in_a_corner_are_those_of_the_reference([Values(0.5f, 5.5f)] float first)
        {
            // A normal that is off by an angle changes the shape of its disc by 3.2 times that, d^2: 0.01 degrees.
            using (var found = new Found(ParticleState.Lattice(20f, first, new int3(12, 8, 10), jitter: 0.2f)))
                Assert.That(found.AssertIsReference(), Is.GreaterThan(0.0).And.LessThan(0.0005), "the smooth surface of thick water");
        }

        [Test]
        public void Ellipsoids_of_a_thin_box_with_water_at_both_walls_are_those_of_the_reference()
        {
            using (var found = new Found(ParticleState.Lattice(new float3(16f, 12f, 2.5f), 0.6f, new int3(10, 6, 2), jitter: 0.1f)))
                found.AssertIsReference();
        }

        [Test]
        public void Without_particles_nothing_is_drawn()
        {
            using (var found = new Found(ParticleState.Random(0, seed: 4)))
            {
                Assert.That(found.Shapes, Is.Empty);
                Assert.That(found.Arguments, Is.EqualTo(ParticleState.ArgumentsFor(0)));
            }
        }

        [Test]
        public void Draw_arguments_are_six_vertices_for_each_ellipsoid_and_once_more_for_two_eyes()
        {
            using (var found = new Found(ParticleState.Random(997, seed: 6)))
                Assert.That(found.Arguments, Is.EqualTo(ParticleState.ArgumentsFor(found.Shapes.Length)));
        }

        [Test]
        public void Two_lists_give_the_ellipsoids_of_one_bit_for_bit()
        {
            ParticleState state = ParticleState.Random(997, seed: 5);
            using (var one = new Found(state))
            using (var two = new Found(state, maxBinding: 96 * 4 * 512))
            {
                Assert.That(two.Stages.Layout.TwoLists);
                Assert.That(two.Bits, Is.EqualTo(one.Bits));
            }
        }

        [Test]
        public void The_same_water_has_the_same_ellipsoids_on_every_run()
        {
            ParticleState state = ParticleState.Random(20011, seed: 7);
            using (var found = new Found(state))
            {
                uint[] first = found.Bits;
                for (int run = 0; run < 3; run++)
                    Assert.That(found.Record().Bits, Is.EqualTo(first), $"run {run}");
            }
        }

        [Test]
        public void Water_asleep_has_the_ellipsoids_of_the_same_water_awake()
        {
            using (var fluid = new TestFluid(new float3(24f, 30f, 24f) * 0.05f, 0.05f, 6000))
            {
                fluid.Input.settings.sleepSpeed = 0.05f;
                fluid.Input.material.velocitySmoothing = 0.5f;
                fluid.AddBlock(0f, new float3(24f, 8f, 24f) * 0.05f);
                uint[] states = null;
                for (int step = 0; step < 400 && (states == null || states.Any(state => state != 0)); step += 20)
                {
                    fluid.Step(20);
                    states = GpuTest.Read<uint>(fluid.Solver.Resting.States, 27);
                }
                Assert.That(states, Is.All.EqualTo(0), "all sleep, and no particle has a list");
                GpuTest.Run(cmd => fluid.Solver.RecordSurface(cmd, fluid.Input));
                AssertAre(SurfaceShape.Read(fluid.Solver), Compare.Points(fluid.Read().positions), fluid.Solver.Layout.DomainSize);
            }
        }

        [Test, Category("LongRun")]
        public void In_deep_water_that_breaks_all_that_is_seen_from_outside_is_drawn()
        {
            const float spacing = 0.02f;
            using (var fluid = new TestFluid(new float3(60f, 48f, 20f) * spacing, spacing, 15360))
            {
                fluid.Input.settings.deepWater = DeepWater.On;
                fluid.Input.settings.iterations = 2;
                fluid.AddBlock(0f, new float3(24f, 32f, 20f) * spacing).Step(50);
                int leftOut = 0, seen = 0;
                for (int time = 0; time < 3; time++)
                {
                    fluid.Step(10);
                    GpuTest.Run(cmd => fluid.Solver.RecordSurface(cmd, fluid.Input));
                    (int hidden, int ofThemSeen) = CountHidden(SurfaceShape.Read(fluid.Solver), Compare.Points(fluid.Read().positions),
                        fluid.Solver.Layout.DomainSize);
                    leftOut += hidden;
                    seen += ofThemSeen;
                }
                Assert.That(leftOut, Is.GreaterThan(15), "gaps within the water that are not drawn");
                // The lists lack a neighbor of what moves fast now and then.
                Assert.That(seen, Is.LessThan(4), "of them seen from outside");
            }
        }

        // Particles that the reference draws and that are not drawn, and how many of them are not behind others from every side.
        static (int hidden, int seen) CountHidden(SurfaceShape[] shapes, double3[] points, double3 box)
        {
            var drawn = new HashSet<int>(shapes.Where(shape => !shape.IsOnWall(box)).Select(shape => shape.particle));
            var reference = new Surface(points, box, drawn.Contains);
            int hidden = 0, seen = 0;
            for (int i = 0; i < points.Length; i++)
            {
                (double weight, double offset) = reference.Sums(i);
                bool isClear = weight < 13.0 || offset > 0.175;     // lists may lack a neighbor
                if (drawn.Contains(i) || !isClear)
                    continue;
                hidden++;
                if (Views.Any(view => !shapes.Any(shape => Covers(shape.center - points[i], view))))
                {
                    seen++;
                    TestContext.Out.WriteLine($"particle {i} at {points[i]} is seen; offset {offset:0.000}");
                }
            }
            return (hidden, seen);
        }

        static readonly double3[] Views =
        {
            new double3(1, 0, 0), new double3(-1, 0, 0), new double3(0, 1, 0), new double3(0, -1, 0), new double3(0, 0, 1), new double3(0, 0, -1),
            math.normalize(new double3(1, 1, 1)), math.normalize(new double3(-1, 1, 1)), math.normalize(new double3(1, 1, -1)),
                math.normalize(new double3(-1, 1, -1)),
        };

        static bool Covers(double3 difference, double3 view)
        {
            double depth = math.dot(difference, view);
            return depth > 2.0 && math.length(difference - depth * view) < 1.0;
        }

        [Test]
        public void Particles_that_no_step_has_moved_are_spheres_of_their_volume()
        {
            using (var fluid = new TestFluid(new float3(20f) * 0.05f, 0.05f, 300))
            {
                GpuTest.Run(cmd => fluid.Solver.RecordSurface(cmd, fluid.Input));
                Assert.That(SurfaceShape.Read(fluid.Solver), Is.Empty, "of an empty fluid");
                fluid.AddBlock(0.2f, 0.25f, velocity: new float3(1.2f, 0f, 0f));
                fluid.Input.settings.substeps = 2;
                GpuTest.Run(cmd => fluid.Solver.RecordSurface(cmd, fluid.Input));
                AssertSpheres(SurfaceShape.Read(fluid.Solver), 0, 125);

                fluid.Step();
                fluid.AddBlock(0.6f, 0.1f, velocity: new float3(1.2f, 0f, 0f));
                GpuTest.Run(cmd => fluid.Solver.RecordSurface(cmd, fluid.Input));
                SurfaceShape[] shapes = SurfaceShape.Read(fluid.Solver);
                AssertSpheres(shapes.Where(shape => shape.particle >= 125).ToArray(), 125, 8);
                foreach (SurfaceShape shape in shapes.Where(shape => shape.particle >= 125))
                    Assert.That(shape.chord.x, Is.EqualTo(1.2 / 0.05 / 120.0).Within(2e-3), "the path of a substep");
            }
        }

        static void AssertSpheres(SurfaceShape[] shapes, int first, int count)
        {
            Assert.That(shapes.Select(shape => shape.particle), Is.EqualTo(Enumerable.Range(first, count)));
            foreach (SurfaceShape shape in shapes)
                Assert.That(math.cmax(math.abs(shape.semiAxes - Math.Pow(0.75 / Math.PI, 1.0 / 3.0))), Is.LessThan(2e-3));
        }

        [Test]
        public void Ellipsoids_move_as_the_water_does()
        {
            using (var fluid = new TestFluid(new float3(40f, 20f, 20f) * 0.05f, 0.05f, 2000))
            {
                fluid.Input.gravity = 0f;
                fluid.AddBlock(new float3(5f) * 0.05f, new float3(10f) * 0.05f, velocity: new float3(1.5f, 0f, 0.75f)).Step(3);
                GpuTest.Run(cmd => fluid.Solver.RecordSurface(cmd, fluid.Input));
                double substep = fluid.Input.timeStep / fluid.Solver.LastSubsteps / 0.05;
                foreach (SurfaceShape shape in SurfaceShape.Read(fluid.Solver))
                    Assert.That(math.distance(shape.chord, new double3(1.5, 0.0, 0.75) * substep), Is.LessThan(0.02), $"particle {shape.particle}");
            }
        }

        [Test]
        public void A_drop_alone_is_a_sphere_where_it_is_and_a_pair_is_one_longish_drop()
        {
            var positions = new[] { new float3(6f, 6f, 6f), new float3(14f, 14f, 14f), new float3(15f, 14f, 14f), new float3(0.5f, 6f, 15f) };
            using (var found = new Found(new ParticleState(20f, positions)))
            {
                Assert.That(found.Shapes.Length, Is.EqualTo(4));
                foreach (SurfaceShape shape in found.Shapes)
                {
                    double3 at = found.Points[shape.particle];
                    bool isPair = at.y > 10.0;
                    if (isPair)
                    {
                        Assert.That(math.distance(shape.center, new double3(14.5, 14.0, 14.0)), Is.LessThan(0.1));
                        Assert.That(math.cmax(shape.semiAxes), Is.InRange(0.9, 1.3));
                        continue;
                    }
                    Assert.That(math.cmax(math.abs(shape.semiAxes - 0.62)), Is.LessThan(2e-3));
                    Assert.That(math.distance(shape.center, at), Is.LessThan(at.x < 1.0 ? 0.13 : 1e-3), "at a wall it is moved until it touches");
                }
            }
        }

        [Test]
        public void Nothing_is_drawn_out_of_the_box([Values(0.5f, 0.8f)] float first)
        {
            using (var found = new Found(ParticleState.Lattice(12f, first, 11, jitter: 0f)))
                foreach (SurfaceShape shape in found.Shapes)
                {
                    double3 reach = shape.Reach;
                    Assert.That(math.cmin(shape.center - reach), Is.GreaterThan(-0.02), $"particle {shape.particle}");
                    Assert.That(math.cmax(shape.center + reach), Is.LessThan(12.02), $"particle {shape.particle}");
                }
        }

        [Test]
        public void What_does_not_fit_is_counted()
        {
            // Five in one corner: each has three walls, and the box no room for so many on its walls.
            using (var found = new Found(ParticleState.Lattice(2.5f, 0.5f, 12, jitter: 0f).With(p => 0f), squeeze: 0.12f))
            {
                uint[] counters = found.Counters;
                Assert.That(counters[(int)SurfaceParticles.Counter.Drawn], Is.EqualTo(SurfaceParticles.CapacityFor(found.Stages.Layout)));
                Assert.That(counters[(int)SurfaceParticles.Counter.DidNotFit], Is.GreaterThan(0));
                Assert.That(counters[(int)SurfaceParticles.Counter.Found], Is.Zero);
            }
        }

        // The largest error among the shapes of the discs that are not on a wall, d^2; above 0.
        static double AssertAre(SurfaceShape[] shapes, double3[] points, double3 box)
        {
            var drawn = new HashSet<int>(shapes.Where(shape => !shape.IsOnWall(box)).Select(shape => shape.particle));
            var reference = new Surface(points, box, drawn.Contains);
            ILookup<int, SurfaceShape> byParticle = shapes.ToLookup(shape => shape.particle);
            double worstCenter = 0.0, worstShape = 0.0, worstDisc = 0.0;
            for (int i = 0; i < points.Length; i++)
            {
                List<Surface.Ellipsoid> expected = reference.Ellipsoids(i);
                List<SurfaceShape> actual = byParticle[i].ToList();
                Assert.That(actual.Count, Is.EqualTo(expected.Count),
                    $"ellipsoids of particle {i} at {points[i]}, whose sums are {reference.Sums(i)}");
                foreach (Surface.Ellipsoid ellipsoid in expected)
                {
                    SurfaceShape nearest = actual.OrderBy(shape => math.distance(shape.center, ellipsoid.center)
                        + (shape.Squares - ellipsoid.shape).Length).First();
                    actual.Remove(nearest);
                    double center = math.distance(nearest.center, ellipsoid.center), shapeError = (nearest.Squares - ellipsoid.shape).Length;
                    Assert.That(center, Is.LessThan(CenterTolerance),
                        $"center of particle {i} at {points[i]}: {nearest.center} instead of {ellipsoid.center}");
                    Assert.That(shapeError, Is.LessThan(ShapeTolerance),
                        $"shape of particle {i} at {points[i]}: {nearest.Squares} instead of {ellipsoid.shape}");
                    worstCenter = Math.Max(worstCenter, center);
                    worstShape = Math.Max(worstShape, shapeError);
                    if (nearest.isDisc && !nearest.IsOnWall(box))
                        worstDisc = Math.Max(worstDisc, shapeError);
                }
            }
            TestContext.Out.WriteLine($"{shapes.Length:N0} ellipsoids of {points.Length:N0} particles, centers within " +
                $"{worstCenter:0.0000} d, shapes within {worstShape:0.0000} d², discs within {worstDisc:0.00000} d²");
            return worstDisc;
        }

        /// <summary>The stage run once over particles that no constraint has moved.</summary>
        sealed class Found : IDisposable
        {
            public readonly SolverStages Stages;
            public readonly double3[] Points;
            readonly SurfaceWorkspace workspace = new SurfaceWorkspace();
            readonly SurfaceParticles stage;

            public Found(ParticleState state, long maxBinding = 0, float squeeze = 1f)
            {
                state.positions = state.positions.Select(p => new float4(0.5f + (p.xyz - 0.5f) * squeeze, 0f)).ToArray();
                Stages = new SolverStages(state, SolverStages.Still(SolverStages.Roomy, FluidMaterial.Water), 0, maxBinding);
                Stages.Sort().Constrain(iterations: 0).UpdateVelocities();
                Stages.Particles.Advance();
                Points = Compare.Points(GpuTest.Read<float4>(Stages.Particles.Positions, Stages.Sorted));
                stage = new SurfaceParticles(Stages.Layout, workspace);
                GpuTest.FillWithGarbage(stage.Particles);
                Record();
            }

            public SurfaceShape[] Shapes => SurfaceShape.Read(stage);
            public uint[] Counters => GpuTest.Read<uint>(stage.Counters, 3);
            public uint[] Arguments => GpuTest.Read<uint>(stage.Arguments, ParticleState.ArgumentCount);

            /// <summary>Bits of all ellipsoids, in one order whatever that of the buffer.</summary>
            public uint[] Bits
            {
                get
                {
                    return GpuTest.Read<SurfaceParticles.Element>(stage.Particles, (int)Counters[(int)SurfaceParticles.Counter.Drawn])
                        .OrderBy(e => e.a.w).ThenBy(e => e.b.x).ThenBy(e => e.a.x).ThenBy(e => e.a.y).ThenBy(e => e.a.z)
                        .SelectMany(e => new[] { e.a.x, e.a.y, e.a.z, e.a.w, e.b.x, e.b.y, e.b.z, e.b.w }).ToArray();
                }
            }

            public Found Record()
            {
                GpuTest.Run(cmd => stage.Record(Stages.Context(cmd), hasSteps: true, hasNew: true, version: 2, substepsSince: 0));
                return this;
            }

            public double AssertIsReference() => AssertAre(Shapes, Points, Stages.Layout.DomainSize);

            public void Dispose()
            {
                stage.Dispose();
                workspace.Dispose();
                Stages.Dispose();
            }
        }
    }
}
