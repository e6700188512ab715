using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>
    /// A box on water whose force is known late: buoyancy by its draft, less a resistance against the slip, by which the water
    /// comes to move along. Also water that does so sooner, later, less or more than the response takes it to.
    /// </summary>
    public class FloatingResponseTests
    {
        const float Step = 0.02f, Substep = 1f / 60f, Drag = 5f, Size = 0.4f, Density = 1000f, Gravity = 9.81f;

        static readonly float3 Up = new float3(0f, 1f, 0f);

        [Test]
        public void A_late_force_brings_a_body_to_rest_at_every_density([Values(0.1f, 0.3f, 0.5f, 0.9f)] float ratio, [Values(20f, 40f, 70f)] float resistance, [Values(1, 2, 4)] int substeps, [Values(2, 4, 6)] int delay)
        {
            float height = Float(ratio, resistance, substeps, delay, responds: true, out float highest, out float restless);
            Assert.That(height, Is.EqualTo((0.5f - ratio) * Size).Within(0.02f * Size));
            Assert.That(restless, Is.LessThan(0.06f));
            Assert.That(highest, Is.LessThan(1.2f * Size));
        }

        [Test]
        public void A_heavy_body_sinks_and_gains_no_more_than_it_falls_by([Values(2f, 10f)] float ratio)
        {
            float height = Float(ratio, 40f, 4, 4, responds: true, out float highest, out _);
            Assert.That(height, Is.LessThan(-1f));
            Assert.That(highest, Is.LessThan(0.51f * Size));
        }

        [Test]
        public void The_same_force_as_it_comes_throws_a_light_body_out()
        {
            Float(0.1f, 40f, 4, 4, responds: false, out float highest, out _);
            Assert.That(highest, Is.GreaterThan(3f * Size));
        }

        // Height over the level in the end; the highest; the largest speed in the last second.
        static float Float(float ratio, float resistance, int substeps, int delay, bool responds, out float highest, out float restless)
        {
            float volume = Size * Size * Size, displaced = Density * volume, mass = ratio * displaced;
            var response = new FloatingResponse();
            var gravity = new Vector3(0f, -Gravity, 0f);
            const int Steps = 700;
            var force = new FluidForce[Steps];
            var slip = new SlipVelocity();
            var known = new SlipVelocity();
            float y = 0.5f * Size, v = 0f;
            highest = y;
            restless = 0f;
            for (int i = 0; i < Steps; i++)
            {
                float wet = math.saturate(0.5f - y / Size);
                float push = displaced * wet * (Gravity - resistance * slip.Follow(v * Up, Step, substeps * Substep).y - Drag * v);
                var motion = new RelativeMotion(Vector3.up * y, Quaternion.identity, known.Follow(v * Up, Step, 4f * Substep), Vector3.zero, 4f * Substep);
                force[i] = new FluidForce(null, Vector3.up * push, Vector3.zero, motion);
                float next = -Gravity;
                if (i >= delay && !responds)
                    next += force[i - delay].Force.y / mass;
                if (i >= delay && responds)
                {
                    var pose = new RigidPose(new float3(0f, y, 0f), quaternion.identity);
                    var shape = new ColliderMotion { shape = ColliderShape.Box, size = 0.5f * Size, start = pose, end = pose };
                    response.Begin(shape, volume, mass, Vector3.up * v, Vector3.zero, Step);
                    response.Add(force[i - delay], Density, gravity);
                    response.Solve(gravity, Vector3.zero, FloatingResponse.DefaultMaxAcceleration, out Vector3 acceleration, out _);
                    next = acceleration.y;
                }
                v += next * Step;
                y += v * Step;
                highest = math.max(highest, y);
                if (i >= Steps - 50)
                    restless = math.max(restless, math.abs(v));
                if (!(math.abs(y) < 1e3f))
                    break;
            }
            return y;
        }
    }
}
