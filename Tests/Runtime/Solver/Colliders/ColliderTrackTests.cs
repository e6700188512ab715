using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>Tracking of a collider's motion: along a path and about an axis.</summary>
    public class ColliderTrackTests
    {
        const float Duration = 1f / 60f, Substep = 1f / 120f;

        static readonly float3 Velocity = new float3(0.3f, -0.4f, 1.2f), Spin = new float3(1.2f, 0.3f, -0.4f);

        // The water comes to move along in four substeps: what is left of the slip decays by exp(-t / memory).
        [Test]
        public void Slip_along_and_about_an_axis_decays_as_the_water_comes_to_move_along()
        {
            ColliderTrack track = ColliderTrack.At(Pose(0));
            const float Memory = 4f * Substep;
            double left = 1.0;
            for (int window = 0; window < 3; window++)
            {
                double mean = 0.0;
                for (int i = 1; i <= 2; i++)
                {
                    RigidPose next = Pose(2 * window + i);
                    if (i == 1)
                        next.rotation = new quaternion(-next.rotation.value);       // the same orientation
                    track.Follow(next, Duration, Substep);
                    double after = left * math.exp(-(double)Duration / Memory);
                    mean += 0.5 * (left - after) * Memory / Duration;
                    left = after;
                }
                RelativeMotion motion = track.Take();
                Assert.That(motion.Memory, Is.EqualTo(Memory));
                AssertNear(motion.Slip, (float)mean * Velocity, 2e-3f * math.length(Velocity));
                AssertNear(motion.AngularSlip, (float)mean * Spin, 2e-3f * math.length(Spin));
                AssertNear(motion.Position, Pose(2 * window + 1).position, 1e-5f);
                Assert.That(Quaternion.Angle(motion.Rotation, Pose(2 * window + 1).rotation), Is.LessThan(0.1f));
            }
            track.SkipTo(Pose(100));
            track.Follow(Pose(101), Duration, Substep);
            RelativeMotion later = track.Take();
            Assert.That(math.length(later.Slip), Is.LessThan(0.05f * math.length(Velocity)), "dropped time is not a motion");
            Assert.That(math.length(later.AngularSlip), Is.LessThan(0.05f * math.length(Spin)));
        }

        [TestCase(10f, 10f)]
        [TestCase(179f, 179f)]
        [TestCase(190f, -170f)]
        [TestCase(350f, -10f)]
        public void A_turn_is_the_shorter_one(float degrees, float expected)
        {
            float3 axis = math.normalize(new float3(1f, -2f, 0.5f));
            quaternion from = quaternion.Euler(0.3f, 1f, -0.4f), to = math.mul(quaternion.AxisAngle(axis, math.radians(degrees)), from);
            AssertNear(RigidPose.RotationVector(from, to), axis * math.radians(expected), 1e-4f);
            AssertNear(RigidPose.RotationVector(from, new quaternion(-to.value)), axis * math.radians(expected), 1e-4f);
        }

        // Motion of every point of the ball around it, and not twice as much.
        [Test]
        public void What_a_collider_sweeps_in_a_substep_is_as_far_as_its_points_go([Values(0f, 1f)] float moves,
            [Values(0f, 0.02f, 0.3f)] float turns)
        {
            var size = new float3(3f, 4f, 12f);
            float reach = math.length(size);
            ColliderMotion motion = ColliderTests.Still(ColliderShape.Box, size, new float3(20f), quaternion.Euler(0.2f, 0.4f, 0.1f));
            motion.end = new RigidPose(motion.start.position + moves * new float3(0.5f, 0f, 1f),
                math.mul(quaternion.AxisAngle(math.normalize(new float3(1f, 2f, -1f)), turns), motion.start.rotation));
            float sweep = ColliderState.For(motion, 0f, 1f, 0.01f, 1f, false, default).sweep;
            double farthest = 0.0;
            var random = new Unity.Mathematics.Random(5u);
            for (int i = 0; i < 2000; i++)
            {
                float3 point = reach * random.NextFloat3Direction();
                farthest = math.max(farthest, math.distance(At(motion.start, point), At(motion.end, point)));
            }
            Assert.That(sweep, Is.GreaterThanOrEqualTo(0.999 * farthest));
            Assert.That(sweep, Is.LessThanOrEqualTo(math.distance(motion.start.position, motion.end.position) + 1.01f * reach * turns + 1e-4f));
            Assert.That(RigidPose.Distance(motion.start, motion.end, reach), Is.GreaterThanOrEqualTo(0.999 * farthest));
        }

        // A tenth of a turn in a step of 0.1 s is 6.28 rad/s: on a disc of 4 spacings 25 spacings a second at its rim.
        [Test]
        public void What_particles_take_along_of_an_emitter_is_bounded_at_its_rim_too([Values(1000f, 20f, 8f)] float most)
        {
            EmitterPositions disc = EmitterPositions.Of(EmitterShape.Disc, EmitterMode.Jet, 0f, 4f, null, 1f, 1f, out _);
            Assert.That(disc.Radius, Is.EqualTo(4f).Within(0.3f));
            var step = new EmitterStep
            {
                positions = disc,
                start = new RigidPose(20f, quaternion.identity),
                end = new RigidPose(new float3(21f, 20f, 20f), quaternion.AxisAngle(math.up(), 0.62832f)),
            };
            step.Inherit(0.5f, 0.1f, most);
            AssertNear(step.spin, 0.5f * math.min(6.2832f, most / disc.Radius) * math.up(), 1e-3f);
            AssertNear(step.velocity, 0.5f * math.min(10f, most) * math.right(), 1e-3f);
            Assert.That(step.Reach(0.1f), Is.EqualTo(2f + disc.Radius + 0.1f * (math.length(step.velocity)
                + disc.Radius * math.length(step.spin))).Within(1e-3f), "d, with a spacing to spare");
        }

        // Motion in a quarter of a turn in the step.
        [Test]
        public void The_substeps_of_an_emitter_turn_and_move_on_evenly([Values(2, 3)] int count)
        {
            EmitterStep step = Turning(90f);
            for (int i = 0; i < count; i++)
            {
                EmitterStep part = step.Part(i, count, 1f / 60f);
                AssertAt(part.start, step, i / (float)count);
                AssertAt(part.end, step, (i + 1) / (float)count);
            }
        }

        static void AssertAt(in RigidPose pose, in EmitterStep step, float fraction)
        {
            AssertNear(pose.position, math.lerp(step.start.position, step.end.position, fraction), 1e-5f);
            Assert.That(Quaternion.Angle(pose.rotation, Quaternion.Slerp(step.start.rotation, step.end.rotation, fraction)), Is.LessThan(0.1f));
        }

        // Quaternions of opposite signs are one orientation; between them lies a whole turn.
        [Test]
        public void An_emitter_turns_by_the_shorter_side_from_where_it_was([Values] bool opposite)
        {
            EmitterStep step = Turning(90f);
            if (opposite)
                step.start.rotation = new quaternion(-step.start.rotation.value);
            EmitterConstants constants = EmitterConstants.For(step, 1f / 60f, false, 1, Layout());
            Assert.That(math.dot(constants.rotation, constants.lastRotation), Is.EqualTo(math.cos(math.PI / 4f)).Within(1e-4f));
            Assert.That(math.abs(math.dot(constants.lastRotation, step.start.rotation.value)), Is.EqualTo(1f).Within(1e-5f));
            AssertNear(constants.lastOrigin, step.start.position, 1e-6f);
            step.Inherit(1f, 0.1f, 1000f);
            AssertNear(step.spin, math.PI / 2f / 0.1f * Axis, 1e-2f);
        }

        // A disc of a radius of 4 spacings that turns by a quarter lies along y at first, and along z at the end.
        [Test]
        public void What_lies_before_an_outlet_is_looked_for_where_it_was_and_where_it_is()
        {
            EmitterStep step = Turning(90f);
            step.start.rotation = quaternion.identity;
            step.end.rotation = quaternion.AxisAngle(math.right(), math.PI / 2f);
            step.end.position = step.start.position;
            SolverLayout layout = Layout();
            step.CellsBefore(layout, 0.5f, out int3 from, out int3 counts);
            float3 low = (float3)from * layout.CellSize, high = (float3)(from + counts) * layout.CellSize;
            foreach (float3 rim in new[] { new float3(3.9f, 0f, 0f), new float3(0f, 3.9f, 0f), new float3(0f, 0f, 3.9f) })
                Assert.That(math.all(step.start.position + rim <= high) && math.all(step.start.position - rim >= low), $"{rim}");
        }

        [Test]
        public void What_only_turns_moves_as_what_only_goes_along_does()
        {
            ColliderMotion motion = ColliderTests.Still(ColliderShape.Box, new float3(1f), new float3(5f), quaternion.identity);
            Assert.That(motion.Moves, Is.False);
            foreach (RigidPose pose in new[] { new RigidPose(new float3(5f, 5f, 5.1f), quaternion.identity),
                new RigidPose(new float3(5f), quaternion.AxisAngle(Axis, 0.1f)) })
            {
                motion.end = pose;
                Assert.That(motion.Moves);
                Assert.That(motion.end.Equals(motion.start), Is.False);
            }
        }

        static readonly float3 Axis = math.normalize(new float3(1f, 2f, -1f));

        static SolverLayout Layout() => new SolverLayout(2f, 0.05f, 1000, 96, 1f);

        static EmitterStep Turning(float degrees) => new EmitterStep
        {
            positions = EmitterPositions.Of(EmitterShape.Disc, EmitterMode.Jet, 0f, 4f, null, 1f, 1f, out _),
            start = new RigidPose(new float3(20f), quaternion.Euler(0.3f, 0.2f, 0.1f)),
            end = new RigidPose(new float3(21f, 20f, 20f),
                math.mul(quaternion.AxisAngle(Axis, math.radians(degrees)), quaternion.Euler(0.3f, 0.2f, 0.1f))),
            speed = 10f,
        };

        static RigidPose Pose(int step) => new RigidPose(new float3(1f, 2f, 3f) + step * Duration * Velocity,
            math.mul(quaternion.AxisAngle(math.normalize(Spin), step * Duration * math.length(Spin)), quaternion.Euler(0.3f, 0.2f, 0.1f)));

        static float3 At(in RigidPose pose, float3 point) => pose.position + math.mul(pose.rotation, point);

        static void AssertNear(float3 found, float3 expected, float within)
            => Assert.That(math.distance(found, expected), Is.LessThan(within), $"{found}, not {expected}");
    }
}
