using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>The turning half of how a floating body answers to water: moments, righting, damping and the stop by still water.</summary>
    public class FloatingTurnTests
    {
        const float Step = 0.02f, Density = 1000f, Gravity = 9.81f, Mass = 20f;
        const float NoSlip = 1e6f;      // s, in which water comes to move along: so long that it resists nothing
        const float Damping = 0.8f;     // as a fraction of the critical

        static readonly Vector3 Size = new Vector3(0.4f, 0.3f, 0.5f), Center = new Vector3(1f, 2f, -1f), Arm = new Vector3(0.3f, 0.1f, -0.2f);
        static readonly Vector3 Down = Gravity * Vector3.down;

        static float Volume => Size.x * Size.y * Size.z;

        static float Buoyancy => Density * Gravity * Volume;

        // For one part all acts there: what was measured, its change since, the limit of what pushes, and the damping.
        [Test]
        public void Forces_turn_the_body_by_their_arm([Values(0f, 0.05f, 2f)] float speed, [Values(0f, 0.05f)] float rise,
            [Values(0.4f, 3f)] float force)
        {
            var response = new FloatingResponse();
            Vector3 torque = Vector3.zero, push = Vector3.zero;
            for (int i = 0; i < 2; i++)
            {
                response.Begin(Mass, Center, speed * Vector3.up, Vector3.zero, Step);
                response.Tune(0f, Damping);
                Add(response, Shape(Center + Arm), (i == 0 ? 0.5f : force) * Buoyancy * Vector3.up, rise);
                response.EndFluid(Density, Down);
                response.Solve(Down, Vector3.zero, 1e6f, out Vector3 acceleration, out _);
                torque = response.Torque;
                push = Mass * (acceleration - Down);
            }
            Assert.That(push.magnitude, Is.GreaterThan(1f), "N");
            AssertNear(torque, Vector3.Cross(Arm, push), 1e-3f * push.magnitude);
        }

        // Pressure goes through the center of a ball; only friction turns it.
        [TestCase(ColliderShape.Box, 0f, 1f)]
        [TestCase(ColliderShape.Sphere, 0f, 0f)]
        [TestCase(ColliderShape.Sphere, 0.1f, 1f)]
        public void A_torque_on_a_ball_counts_by_its_friction_alone(ColliderShape shape, float friction, float counts)
        {
            var response = new FloatingResponse();
            response.Begin(Mass, Center, Vector3.zero, Vector3.zero, Step);
            ColliderMotion part = Shape(Center);
            part.shape = shape;
            part.friction = friction;
            Vector3 torque = new Vector3(3f, -2f, 5f);
            response.AddPart(part, Volume);
            response.Add(part, Volume, new FluidForce(null, Vector3.zero, torque, Motion(part, 0f)));
            response.EndFluid(Density, Vector3.zero);
            AssertNear(response.Torque, counts * torque, 1e-4f);
        }

        [Test]
        public void Water_rights_a_tilt_and_no_turn_about_the_vertical()
        {
            AssertNear(Righting(Quaternion.Euler(0f, 20f, 0f)), Vector3.zero, 1e-3f);
            Vector3 tilted = Righting(Quaternion.Euler(0f, 0f, 3f));
            Assert.That(tilted.z, Is.LessThan(-1f), "N m");
            Vector3 both = Righting(Quaternion.Euler(0f, 20f, 0f) * Quaternion.Euler(0f, 0f, 3f));
            Assert.That(Mathf.Abs(both.y), Is.LessThan(1e-3f));
            Assert.That(both.magnitude / tilted.magnitude, Is.InRange(0.8f, 1.6f), "by the square of a width between 0.4 and 0.5 m");
        }

        static Vector3 Righting(Quaternion turn)
        {
            var response = new FloatingResponse();
            response.Begin(Mass, Center, Vector3.zero, Vector3.zero, Step);
            ColliderMotion part = Shape(Center);
            RelativeMotion then = Motion(part, 0f);
            part.start.rotation = part.end.rotation = turn;
            response.AddPart(part, Volume);
            response.Add(part, Volume, new FluidForce(null, 0.5f * Buoyancy * Vector3.up, Vector3.zero, then));
            response.EndFluid(Density, Down);
            return response.Torque;
        }

        // Three times as strongly as heave: 2 sqrt(K I) of a prism of the body's height h and volume on a square of area A, with
        // K = rho g A A / 12 and I = (m + half of the water displaced) (A + h²) / 12.
        [Test]
        public void Turns_are_damped_by_a_fraction_of_the_critical([Values(0.5f, 0.1f)] float fraction)
        {
            var response = new FloatingResponse();
            Vector3 spin = new Vector3(0.5f, 0.3f, -0.7f);
            response.Begin(Mass, Center, Vector3.zero, spin, Step);
            response.Tune(0f, Damping);
            Add(response, Shape(Center), fraction * Buoyancy * Vector3.up, 0f);
            response.EndFluid(Density, Down);
            float area = Volume / Size.y, carried = Mass + 0.5f * fraction * Density * Volume;
            float critical = 2f * Mathf.Sqrt(Density * Gravity * area * area / 12f * carried * (area + Size.y * Size.y) / 12f);
            float wet = Mathf.Min(4f * fraction, 1f);
            AssertNear(response.Torque, -3f * Damping * wet * critical * spin, 1e-3f * critical);
        }

        // No more than what is missing of the lift, and of the moment the same fraction.
        [TestCase(50f, 0.5f)]
        [TestCase(500f, 1f)]
        public void Covered_faces_turn_the_body_as_far_as_they_lift_it(float maxLift, float fraction)
        {
            var moment = new Vector3(1f, 2f, -3f);
            var still = new StillWater { coveredPush = 100f * Vector3.up, coveredMoment = moment, maxLift = maxLift };
            var response = new FloatingResponse();
            response.Begin(Mass, Center, Vector3.zero, Vector3.zero, Step);
            response.Tune(0f, Damping);
            Add(response, Shape(Center), Vector3.zero, 0f);
            response.EndFluid(Density, Down, still);
            response.Solve(Down, Vector3.zero, 1e6f, out Vector3 acceleration, out _);
            AssertNear(Mass * (acceleration - Down), fraction * 100f * Vector3.up, 0.1f);
            AssertNear(response.Torque, fraction * moment, 1e-3f);
        }

        // The damping of a turn is to the moment of inertia as that of heave is to the mass, where that moment is the mass times the
        // second moment of the waterline over its area. Of the moments the smallest that is one: a light axis is never turned back.
        [Test]
        public void Still_water_stops_a_turn_as_it_stops_heave([Values(0.2f, 1f)] float contact, [Values(0.4f, 1.2f)] float under)
        {
            float area = Volume / Size.y, moment = Mass * area / 12f, speed = 0.4f;
            var spin = new Vector3(1f, -2f, 0.5f);
            foreach (Vector3 moments in new[] { new Vector3(5f * moment, moment, 3f * moment), new Vector3(moment, 0f, 2f * moment) })
            {
                var response = new FloatingResponse();
                response.Begin(Mass, Center, speed * Vector3.up, spin, Step, moments);
                response.Tune(0f, Damping);
                Add(response, Shape(Center), 0.5f * Buoyancy * Vector3.up, 0f);
                response.EndFluid(Density, Down, Still(1f, Center.y + (under - 0.5f) * Size.y, contact));
                AssertNear(response.Torque, Vector3.zero, 1e-5f);
                response.Solve(Down, Vector3.zero, 1e6f, out Vector3 acceleration, out Vector3 angular);
                float stopped = -acceleration.y / speed;
                Assert.That(stopped, Is.GreaterThan(1f), "1/s");
                AssertNear(angular, -stopped * spin, 1e-3f * stopped);
            }
        }

        [Test]
        public void The_moment_of_still_water_stands_for_the_measured_one_by_its_weight()
        {
            var spin = new Vector3(1f, -2f, 0.5f);
            Vector3 measured = Torque(0f), still = Torque(1f);
            Assert.That(Vector3.Distance(measured, still), Is.GreaterThan(1f), "N m");
            AssertNear(still, new Vector3(4f, 0f, -2f), 1e-4f);
            AssertNear(Torque(0.25f), 0.75f * measured + 0.25f * still, 1e-3f * measured.magnitude);

            Vector3 Torque(float weight)
            {
                var response = new FloatingResponse();
                response.Begin(Mass, Center, Vector3.zero, spin, Step);
                Add(response, Shape(Center + Arm), 0.5f * Buoyancy * Vector3.up, 0f);
                StillWater water = Still(weight, Center.y, 1f);
                water.moment = new Vector3(4f, 0f, -2f);
                response.EndFluid(Density, Down, water);
                return response.Torque;
            }
        }

        // The known resistance of water to a motion tells nothing about turns.
        [Test]
        public void The_resistance_against_turns_is_the_setting_s_whatever_motion_tells()
        {
            Respond(-12f, out float resisted, out Vector3 turned);
            Respond(12f, out float less, out Vector3 same);
            Assert.That(resisted, Is.GreaterThan(2f * less), "motion is resisted as was measured");
            Assert.That(turned.magnitude, Is.GreaterThan(1f), "rad/s²");
            AssertNear(same, turned, 0.3f * turned.magnitude);

            void Respond(float change, out float motion, out Vector3 angular)
            {
                const float memory = 0.1f;
                var response = new FloatingResponse();
                Vector3 acceleration = Vector3.zero;
                angular = Vector3.zero;
                for (int i = 0; i < 4; i++)
                {
                    Vector3 slip = i > 0 ? Vector3.right : Vector3.zero, spin = new Vector3(0f, 1f, 0f);      // the first tells the level
                    response.Begin(Mass, Center, Vector3.zero, Vector3.zero, Step);
                    response.Tune(2.5f, 0f);
                    ColliderMotion part = Shape(Center);
                    response.AddPart(part, Volume);
                    Vector3 force = 0.5f * Buoyancy * Vector3.up + Density * Volume * (i < 3 ? 0.5f * change : 0f) * slip;
                    response.Add(part, Volume, new FluidForce(null, force, Vector3.zero,
                        new RelativeMotion(Center, Quaternion.identity, slip, spin, memory)));
                    response.EndFluid(Density, Down);
                    response.Solve(Down, Vector3.zero, 1e6f, out acceleration, out angular);
                }
                motion = acceleration.x;
            }
        }

        static StillWater Still(float weight, float level, float contact) => new StillWater
        {
            weight = weight, level = level, contact = contact, push = Mass * Gravity * Vector3.up, maxLift = Buoyancy
        };

        static void Add(FloatingResponse response, in ColliderMotion part, Vector3 force, float rise)
        {
            response.AddPart(part, Volume);
            response.Add(part, Volume, new FluidForce(null, force, Vector3.zero, Motion(part, rise)));
        }

        // How a part was when its force was measured.
        static RelativeMotion Motion(in ColliderMotion part, float rise)
            => new RelativeMotion((Vector3)part.end.position - rise * Vector3.up, Quaternion.identity, Vector3.zero, Vector3.zero, NoSlip);

        static ColliderMotion Shape(Vector3 at)
        {
            var pose = new RigidPose(at, quaternion.identity);
            return new ColliderMotion { shape = ColliderShape.Box, size = 0.5f * (float3)Size, start = pose, end = pose };
        }

        static void AssertNear(Vector3 found, Vector3 expected, float within)
            => Assert.That(Vector3.Distance(found, expected), Is.LessThanOrEqualTo(within), $"{found}, not {expected}");
    }
}
