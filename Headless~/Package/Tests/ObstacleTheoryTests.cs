using System;
using System.Linq;
using Host.Report;
using Host.Report.Obstacles;
using NUnit.Framework;
using Rill;

namespace Host.Tests
{
    /// <summary>Colliders against theory, in small, and what judges them; "rill report obstacles" does it at size.</summary>
    public class ObstacleTheoryTests : GraphicsFixture
    {
        // Deep water: as fast as Torricelli's within 3 % at this size and at twice it. The coefficient is that of a hole of 6 particles.
        [Test]
        public void Water_leaves_a_hole_in_a_floor_as_fast_as_what_fell_from_the_level()
        {
            OrificeFlow flow = OrificeFlow.Run(6, FluidRun.Water(1, 2), 0.8);
            TestContext.WriteLine($"speed {flow.SpeedRatio:0.000}, coefficient {flow.Discharge:0.000}, misfit {flow.Misfit:0.0000}");
            Assert.That(flow.SpeedRatio, Is.EqualTo(1).Within(0.08));
            Assert.That(flow.Discharge, Is.InRange(0.45, 0.7));
            Assert.That(flow.Misfit, Is.LessThan(0.02));
            Assert.That(flow.Leaked, Is.Zero);
        }

        // The mean of 0.8 s, a period of the waves that start it: so much is left of them that the bar is wide.
        [Test]
        public void The_surface_of_turning_water_is_as_steep_as_its_turning_says()
        {
            RotatingBucket bucket = RotatingBucket.Run(12, 3, false, FluidRun.Water(1, 2, DeepWater.Off), 0.8, 0.8);
            TestContext.WriteLine($"for its own turning {bucket.OwnSteepness:0.000}, turning {bucket.Turning:0.000}");
            Assert.That(bucket.OwnSteepness, Is.EqualTo(1).Within(0.15));
            Assert.That(bucket.Turning, Is.InRange(0.8, 1.0));
        }

        // A wall that slips acts by its pressure alone: it neither brakes nor drives. The coarse grid brakes by what its cells of a few particles
        // do not see of a curve so tight: 4 % here, less in wider buckets. Without the full push of the wall along its normal it is 5 %.
        [TestCase(DeepWater.Off, 0.94, 1.02)]
        [TestCase(DeepWater.On, 0.955, 1.02)]
        public void A_slippery_round_wall_leaves_turning_water_what_the_step_leaves(DeepWater deepWater, double least, double most)
        {
            RotatingBucket bucket = RotatingBucket.Run(12, 3, false, FluidRun.Water(1, 2, deepWater), 0.8, 0.8, 0f, runs: 2);
            double expected = RotatingBucket.TurningLeft(3, 1.0 / 60, 1.2);
            TestContext.WriteLine($"turning {bucket.Turning:0.000} of {expected:0.000}");
            Assert.That(bucket.Turning / expected, Is.InRange(least, most));
        }

        [Test]
        public void A_slippery_round_wall_that_turns_moves_none_of_the_still_water_in_it([Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            RotatingBucket bucket = RotatingBucket.Run(12, 3, true, FluidRun.Water(1, 2, deepWater), 0.4, 0.4, 0f, true);
            TestContext.WriteLine($"turning {bucket.Turning:0.00000} of the wall's");
            Assert.That(bucket.Turning, Is.Zero.Within(0.002));
        }

        // With the iterations alone: in deep water it leans by more, see Research~/solver-study.md.
        [Test]
        public void The_surface_in_a_cup_that_gains_speed_leans_by_a_over_g()
        {
            double slope = MovingCup.Run(FluidRun.Water(2, 4, DeepWater.Off), 2f, 2, 0, 0f);
            TestContext.WriteLine($"slope {slope:0.000} of a / g");
            Assert.That(slope, Is.EqualTo(1).Within(0.05));
        }

        // One particle on a circle, moved as the solver does: along the chord of its last path, then to the circle along the radius at the end.
        [TestCase(1)]
        [TestCase(2)]
        [TestCase(4)]
        public void What_turning_loses_to_the_step_is_that_of_a_particle_held_on_a_circle(int substeps)
        {
            const double speed = 3, time = 3.8;
            double step = 1.0 / 60 / substeps, angle = speed * step;
            int steps = (int)Math.Round(time / step);
            for (int i = 0; i < steps; i++)
            {
                double x = 2 - Math.Cos(angle), y = Math.Sin(angle);
                angle = Math.Atan2(y, x);
            }
            double left = angle / step / speed;
            TestContext.WriteLine($"{substeps} substeps: {left:0.0000} left, {RotatingBucket.TurningLeft(speed, step, time):0.0000} by the formula");
            Assert.That(RotatingBucket.TurningLeft(speed, step, time), Is.EqualTo(left).Within(0.002));
        }

        [TestCase(0.6, 1.0)]
        [TestCase(0.3, 0.7)]
        public void The_coefficient_of_a_hole_is_read_from_the_level_over_time(double coefficient, double first)
        {
            var flow = new OrificeFlow();
            for (double time = 0; time < 3; time += 0.05)
            {
                double root = Math.Sqrt(first) - coefficient / 16 * Math.Sqrt(9.81 / 2) * time;
                flow.Levels.Add((time, root * root));
            }
            flow.FitLevel();
            Assert.That(flow.Discharge, Is.EqualTo(coefficient).Within(1e-3 * coefficient));
            Assert.That(flow.Misfit, Is.LessThan(1e-6));
            flow.Levels[40] = (flow.Levels[40].Time, flow.Levels[40].Level + 0.1);
            flow.FitLevel();
            Assert.That(flow.Misfit, Is.GreaterThan(0.08));
        }

        // In a tank three bodies wide, as it was, waves are back after 1.3 and 0.8 of the theory's period.
        [Test]
        public void A_body_swings_as_if_the_tank_had_no_walls_while_its_period_is_fitted([Values(ColliderShape.Sphere,
            ColliderShape.Box)] ColliderShape shape)
        {
            const double size = 0.4;
            double period = FloatingBody.PeriodOf(shape, size), back = FloatingBody.WavesReturn(size, FloatingBody.WidthsAcross * size, period);
            TestContext.WriteLine(
                $"period {period:0.000} s, waves are back after {back:0.00} s, fitted are {FloatingBody.FittedTime(period):0.00} s");
            Assert.That(back, Is.GreaterThan(FloatingBody.FittedTime(period)));
            Assert.That(FloatingBody.WavesReturn(size, 3 * size, period), Is.LessThan(FloatingBody.FittedTime(period)));
        }

        [TestCase(1.0)]
        [TestCase(0.8)]
        public void A_bucket_is_as_steep_as_its_rings_and_water_that_turns_slower_is_told_apart(double fraction)
        {
            const double speed = 4, depth = 0.6;
            var rings = Enumerable.Range(0, RotatingBucket.Rings).Select(i => 0.05 + 0.1 * i)
                .Select(r => (r, RotatingBucket.Surface(depth, fraction * speed, r), fraction * speed)).ToArray();
            var bucket = new RotatingBucket { RestDepth = depth };
            bucket.Compare(speed, rings);
            Assert.That(bucket.Steepness, Is.EqualTo(fraction * fraction).Within(1e-6));
            Assert.That(bucket.OwnSteepness, Is.EqualTo(1).Within(1e-6));
            Assert.That(bucket.MaxError, Is.EqualTo((1 - fraction * fraction) / 2).Within(0.03), "at the wall and in the center");

            var level = new RotatingBucket { RestDepth = depth };
            level.Compare(speed, rings.Select(ring => (ring.r, depth, ring.Item3)).ToArray());
            Assert.That(level.OwnSteepness, Is.Zero.Within(1e-6), "a surface that stays level");
        }
    }
}
