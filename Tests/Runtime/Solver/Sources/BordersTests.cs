using System;
using System.Collections.Generic;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using static System.FormattableString;

namespace Rill.Tests
{
    /// <summary>Absorbing and open sides of the box.</summary>
    public class BordersTests
    {
        const float Wave = 80f;         // d
        const int Layers = 16;

        // A wall shows what the tank measures: its waves lose part of their energy on the way to the wall and back.
        [TestCase(BorderKind.Wall, 0f, 0.35, 1.2)]
        [TestCase(BorderKind.Absorbing, 40f, 0.0, 0.05)]
        [Category("LongRun")]
        public void A_band_of_half_a_wave_length_sends_less_than_5_percent_back(BorderKind kind, float width, double least, double most)
            => AssertReflected(kind, width, 0, false, least, most);

        [Category("GpuOnly")]
        [TestCase(BorderKind.Wall, 0f, 2, true, 0.35, 1.2)]
        [TestCase(BorderKind.Absorbing, 40f, 2, true, 0.0, 0.05)]
        public void A_band_absorbs_alike_at_another_side(BorderKind kind, float width, int axis, bool isReversed, double least, double most)
            => AssertReflected(kind, width, axis, isReversed, least, most);

        static void AssertReflected(BorderKind kind, float width, int axis, bool isReversed, double least, double most)
        {
            using (var tank = new WaveTank(Wave, Layers, 1.5f, kind, width, axis, isReversed))
            {
                (double incident, double reflected) = tank.Run();
                TestContext.WriteLine(Invariant($"{kind} {width} d: waves of {incident:0.00} d, {100 * reflected:0.0} % of their energy come back"));
                Assert.That(incident, Is.GreaterThan(0.3));
                Assert.That(reflected, Is.InRange(least, most));
            }
        }

        // 2.2 is the integral of the rate over the band, in the speed of long waves.
        [Test]
        public void A_lone_particle_slows_across_gravity_at_the_rate_of_its_place([Values(0, 1, 2, 3)] int side)
        {
            const float Spacing = 0.1f, Width = 1f, At = 0.3f, Speed = 0.5f, Box = 4f;
            int axis = side < 2 ? 0 : 2;
            var velocity = new float3(0f, 0f, 0f);
            velocity[axis] = Speed;
            velocity[2 - axis] = -Speed;
            float3 position = 2f;
            position[axis] = (side & 1) != 0 ? Box - At : At;
            using (var walled = new TestFluid(Box, Spacing, 10))
            using (var fluid = new TestFluid(Box, Spacing, 10))
            {
                FluidBorders borders = FluidBorders.Default;
                borders[side] = new FluidBorder { kind = BorderKind.Absorbing, width = Width };
                fluid.Input.borders = borders;
                float3 before = walled.Add(new[] { position }, velocity).Step().Read().velocities[0].xyz;
                float3 after = fluid.Add(new[] { position }, velocity).Step().Read().velocities[0].xyz;
                double rate = 2 * 2.2 * Math.Sqrt(9.81 * Spacing) / Width * (1 - At / Width), left = Math.Exp(-rate / 60);
                Assert.That(left, Is.LessThan(0.97));
                Assert.That(after[axis] / before[axis], Is.EqualTo(left).Within(1e-4));
                Assert.That(after[2 - axis] / before[2 - axis], Is.EqualTo(left).Within(1e-4));
                Assert.That(after.y, Is.EqualTo(before.y).Within(1e-5 * math.abs(before.y)));
            }
        }

        // Its rate has the integral 1.5 sqrt(g level) + 8 v over the band, and its velocity grows over the outer half of that. In a corner the rates
        // of both bands add up, and each draws to its own velocity.
        [Test]
        public void A_lone_particle_at_an_open_side_comes_to_its_velocity([Values(0, 1, 2, 3)] int side, [Values] bool inCorner)
        {
            const float Spacing = 0.1f, Width = 1f, At = 0.2f, Other = 0.4f, Inwards = 0.5f, Level = 1.5f, Box = 4f;
            int axis = side < 2 ? 0 : 2;
            float3 start = new float3(-0.3f, 0f, -0.3f), position = 2f;
            position[axis] = (side & 1) != 0 ? Box - At : At;
            FluidBorders borders = FluidBorders.Default;
            borders[side] = new FluidBorder { kind = BorderKind.Open, width = Width, velocity = Inwards, level = Level };
            if (inCorner)
            {
                borders[2 - axis] = new FluidBorder { kind = BorderKind.Absorbing, width = Width };      // the lower one of the other axis
                position[2 - axis] = Other;
            }
            float3 before = Lone(default, Down, position, start), after = Lone(borders, Down, position, start);
            double own = 2 * (1.5 * Math.Sqrt(9.81 * Level) + 8 * Inwards) / Width * (1 - At / Width);
            double rate = own + (inCorner ? 2 * 2.2 * Math.Sqrt(9.81 * Spacing) / Width * (1 - Other / Width) : 0.0);
            double left = Math.Exp(-rate / 60), speed = ((side & 1) != 0 ? -1 : 1) * Inwards * (At / Width / 0.5) * own / rate;
            Assert.That(left, Is.LessThan(0.9));
            Assert.That(after[axis], Is.EqualTo(speed / Spacing + left * (before[axis] - speed / Spacing)).Within(1e-3));
            Assert.That(after[2 - axis], Is.EqualTo(left * before[2 - axis]).Within(1e-3));
            Assert.That(after.y, Is.EqualTo(before.y).Within(1e-3));
        }

        [Test]
        public void Across_gravity_is_across_it_however_it_points()
        {
            const float Spacing = 0.1f, At = 0.3f;
            var gravity = new float3(6f, -7f, 2f);
            FluidBorders borders = FluidBorders.Default;
            borders.minX = new FluidBorder { kind = BorderKind.Absorbing, width = 1f };
            float3 position = new float3(At, 2f, 2f), start = new float3(0.4f, 0.3f, -0.5f);
            double3 before = Lone(default, gravity, position, start), after = Lone(borders, gravity, position, start), up = -math.normalize(gravity);
            // Gravity acts after the border in a step.
            double3 then = before - (double3)gravity / 60.0 / Spacing, across = then - up * math.dot(then, up), change = after - before;
            double part = -math.dot(change, across) / math.dot(across, across);
            TestContext.Out.WriteLine($"{part:0.000} of what is across is gone");
            Assert.That(part, Is.InRange(0.02, 0.2));
            Assert.That(math.length(change + part * across), Is.LessThan(1e-3), "d/s along gravity, or aside");
        }

        static readonly float3 Down = new float3(0f, -9.81f, 0f);

        // Velocity after a step of a particle that is alone in a box of 4 m, d/s.
        static float3 Lone(FluidBorders borders, float3 gravity, float3 position, float3 velocity)
        {
            using (var fluid = new TestFluid(4f, 0.1f, 10))
            {
                fluid.Input.borders = borders;
                fluid.Input.gravity = gravity;
                return fluid.Add(new[] { position }, velocity).Step().Read().velocities[0].xyz;
            }
        }

        [Test]
        public void Walls_change_no_bit_and_make_no_stage()
        {
            using (TestFluid without = Pool(default), with = Pool(FluidBorders.Default), absorbing = Pool(Absorbing(1f)))
            {
                TestFluid.AssertSame(with.Step(20).Read(), without.Step(20).Read());
                Assert.That(UsesBorders(with), Is.False);
                Assert.That(UsesBorders(absorbing.Step(20)), Is.True);
                Assert.That(absorbing.Read().velocities, Is.Not.EqualTo(without.Read().velocities));
            }
        }

        [TestCase(0.3f, false), TestCase(0.3f, true)]
        [Category("LongRun")]
        public void Open_sides_hold_the_velocity_and_the_level_of_a_channel(float speed, bool isTurned)
        {
            const float Spacing = 0.05f, Level = 0.4f, Length = 4f, Band = 1f;
            Vector3 box = isTurned ? new Vector3(0.4f, 0.8f, Length) : new Vector3(Length, 0.8f, 0.4f);
            int axis = isTurned ? 2 : 0;
            using (var scene = new SourceScene(box, Spacing, 16000, DeepWater.Automatic))
            {
                scene.Fill(Level);
                FluidBorders borders = FluidBorders.Default;
                borders[axis] = new FluidBorder { kind = BorderKind.Open, width = Band, velocity = speed, level = Level };
                borders[axis + 1] = new FluidBorder { kind = BorderKind.Open, width = Band, velocity = -speed, level = Level };
                scene.Fluid.Borders = borders;
                scene.Step(300);
                double height = 0.0, flow = 0.0;
                const int Samples = 12;
                for (int sample = 0; sample < Samples; sample++)
                {
                    ParticleState state = scene.Step(10).Read();
                    int count = 0;
                    for (int i = 0; i < state.Count; i++)
                    {
                        float along = state.positions[i][axis] * Spacing;
                        if (along < Band || along > Length - Band)
                            continue;
                        count++;
                        flow += state.velocities[i][axis] * Spacing;
                    }
                    height += count;
                }
                double meanSpeed = flow / height, level = height / Samples * Spacing * Spacing * Spacing / ((Length - 2 * Band) * 0.4);
                FluidStatistics statistics = scene.AssertConserved();
                TestContext.WriteLine(Invariant($"{meanSpeed:0.000} m/s, level {level / Spacing:0.00} d of {Level / Spacing}, emitted ") +
                    Invariant($"{statistics.emitted}, drained {statistics.drained}, blocked {statistics.blocked}"));
                Assert.That(meanSpeed, Is.EqualTo(speed).Within(0.05 * speed));
                Assert.That(level / Spacing, Is.EqualTo(Level / Spacing).Within(0.5));
            }
        }

        [Test, Category("LongRun")]
        public void A_still_level_is_held()
        {
            const float Spacing = 0.05f;
            using (var scene = new SourceScene(new Vector3(2f, 0.8f, 0.4f), Spacing, 8000, DeepWater.Automatic))
            {
                scene.Fill(0.3f);
                FluidBorders borders = FluidBorders.Default;
                borders.minX = new FluidBorder { kind = BorderKind.Open, width = 0.5f, level = 0.4f };
                scene.Fluid.Borders = borders;
                scene.Step(300);
                double level = scene.Read().Count / (40.0 * 8.0);
                TestContext.WriteLine(Invariant($"level {level:0.00} d"));
                Assert.That(level, Is.EqualTo(8.0).Within(0.5));
            }
        }

        [Test, Category("LongRun")]
        public void A_snapshot_goes_on_bit_for_bit([Values(0f, 0.1f)] float sleepSpeed)
        {
            using (var scene = new SourceScene(new Vector3(1f, 0.8f, 0.4f), 0.05f, 4000, DeepWater.Automatic))
            {
                scene.Fill(0.3f);
                SolverSettings settings = scene.Fluid.Settings;
                settings.sleepSpeed = sleepSpeed;
                scene.Fluid.Settings = settings;
                FluidBorders borders = Absorbing(0.3f);
                borders.minX = new FluidBorder { kind = BorderKind.Open, width = 0.4f, velocity = 0.5f, level = 0.4f };
                borders.maxX = new FluidBorder { kind = BorderKind.Open, width = 0.4f, level = 0.35f };
                scene.Fluid.Borders = borders;
                FluidSnapshotRequest request = scene.Step(30).Fluid.RequestSnapshot();
                AsyncGPUReadback.WaitAllRequests();
                ParticleState first = scene.Step(15).Read();
                scene.Fluid.Restore(request.Snapshot);
                TestFluid.AssertSame(scene.Step(15).Read(), first);
                Assert.That(scene.Measure().emitted, Is.GreaterThan(0));
            }
        }

        [TestCase(-1f, 1f, 0f, "width of the border \\+X -1 is outside 0 to")]
        [TestCase(float.NaN, 1f, 0f, "width of the border \\+X NaN is outside 0 to")]
        [TestCase(1f, 1f, 1000f, "velocity of the border \\+X 1000 is outside -100 to 100; using 100")]
        [TestCase(1f, -2f, 0f, "level of the border \\+X -2 is outside 0 to")]
        public void A_value_out_of_range_is_clamped_by_name(float width, float level, float velocity, string message)
        {
            using (var scene = new SourceScene(new Vector3(2f, 0.8f, 0.4f), 0.05f, 1000))
            {
                LogAssert.Expect(LogType.Warning, new Regex("FluidSimulation 'Fluid'.*" + message));
                FluidBorders borders = FluidBorders.Default;
                borders.maxX = new FluidBorder { kind = BorderKind.Open, width = width, level = level, velocity = velocity };
                scene.Fluid.Borders = borders;
                Assert.That(scene.Fluid.Borders.Validate(out _), Is.True);
                LogAssert.NoUnexpectedReceived();
            }
        }

        [TestCase(0.1f, 0.5f, "border \\+X has a band 0.1 m wide, and it takes 4 particle spacings: 0.2 m are used. Widen it")]
        [TestCase(3f, 0.5f, "border \\+X has a band 3 m wide, and the bands on this axis have 2 m of the box together: 2 m are used. Narrow it")]
        [TestCase(1f, 1.5f, "border \\+X holds a level of 1.5 m, and the box is 0.8 m high: that is used. Lower the level")]
        public void A_border_that_the_box_has_no_room_for_is_logged_once_and_fitted(float width, float level, string message)
        {
            using (var scene = new SourceScene(new Vector3(2f, 0.8f, 0.4f), 0.05f, 8000))
            {
                FluidBorders borders = FluidBorders.Default;
                borders.maxX = new FluidBorder { kind = BorderKind.Open, width = width, level = level };
                scene.Fluid.Borders = borders;
                LogAssert.Expect(LogType.Warning, new Regex("FluidSimulation 'Fluid'.*" + message));
                scene.Step(3);
                var problems = new List<string>();
                ((IHasProblems)scene.Fluid).ListProblems(problems);
                Assert.That(problems, Has.Some.Matches(message));
                LogAssert.NoUnexpectedReceived();
            }
        }

        [Test]
        public void Two_bands_share_the_box()
        {
            FluidBorders borders = Absorbing(3f).In(new float3(4f, 1f, 10f), 0.1f);
            Assert.That(new[] { borders.minX.width, borders.maxX.width, borders.minZ.width, borders.maxZ.width },
                Is.EqualTo(new[] { 2f, 2f, 3f, 3f }).Within(1e-5f));
        }

        // Half of a band of 40 spacings beside 600 has 1.2 million positions, more than an emitter takes.
        [Test]
        public void A_long_side_holds_its_level_by_a_thinner_strip()
        {
            const float Spacing = 0.1f;
            var layout = new SolverLayout(new float3(600f, 100f, 600f) * Spacing, Spacing, 1000, 64, 1f);
            StepInput input = SolverStages.Still();
            input.timeStep = 1f / 60f;
            input.gravity = new float3(0f, -9.81f, 0f);
            input.borders = FluidBorders.Default;
            input.borders.minX = new FluidBorder { kind = BorderKind.Open, width = 4f, level = 10f };
            var sources = new StepSources();
            new BorderLevels().AddTo(sources, input, BorderLevels.NumbersOf(input.borders), layout, 0);
            Assert.That(sources.emitterCount, Is.EqualTo(1));
            Assert.That(sources.emitters[0].positions.Count, Is.InRange(900_000, 1 << 20));
        }

        static FluidBorders Absorbing(float width)
        {
            var border = new FluidBorder { kind = BorderKind.Absorbing, width = width };
            return new FluidBorders { minX = border, maxX = border, minZ = border, maxZ = border };
        }

        static TestFluid Pool(FluidBorders borders)
        {
            var fluid = new TestFluid(new float3(1f, 1f, 1f), 0.1f, 1000);
            fluid.Input.borders = borders;
            return fluid.AddBlock(0f, new float3(0.5f, 0.5f, 1f));
        }

        static bool UsesBorders(TestFluid fluid)
            => fluid.Solver.Describe(fluid.Input, 0).Exists(stage => stage.Name == "Borders" && stage.IsUsed);
    }
}
