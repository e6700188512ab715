using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>The kernel of the force fields against an oracle on the CPU, and fluids in them.</summary>
    public class ForceFieldTests
    {
        const float Spacing = SolverStages.Spacing;

        static readonly ForceFieldKind[] Kinds = { ForceFieldKind.Direction, ForceFieldKind.Point, ForceFieldKind.Vortex, ForceFieldKind.Wind };

        [Test]
        public void Each_kind_falloff_and_bound_accelerates_as_it_is_defined([ValueSource(nameof(Kinds))] ForceFieldKind kind,
            [Values] ForceFieldFalloff falloff, [Values] ForceFieldBounds bounds)
        {
            ParticleState state = ParticleState.Random(997, 3, speed: 20f);
            var random = new Unity.Mathematics.Random(5);
            for (int i = 0; i < state.Count; i++)
                state.velocities[i].w = random.NextFloat(0f, 1.3f);
            FieldRegion field = Region(kind, falloff, bounds, state.box * 0.5f, 12f);
            float4[] after = Accelerate(state, field);
            int touched = 0;
            for (int i = 0; i < state.Count; i++)
            {
                float3 expected = state.velocities[i].xyz + Oracle(field, state.positions[i].xyz, state.velocities[i], out bool acts) / 60f;
                Assert.That(math.distance(after[i].xyz, expected), Is.LessThan(2e-5f * (1f + math.length(expected))),
                    $"particle at {state.positions[i].xyz}");
                Assert.That(after[i].w, Is.EqualTo(state.velocities[i].w));
                touched += acts ? 1 : 0;
            }
            Assert.That(touched, bounds == ForceFieldBounds.None ? Is.EqualTo(997) : (NUnit.Framework.Constraints.Constraint)Is.InRange(10, 900));
        }

        [Test]
        public void Fields_add_up_and_are_bounded_together()
        {
            ParticleState state = ParticleState.Random(129, 4);
            float limit = ForceFields.MaxAcceleration / Spacing / 60f;
            FieldRegion strong = Region(ForceFieldKind.Direction, ForceFieldFalloff.None, ForceFieldBounds.None, 0f, 0.7f * limit * 60f);
            float3 once = Accelerate(state, strong)[7].xyz;
            float3 twice = Accelerate(state, strong, strong)[7].xyz;
            Assert.That(math.length(once), Is.EqualTo(0.7f * limit).Within(0.01f * limit));
            Assert.That(math.length(twice), Is.EqualTo(limit).Within(0.001f * limit));
            FieldRegion back = strong;
            back.strength = -strong.strength;
            Assert.That(math.length(Accelerate(state, strong, back)[7].xyz), Is.LessThan(1e-4f * limit));
        }

        [Test]
        public void At_the_center_nothing_is_infinite([ValueSource(nameof(Kinds))] ForceFieldKind kind, [Values] ForceFieldFalloff falloff)
        {
            var state = new ParticleState(10f,
                new[] { new float3(5f), new float3(5f + 1e-6f), new float3(5f, 5f, 5.001f), new float3(float.NaN), new float3(1f) });
            state.velocities[4] = new float4(float.PositiveInfinity);
            FieldRegion field = Region(kind, falloff, ForceFieldBounds.Sphere, 5f, 1e9f);
            float4[] after = Accelerate(state, field);
            for (int i = 0; i < 4; i++)
                Assert.That(math.length(after[i].xyz), Is.LessThan(1.001f * ForceFields.MaxAcceleration / Spacing / 60f));
            if (kind == ForceFieldKind.Point || kind == ForceFieldKind.Vortex)
                Assert.That(math.length(after[0].xyz), Is.LessThan(1e-3f), "no direction, no push");
            Assert.That(after[4].x, Is.EqualTo(float.PositiveInfinity), "left to the sort to cull");
        }

        static FieldRegion Region(ForceFieldKind kind, ForceFieldFalloff falloff, ForceFieldBounds bounds, float3 center, float strength)
        {
            float3x3 turn = math.float3x3(quaternion.Euler(0.3f, 0.8f, -0.4f));
            float3 half = bounds == ForceFieldBounds.Sphere ? 4f : new float3(3f, 4.5f, 2f);
            bool bounded = bounds != ForceFieldBounds.None;
            return new FieldRegion
            {
                center = center,
                kind = (uint)kind,
                falloff = (uint)(bounded ? falloff : ForceFieldFalloff.None),
                isSphere = bounds == ForceFieldBounds.Sphere ? 1u : 0u,
                axisX = bounded ? turn.c0 / half.x : 0f,
                axisY = bounded ? turn.c1 / half.y : 0f,
                axisZ = bounded ? turn.c2 / half.z : 0f,
                strength = strength,
                flow = kind == ForceFieldKind.Wind ? turn.c2 * 30f : turn.c2,
                core = 0.4f,
            };
        }

        // Slow and obvious. d, s.
        static float3 Oracle(FieldRegion field, float3 p, float4 velocity, out bool acts)
        {
            float3 away = p - field.center;
            var local = new float3(math.dot(away, field.axisX), math.dot(away, field.axisY), math.dot(away, field.axisZ));
            double t = field.isSphere != 0 ? math.length((double3)local) : math.cmax(math.abs((double3)local));
            acts = t <= 1.0;
            if (!acts)
                return 0f;
            double fraction = 1.0;
            if (field.falloff == (uint)ForceFieldFalloff.Linear)
                fraction = 1.0 - t;
            else if (field.falloff == (uint)ForceFieldFalloff.InverseSquare)
                fraction = t > 0.1 ? 0.01 / (t * t) : 1.0;
            else if (field.falloff == (uint)ForceFieldFalloff.Smooth)
                fraction = (1.0 - t * t) * (1.0 - t * t);
            float strength = (float)(field.strength * fraction);
            switch ((ForceFieldKind)field.kind)
            {
                case ForceFieldKind.Direction:
                    return field.flow * strength;
                case ForceFieldKind.Point:
                    return -away / math.max(math.length(away), field.core) * strength;
                case ForceFieldKind.Vortex:
                    float3 around = math.cross(field.flow, away);
                    return around / math.max(math.length(around), field.core) * strength;
                default:
                    float exposed = math.clamp(1f - velocity.w, 0f, 1f);
                    return (field.flow - velocity.xyz) * (float)((1.0 - Math.Exp(-strength * exposed / 60.0)) * 60.0);
            }
        }

        static float4[] Accelerate(ParticleState state, params FieldRegion[] regions)
        {
            var sources = new StepSources();
            using (var stages = new SolverStages(state, SolverStages.Still()))
            using (var fields = new ForceFields())
            {
                foreach (FieldRegion region in regions)
                    sources.Add(region);
                GpuTest.Run(cmd =>
                {
                    fields.Upload(cmd, sources);
                    fields.Record(stages.Context(cmd));
                });
                return GpuTest.Read<float4>(stages.Particles.Velocities, state.Count);
            }
        }

        // ---- fluids

        [Test]
        public void A_field_against_gravity_holds_the_water_up_and_more_of_it_lifts_it([Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            using (var scene = new SourceScene(new Vector3(0.5f, 1f, 0.5f), 0.05f, 1000, deepWater).Fill(0.2f))
            {
                FluidForceField field = scene.Add<FluidForceField>(Vector3.zero, Vector3.up, f => f.Strength = 9.81f);
                scene.Step(20);
                Assert.That(scene.AssertConserved().speed, Is.LessThan(0.05f));
                field.Strength = 2f * 9.81f;
                FluidStatistics lifted = scene.Step(90).AssertConserved();
                Assert.That(lifted.centerOfMass.y, Is.EqualTo(0.9f).Within(0.05f), "it lies under the ceiling");
            }
        }

        [Test]
        public void A_uniform_field_is_as_much_gravity()
        {
            ParticleState Fall(Vector3 gravity, float strength)
            {
                using (var scene = new SourceScene(new Vector3(0.5f, 0.5f, 0.5f), 0.05f, 1000).Fill(0.2f))
                {
                    scene.Fluid.Gravity = gravity;
                    scene.Add<FluidForceField>(Vector3.zero, Vector3.right, f => f.Strength = strength);
                    scene.Step(20);
                    return scene.Read();
                }
            }
            TestFluid.AssertSame(Fall(new Vector3(0f, -9.81f, 0f), 3f), Fall(new Vector3(3f, -9.81f, 0f), 0f));
        }

        [Test, Category("LongRun")]
        public void A_point_gathers_the_water_into_a_ball_without_a_hole_or_an_explosion([Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), 0.05f, 2000, deepWater).Fill(0.1f))
            {
                scene.Fluid.Gravity = Vector3.zero;
                scene.Add<FluidForceField>(Vector3.zero, Vector3.up, f =>
                {
                    f.Kind = ForceFieldKind.Point;
                    f.Strength = 10f;
                });
                scene.Add<FluidForceField>(Vector3.zero, Vector3.up, f =>      // damps
                {
                    f.Kind = ForceFieldKind.Wind;
                    f.Strength = 0f;
                    f.Drag = 10f;
                });
                FluidStatistics statistics = scene.Step(300).AssertConserved();
                float mean = scene.Read().positions.Average(p => math.distance(p.xyz, 10f)) * 0.05f;
                float ball = math.pow(0.1f / (4f / 3f * math.PI), 1f / 3f);
                TestContext.Out.WriteLine($"mean distance {mean:0.000} m, of a ball {0.75f * ball:0.000} m, C+ " +
                    $"{statistics.densityError:0.000}, speed {statistics.speed:0.00} m/s");
                Assert.That(mean, Is.EqualTo(0.75f * ball).Within(0.04f));
                Assert.That(statistics.densityError, Is.LessThan(0.1f));
            }
        }

        [Test]
        public void A_vortex_turns_the_water_about_its_axis_and_a_wind_drags_its_surface()
        {
            using (var scene = new SourceScene(new Vector3(1f, 0.4f, 1f), 0.05f, 2000).Fill(0.2f))
            {
                scene.Add<FluidForceField>(Vector3.zero, Vector3.up, f =>
                {
                    f.Kind = ForceFieldKind.Vortex;
                    f.Strength = 4f;
                });
                ParticleState turned = scene.Step(40).Read();
                Assert.That(Enumerable.Range(0, turned.Count)
                    .Average(i => math.cross(turned.positions[i].xyz - 10f, turned.velocities[i].xyz).y), Is.GreaterThan(2f),
                    "up is the axis: counter-clockwise from below in a left-handed frame");
            }
            using (var scene = new SourceScene(new Vector3(1f, 0.4f, 1f), 0.05f, 2000).Fill(0.2f))
            {
                scene.Add<FluidForceField>(Vector3.zero, Vector3.right, f =>
                {
                    f.Kind = ForceFieldKind.Wind;
                    f.Strength = 10f;
                    f.Drag = 5f;
                });
                ParticleState blown = scene.Step(20).Read();
                float surface = Enumerable.Range(0, blown.Count).Where(i => blown.positions[i].y > 3f).Average(i => blown.velocities[i].x);
                float floor = Enumerable.Range(0, blown.Count).Where(i => blown.positions[i].y < 1f).Average(i => blown.velocities[i].x);
                TestContext.Out.WriteLine($"surface {surface * 0.05f:0.00} m/s, floor {floor * 0.05f:0.00} m/s");
                Assert.That(surface, Is.GreaterThan(floor + 1f));
            }
        }

        [Test, Category("LongRun")]
        public void The_strongest_field_explodes_nothing([ValueSource(nameof(Kinds))] ForceFieldKind kind)
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), 0.05f, 2000).Fill(0.2f))
            {
                scene.Add<FluidForceField>(new Vector3(0.1f, -0.3f, 0f), new Vector3(1f, 1f, 0f), f =>
                {
                    f.Kind = kind;
                    f.Strength = 1000f;
                    f.Drag = 1000f;
                });
                FluidStatistics statistics = scene.Step(30).AssertConserved();
                TestContext.Out.WriteLine($"C+ {statistics.densityError:0.00}, speed {statistics.speed:0.0}, at most " +
                    $"{statistics.speedMax:0.0} m/s, {statistics.substeps} substeps");
                Assert.That(statistics.nonFinite, Is.Zero);
                // Half as fast again as it is: 5, 18, 51 and 24 m/s.
                Assert.That(statistics.speedMax, Is.LessThan(kind == ForceFieldKind.Direction ? 8f : kind == ForceFieldKind.Point ? 27f
                    : kind == ForceFieldKind.Vortex ? 77f : 36f));
            }
        }

        [Test]
        public void Sleeping_water_wakes_when_a_field_comes_and_sleeps_under_one_that_stays()
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), 0.05f, 3000).Fill(0.2f))
            {
                SolverSettings settings = scene.Fluid.Settings;
                settings.sleepSpeed = 0.5f;
                scene.Fluid.Settings = settings;
                scene.Step(60);
                ParticleState asleep = scene.Read();
                scene.Step(5);
                TestFluid.AssertSame(scene.Read(), asleep);
                scene.Add<FluidForceField>(Vector3.zero, Vector3.right, f => f.Strength = 1f);
                scene.Step(10);
                Assert.That(scene.Measure().momentum.x, Is.GreaterThan(1f));
                scene.Step(120);
                ParticleState again = scene.Read();
                scene.Step(5);
                TestFluid.AssertSame(scene.Read(), again);
            }
        }

        // A direction without bounds counts as gravity, whose changes wake by themselves.
        [Test, Category("LongRun")]
        public void Water_that_sleeps_under_a_field_flows_once_the_field_is_gone([Values] ForceFieldBounds bounds)
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), 0.05f, 3000).Fill(0.2f))
            {
                SolverSettings settings = scene.Fluid.Settings;
                settings.sleepSpeed = 0.5f;
                scene.Fluid.Settings = settings;
                FluidForceField field = scene.Add<FluidForceField>(Vector3.zero, Vector3.right, f =>
                {
                    f.Strength = 1f;
                    f.Bounds = bounds;
                    f.Size = 4f * Vector3.one;
                    f.Radius = 4f;
                });
                scene.Step(120);
                ParticleState asleep = scene.Read();
                scene.Step(5);
                TestFluid.AssertSame(scene.Read(), asleep);
                field.enabled = false;
                scene.Step(10);
                Assert.That(scene.Measure().momentum.x, Is.LessThan(-1f), "kg m/s");
            }
        }
    }
}
