using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Deep water and walls that lie across the coarse grid: what should stay still does, and what slides is neither braked nor
    /// driven.</summary>
    [Category("LongRun")]
    public class WallFlowTests
    {
        const float Spacing = 0.05f, Gravity = 9.81f;

        // Ten layers and less on a floor that leans, under gravity alone and with a uniform field across it, to which the surface then leans.
        // With the field it is between 0.049 and 0.057 m/s by who compiles the shaders; it was 0.10 to 0.13 when the grid took floors for level.
        [TestCase(5f, 0f, 0.05f)]
        [TestCase(15f, 0f, 0.05f)]
        [TestCase(30f, 0f, 0.05f)]
        [TestCase(45f, 0f, 0.06f)]
        [TestCase(30f, 3f, 0.07f)]
        [TestCase(45f, 3f, 0.075f)]
        public void Water_at_rest_on_a_slope_stays_at_rest(float tilt, float field, float bound)
        {
            var box = new float3(36f, 32f, 12f);
            quaternion turn = quaternion.RotateZ(math.radians(tilt));
            float3 foot = new float3(4f, 1.3f, 6f), normal = math.mul(turn, math.up());
            float3 pull = new float3(field, -Gravity, 0f), up = -math.normalize(pull);
            float level = math.dot(new float3(0.5f * box.x, field > 0f ? 16f : 12f, 0f), up);
            using (var fluid = new TestFluid(box * Spacing, Spacing, 12000, ColliderDeepWaterTests.Deep))
            {
                ColliderTests.Use(fluid, ColliderTests.Still(ColliderShape.Plane, 0f, foot, turn));
                fluid.Input.gravity = pull;
                fluid.Add(Lattice(box).Where(p => math.dot(p - foot, normal) > 0.45f && math.dot(p, up) < level).Select(p => p * Spacing).ToArray());
                double jitter = 0.0, speed = 0.0, mean = 0.0;
                fluid.Step(150);
                for (int i = 0; i < 6; i++)
                {
                    FluidStatistics statistics = fluid.Step(10).Measure();
                    jitter = Math.Max(jitter, statistics.jitter);
                    speed = Math.Max(speed, statistics.speed);
                    ParticleState state = fluid.Read();
                    mean = Math.Max(mean, math.length(MeanVelocity(state, new HashSet<uint>(state.ids))) * Spacing);
                }
                TestContext.WriteLine($"{fluid.Added} particles, jitter {jitter:0.000}, speed {speed:0.000}, mean velocity {mean:0.000} m/s");
                fluid.MeasureWhole();
                Assert.That(jitter, Is.LessThan(bound), "jitter, m/s");
            }
        }

        // An upright cylinder off the grid's lines, whose wall turns at 2.7 m/s. The water around it is looked at in its sense of turning;
        // with friction it is seen to move.
        [TestCase(0f, -0.002, 0.002)]
        [TestCase(1f, 0.02, 1.0)]
        public void A_cylinder_that_spins_in_still_water_moves_it_by_friction_alone(float friction, double least, double most)
        {
            const float radius = 6f, turn = 0.15f;
            var axis = new float3(15.3f, 8f, 16.7f);
            using (var fluid = new TestFluid(new float3(32f, 16f, 32f) * Spacing, Spacing, 11000, ColliderDeepWaterTests.Deep))
            {
                ColliderMotion cylinder = ColliderTests.Still(ColliderShape.Capsule, new float3(radius, 30f, radius), axis, quaternion.identity);
                cylinder.friction = friction;
                fluid.AddAround(cylinder, 0f, new float3(32f, 10f, 32f));
                ColliderTests.Use(fluid, cylinder);
                fluid.Step(60);
                (double still, double noise) = Around(fluid, axis, radius);
                double spun = 0.0, stirred = 0.0;
                for (int step = 0; step < 60; step++)
                {
                    cylinder.start = cylinder.end;
                    cylinder.end.rotation = math.mul(quaternion.RotateY(turn), cylinder.end.rotation);
                    ColliderTests.Use(fluid, cylinder);
                    fluid.Step();
                    (double around, double speed) = Around(fluid, axis, radius);
                    spun += around / 60.0;
                    stirred = Math.Max(stirred, speed);
                }
                double wall = radius * turn * Spacing / fluid.Input.timeStep;
                TestContext.Out.WriteLine($"around the cylinder {still:0.0000} m/s, {noise:0.000} rms, as it stands, and {spun:0.0000} " +
                    $"m/s, {stirred:0.000} rms, as its wall turns at {wall:0.0} m/s");
                Assert.That(spun / wall, Is.InRange(least, most));
                if (friction == 0f)
                    Assert.That(stirred, Is.LessThan(1.25 * noise), "rms speed around it, m/s");
            }
        }

        // Mean velocity in the sense of turning about y, and rms speed, m/s, of what is within 4 d of a cylinder.
        static (double mean, double rms) Around(TestFluid fluid, float3 axis, float radius)
        {
            ParticleState state = fluid.Read();
            double sum = 0.0, squares = 0.0;
            int count = 0;
            for (int i = 0; i < state.Count; i++)
            {
                float2 away = (state.positions[i].xyz - axis).xz;
                if (math.length(away) > radius + 4f)
                    continue;
                float2 sense = new float2(away.y, -away.x) / math.length(away);
                sum += math.dot(state.velocities[i].xz, sense) * Spacing;
                squares += math.lengthsq(state.velocities[i].xyz) * Spacing * Spacing;
                count++;
            }
            return (sum / Math.Max(count, 1), Math.Sqrt(squares / Math.Max(count, 1)));
        }

        // A film of three layers, in a frame that leans as the floor does, slides along it. Its ends run out, so its central third is looked at.
        [Test]
        public void A_floor_neither_brakes_nor_drives_the_film_that_slides_along_it([Values(0f, 2f, 5f, 20f, 35f)] float tilt)
        {
            const int length = 72;
            quaternion turn = quaternion.RotateZ(math.radians(tilt));
            float3 along = math.mul(turn, math.right()), up = math.mul(turn, math.up());
            var foot = new float3(8f, 6.3f, 0f);
            using (var fluid = new TestFluid(new float3(108f, 88f, 12f) * Spacing, Spacing, 4000, ColliderDeepWaterTests.Deep))
            {
                ColliderTests.Use(fluid, ColliderTests.Still(ColliderShape.Plane, 0f, foot, turn));
                fluid.Input.gravity = -Gravity * up;
                var positions = new List<float3>();
                for (int i = 0; i < length * 3 * 12; i++)
                    positions.Add((foot + (4.5f + i % length) * along + (0.55f + i / length % 3) * up
                        + new float3(0f, 0f, 0.5f + i / (3 * length))) * Spacing);
                fluid.Add(positions.ToArray(), 1.5f * along);
                ParticleState start = fluid.Read();
                var inside = new HashSet<uint>(Enumerable.Range(0, start.Count)
                    .Where(i => math.abs(math.dot(start.positions[i].xyz - foot, along) - 4f - 0.5f * length) < length / 6f)
                    .Select(i => start.ids[i]));
                double before = math.dot(MeanVelocity(start, inside), along), after = math.dot(MeanVelocity(fluid.Step(20).Read(), inside), along);
                TestContext.WriteLine($"{inside.Count} of {fluid.Added} particles, {after / before:0.000} of their speed is left after 20 steps");
                Assert.That(after, Is.EqualTo(before).Within(0.02 * before));
            }
        }

        // Along a half-pipe that lies along the grid or across it; the central third of the water.
        [Test]
        public void A_half_pipe_neither_brakes_nor_drives_the_sheet_that_slides_along_it([Values(10f, 30f)] float turned)
        {
            const float radius = 12f, length = 60f;
            quaternion turn = quaternion.RotateY(math.radians(turned));
            float3 along = math.mul(turn, math.right()), across = math.mul(turn, math.forward());
            var box = new float3(90f, 20f, 90f);
            float3 center = new float3(0.5f * box.x, radius + 2.3f, 0.5f * box.z);
            using (var fluid = new TestFluid(box * Spacing, Spacing, 4000, ColliderDeepWaterTests.Deep))
            {
                // A capsule inside out whose axis, its y, lies along the pipe.
                ColliderMotion pipe = ColliderTests.Still(ColliderShape.Capsule, new float3(radius, 120f, 0f), center,
                    math.mul(turn, quaternion.RotateZ(math.radians(90f))));
                pipe.insideOut = true;
                ColliderTests.Use(fluid, pipe);
                var positions = new List<float3>();
                for (float x = 0.5f - 0.6f * length; x < 0.4f * length; x++)
                    for (float y = -radius + 0.55f; y < -radius + 4f; y++)
                        for (float z = 0.5f - radius; z < radius; z++)
                            if (y * y + z * z < (radius - 0.5f) * (radius - 0.5f))
                                positions.Add((center + x * along + y * math.up() + z * across) * Spacing);
                fluid.Add(positions.ToArray(), 1.5f * along);
                ParticleState start = fluid.Read();
                var inside = new HashSet<uint>(Enumerable.Range(0, start.Count)
                    .Where(i => math.abs(math.dot(start.positions[i].xyz - center, along) + 0.1f * length) < length / 6f)
                    .Select(i => start.ids[i]));
                double before = math.dot(MeanVelocity(start, inside), along);
                double3 end = MeanVelocity(fluid.Step(20).Read(), inside);
                double after = math.dot(end, along), sideways = math.dot(end, across);
                TestContext.WriteLine($"{inside.Count} of {fluid.Added} particles, {after / before:0.000} of their speed is left after " +
                    $"20 steps, {sideways / before:0.000} of it goes sideways");
                Assert.That(after, Is.EqualTo(before).Within(0.02 * before));
                Assert.That(sideways, Is.EqualTo(0.0).Within(0.02 * before));
            }
        }

        // d/s.
        static double3 MeanVelocity(ParticleState state, ICollection<uint> among)
        {
            double3[] velocities = Enumerable.Range(0, state.Count).Where(i => among.Contains(state.ids[i]))
                .Select(i => (double3)state.velocities[i].xyz).ToArray();
            return velocities.Aggregate(new double3(0.0), (sum, velocity) => sum + velocity) / velocities.Length;
        }

        static IEnumerable<float3> Lattice(float3 box)
        {
            for (float z = 0.5f; z < box.z; z++)
                for (float y = 0.5f; y < box.y; y++)
                    for (float x = 0.5f; x < box.x; x++)
                        yield return new float3(x, y, z);
        }
    }
}
