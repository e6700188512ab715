using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>A body of several parts answers to forces as the one collider of the same shape.</summary>
    public class FloatingPartsTests
    {
        const float Step = 0.02f, Memory = 4f / 60f, Density = 1000f, Gravity = 9.81f, Mass = 20f;
        static readonly Vector3 Size = new Vector3(0.4f, 0.3f, 0.5f);
        static readonly Vector3 Center = new Vector3(1f, 2f, -1f);

        public enum Split { SideBySide, OneOverTheOther }

        // If the upper half stands on the lower, no water presses that down: the whole buoyancy is the lower one's.
        [Test]
        public void A_box_in_halves_heaves_as_the_one_box([Values] Split split, [Values(0f, 0.5f, 1f)] float ofTheFirst)
        {
            FloatingResponse one = new FloatingResponse(), halves = new FloatingResponse();
            for (int i = 0; i < 20; i++)
            {
                float rise = 0.05f * Mathf.Sin(0.4f * i), speed = 1.5f * Mathf.Cos(0.4f * i);
                Vector3 acceleration = Respond(one, null, rise, speed, 1f, Quaternion.identity, out _);
                Vector3 same = Respond(halves, split, rise, speed, ofTheFirst, Quaternion.identity, out _);
                Assert.That(Vector3.Distance(same, acceleration), Is.LessThan(1e-3f * (1f + acceleration.magnitude)), $"step {i}");
                Assert.That(halves.Fraction, Is.EqualTo(one.Fraction).Within(1e-4f));
            }
        }

        [Test]
        public void Its_halves_right_it_as_the_one_box_does([Values] Split split)
        {
            FloatingResponse one = new FloatingResponse(), halves = new FloatingResponse();
            Quaternion tilt = Quaternion.Euler(0f, 0f, 3f);
            Vector3 turn = Vector3.zero, same = Vector3.zero;
            for (int i = 0; i < 3; i++)
            {
                Respond(one, null, 0f, 0f, 1f, tilt, out turn);
                Respond(halves, split, 0f, 0f, 0.5f, tilt, out same);
            }
            Assert.That(turn.z, Is.LessThan(-1f), "N m, against the tilt");
            // A stack floats to where its halves meet, the worst for it: both have some of the waterline, each less than all.
            Assert.That(same.z, Is.EqualTo(turn.z).Within((split == Split.SideBySide ? 0.02f : 0.15f) * Mathf.Abs(turn.z)));
        }

        [Test]
        public void One_limit_holds_for_the_body_however_many_parts_it_has()
        {
            var response = new FloatingResponse();
            response.Begin(Mass, Center, Vector3.zero, Vector3.zero, Step);
            Add(response, Center, Size, Density * Vector3.up, Center, Quaternion.identity);
            Add(response, Center, Size, Density * 100f * Vector3.up, Center, Quaternion.identity);
            response.EndFluid(Density, Gravity * Vector3.down);
            response.Solve(Vector3.zero, Vector3.zero, 5f, out Vector3 acceleration, out _);
            Assert.That(acceleration.magnitude, Is.EqualTo(5f).Within(1e-3f));
        }

        // Half the diagonal of the box is 0.354 m; a second part reaches 1 m further.
        [TestCase(0f, 0.353553f)]
        [TestCase(1f, 1.353553f)]
        public void The_limit_holds_at_the_farthest_point_of_a_body_that_turns(float aside, float reach)
        {
            foreach (float turn in new[] { 0.9f * 5f / reach, 2f * 5f / reach, 1000f })
            {
                var response = new FloatingResponse();
                response.Begin(1e6f, Center, Vector3.zero, Vector3.zero, Step);     // so heavy that the water resists no turn
                Add(response, Center, Size, Vector3.zero, Center, Quaternion.identity);
                Add(response, Center + aside * Vector3.right, Size, Vector3.zero, Center, Quaternion.identity);
                response.EndFluid(Density, Gravity * Vector3.down);
                Vector3 axis = new Vector3(0.6f, 0f, -0.8f);
                response.Solve(Vector3.zero, turn * axis, 5f, out _, out Vector3 angular);
                Assert.That(Vector3.Distance(angular, Mathf.Min(turn, 5f / reach) * axis), Is.LessThan(0.01f * 5f / reach), $"{turn} rad/s²");
            }
        }

        // Without gravity nothing tells the two halves apart: what a fluid does to a velocity it does to an angular velocity.
        [Test]
        public void Turns_are_resisted_in_proportion_to_the_inertia_as_motion_is_to_the_mass()
        {
            var response = new FloatingResponse();
            var random = new Unity.Mathematics.Random(3u);
            float resisted = 0f;
            for (int i = 0; i < 10; i++)
            {
                Vector3 velocity = random.NextFloat3(-1f, 1f), push = random.NextFloat3(-100f, 100f);
                response.Begin(Mass, Center, velocity, velocity, Step);
                foreach (Vector3 size in new[] { Size, 0.5f * Size })       // what the larger part sees counts for more
                {
                    Vector3 slip = random.NextFloat3(-1f, 1f);
                    ColliderMotion shape = Shape(Center, size, Quaternion.identity);
                    response.AddPart(shape, Volume(size));
                    response.Add(shape, Volume(size), new FluidForce(null, 0.5f * push, Vector3.zero,
                        new RelativeMotion(Center, Quaternion.identity, slip, slip, Memory)));
                }
                response.EndFluid(Density, Vector3.zero);
                response.Solve(Vector3.zero, push / Mass, 1e6f, out Vector3 acceleration, out Vector3 angular);
                Assert.That(Vector3.Distance(angular, acceleration), Is.LessThan(1e-3f * (1f + acceleration.magnitude)), $"step {i}");
                resisted = Mathf.Max(resisted, Vector3.Distance(acceleration, push / Mass));
            }
            Assert.That(resisted, Is.GreaterThan(1f), "the water resists");
        }

        [Test]
        public void A_part_that_no_fluid_tells_of_counts_as_dry()
        {
            var response = new FloatingResponse();
            response.Begin(Mass, Center, Vector3.zero, Vector3.zero, Step);
            response.AddPart(Shape(Center + Vector3.up, Size, Quaternion.identity), Volume(Size));
            Add(response, Center, Size, Density * Gravity * Volume(Size) * Vector3.up, Center, Quaternion.identity);
            response.EndFluid(Density, Gravity * Vector3.down);
            Assert.That(response.Fraction, Is.EqualTo(0.5f).Within(1e-3f));
        }

        // Half under water where it was, at Center; now it has risen and tilted. The first part has a fraction of the force.
        static Vector3 Respond(FloatingResponse response, Split? split, float rise, float speed, float ofTheFirst, Quaternion tilt,
            out Vector3 torque)
        {
            Vector3 gravity = Gravity * Vector3.down, now = Center + rise * Vector3.up;
            response.Begin(Mass, now, speed * Vector3.up, Vector3.zero, Step);
            response.Tune(FloatingResponse.DefaultVirtualMass, 0.5f);
            Vector3 force = 0.5f * Density * Gravity * Volume(Size) * Vector3.up;
            if (split == null)
                Add(response, now, Size, force, Center, tilt);
            else
            {
                Vector3 axis = split == Split.SideBySide ? Vector3.right : Vector3.up;
                Vector3 half = Size - 0.5f * Vector3.Scale(axis, Size), off = 0.25f * Vector3.Scale(axis, Size);
                Add(response, now - tilt * off, half, ofTheFirst * force, Center - off, tilt);
                Add(response, now + tilt * off, half, (1f - ofTheFirst) * force, Center + off, tilt);
            }
            response.EndFluid(Density, gravity);
            torque = response.Torque;
            response.Solve(gravity, Vector3.zero, FloatingResponse.DefaultMaxAcceleration, out Vector3 acceleration, out _);
            return acceleration;
        }

        static void Add(FloatingResponse response, Vector3 position, Vector3 size, Vector3 force, Vector3 positionThen, Quaternion rotation)
        {
            ColliderMotion shape = Shape(position, size, rotation);
            var then = new RelativeMotion(positionThen, Quaternion.identity, Vector3.zero, Vector3.zero, Memory);
            response.AddPart(shape, Volume(size));
            response.Add(shape, Volume(size), new FluidForce(null, force, Vector3.zero, then));
        }

        static ColliderMotion Shape(Vector3 position, Vector3 size, Quaternion rotation)
        {
            var pose = new RigidPose(position, rotation);
            return new ColliderMotion { shape = ColliderShape.Box, size = 0.5f * (float3)size, start = pose, end = pose };
        }

        static float Volume(Vector3 size) => size.x * size.y * size.z;
    }
}
