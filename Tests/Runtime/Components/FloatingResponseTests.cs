using System.Collections.Generic;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>
    /// A body on water whose force is known late: buoyancy by its draft, less a resistance against the slip, by which the water
    /// comes to move along. Also water that does so sooner, later, less or more than the response takes it to.
    /// </summary>
    public class FloatingResponseTests
    {
        const float Step = 0.02f, Substep = 1f / 60f, Drag = 5f, Size = 0.4f, Density = 1000f, Gravity = 9.81f;

        static readonly float3 Up = new float3(0f, 1f, 0f);

        [Test]
        public void A_late_force_brings_a_body_to_rest_at_every_density([Values(0.1f, 0.3f, 0.5f, 0.9f)] float ratio,
            [Values(20f, 40f, 70f)] float resistance, [Values(1, 2, 4)] int substeps, [Values(2, 4, 6)] int delay)
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

        [Test]
        public void A_late_force_heaves_a_body_at_the_period_of_the_same_water_at_once(
            [Values(ColliderShape.Box, ColliderShape.Sphere)]
        ColliderShape shape, [Values(0.3f, 0.5f)] float addedMass, [Values(2, 3, 4)] int delay)
        {
            float atOnce = HeavePeriod(new Bath(shape, 0.5f, 0f, 1, 0f, addedMass), delay: 0, step: 0.001f, out _);
            float period = HeavePeriod(new Bath(shape, 0.5f, 0f, 1, 0f, addedMass), delay, Step, out float growth);
            TestContext.Out.WriteLine($"period {period:0.000} s, {100f * (period / atOnce - 1f):+0.0;-0.0} % off that at once, " +
                $"{atOnce:0.000} s; swings by {growth:0.00} of where it was let go");
            Assert.That(period, Is.EqualTo(atOnce).Within((shape == ColliderShape.Sphere ? 0.06f : 0.05f) * atOnce));
            Assert.That(growth, Is.EqualTo(1f).Within(0.3f), "nor is its heave driven or damped");
        }

        // Period of the first two swings without the response's damping. Growth: largest distance from rest in the last half swing over the first.
        static float HeavePeriod(Bath bath, int delay, float step, out float growth)
        {
            const float Lift = 0.15f * Size;
            bath.Height = Lift;
            float first = 0f, last = Lift, peak = 0f;
            int crossings = 0;
            for (int i = 1; i < 5f / step; i++)
            {
                bath.Advance(step, delay, responds: delay > 0, damping: 0f, isHeld: i <= delay);        // until the first force is known
                if (bath.Height > 0f != last > 0f)
                {
                    float at = (i - bath.Height / (bath.Height - last)) * step;
                    first = crossings == 0 ? at : first;
                    if (++crossings == 5)
                    {
                        growth = peak / Lift;
                        return 0.5f * (at - first);
                    }
                    peak = 0f;
                }
                last = bath.Height;
                peak = math.max(peak, math.abs(last));
            }
            growth = float.NaN;
            return float.NaN;
        }

        // Height over the level in the end; the highest; the largest speed in the last second.
        static float Float(float ratio, float resistance, int substeps, int delay, bool responds, out float highest, out float restless)
        {
            const int Steps = 700;
            var bath = new Bath(ColliderShape.Box, ratio, resistance, substeps, Drag, 0f) { Height = 0.5f * Size };
            highest = bath.Height;
            restless = 0f;
            for (int i = 0; i < Steps; i++)
            {
                bath.Advance(Step, delay, responds, FloatingResponse.DefaultDamping);
                highest = math.max(highest, bath.Height);
                if (i >= Steps - 50)
                    restless = math.max(restless, math.abs(bath.Speed));
                if (!(math.abs(bath.Height) < 1e3f))
                    break;
            }
            return bath.Height;
        }

        /// <summary>A body and its water, and the forces that are pending.</summary>
        sealed class Bath
        {
            readonly ColliderShape shape;
            readonly float ratio, resistance, memory, drag, addedMass;
            readonly List<FluidForce> forces = new List<FluidForce>();
            readonly FloatingResponse response = new FloatingResponse();
            SlipVelocity slip, known;
            float last;

            public float Height, Speed;

            /// <param name="ratio">Of the densities.</param>
            /// <param name="resistance">Against slip, 1/s.</param>
            /// <param name="substeps">In which the water comes to move along.</param>
            /// <param name="drag">1/s.</param>
            /// <param name="addedMass">At once, of the displaced water.</param>
            public Bath(ColliderShape shape, float ratio, float resistance, int substeps, float drag, float addedMass)
            {
                this.shape = shape;
                this.ratio = ratio;
                this.resistance = resistance;
                this.drag = drag;
                this.addedMass = addedMass;
                memory = substeps * Substep;
            }

            /// <param name="delay">Steps by which the force is late; 0: that of this step, with its added mass carried along.</param>
            public void Advance(float step, int delay, bool responds, float damping, bool isHeld = false)
            {
                var gravity = new Vector3(0f, -Gravity, 0f);
                float depth = math.saturate(0.5f - Height / Size);
                bool isBall = shape == ColliderShape.Sphere;
                float wet = isBall ? depth * depth * (3f - 2f * depth) : depth;
                float volume = Size * Size * Size * (isBall ? math.PI / 6f : 1f), displaced = Density * volume, mass = ratio * displaced;
                float push = displaced * wet * (Gravity - resistance * slip.Follow(Speed * Up, step, memory).y - drag * Speed);
                float carried = displaced * wet * addedMass;
                float late = push - carried * (Speed - last) / step;
                last = Speed;
                var motion = new RelativeMotion(Vector3.up * Height, Quaternion.identity, known.Follow(Speed * Up, step, 4f * Substep),
                    Vector3.zero, 4f * Substep);
                forces.Add(new FluidForce(null, Vector3.up * late, Vector3.zero, motion));
                float next = delay == 0 ? (push - Gravity * mass) / (mass + carried) : -Gravity;
                int newest = forces.Count - 1 - delay;
                if (delay > 0 && newest >= 0 && !responds)
                    next += forces[newest].Force.y / mass;
                if (delay > 0 && newest >= 0 && responds)
                {
                    var pose = new RigidPose(new float3(0f, Height, 0f), quaternion.identity);
                    var now = new ColliderMotion { shape = shape, size = 0.5f * Size, start = pose, end = pose };
                    response.Begin(mass, now.end.position, Vector3.up * Speed, Vector3.zero, step);
                    response.Tune(FloatingResponse.DefaultVirtualMass, damping);
                    response.AddPart(now, volume);
                    response.Add(now, volume, forces[newest]);
                    response.EndFluid(Density, gravity);
                    response.Solve(gravity, Vector3.zero, FloatingResponse.DefaultMaxAcceleration, out Vector3 acceleration, out _);
                    next = acceleration.y;
                }
                if (isHeld)
                    return;
                Speed += next * step;
                Height += Speed * step;
            }
        }
    }
}
