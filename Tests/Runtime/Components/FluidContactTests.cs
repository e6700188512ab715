using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Contacts of a playing fluid with Fluid Colliders.</summary>
    public class FluidContactTests : PlayedFluidFixture
    {
        readonly List<string> told = new List<string>();

        [UnityTest]
        public IEnumerator A_block_that_falls_on_a_plate_touches_hits_and_leaves_it_once([Values(DeepWater.Off, DeepWater.On)] DeepWater deepWater)
        {
            told.Clear();
            FluidSimulation fluid = Fluid("Fluid", new Vector3(0.8f, 1f, 0.8f), 0.05f, 500, Vector3.zero, made =>
            {
                AddWater(made, new Vector3(0.3f, 0.3f, 0.3f), new Vector3(0f, 0.3f, 0f));
                SolverSettings settings = made.Settings;
                settings.deepWater = deepWater;
                made.Settings = settings;
            });
            FluidCollider plate = Plate(new Vector3(0f, -0.2f, 0f));
            FluidContact touch = default, hit = default;
            plate.OnEnter += contact => { told.Add("touched"); touch = contact; };
            plate.OnHit += contact => { told.Add("hit"); hit = contact; };
            plate.OnExit += contact => told.Add("left");
            plate.HitImpulse = 5f;
            yield return Frames(12);
            Assert.That(told, Is.Empty, "while it falls");
            yield return Frames(24);
            Assert.That(told, Is.EqualTo(new[] { "touched", "hit" }));
            Assert.That(touch.Collider, Is.SameAs(plate));
            Assert.That(touch.Fluid, Is.SameAs(fluid));
            Assert.That(touch.Step, Is.InRange(14, 16), "0.247 s are 14.8 steps");
            // It falls 0.3 m in 0.247 s, to 2.43 m/s. What is stopped at its base and free elsewhere has a pressure impulse there, by Laplace's
            // equation in the block, of 11.1 N s. From then on the plate turns 531 N of momentum aside, density times base times speed². A
            // reading ends with a step, and the solver tells when it touched to half of one.
            const float slap = 11.1f, flow = 531f, fallTime = 0.247f, step = 1f / 60f;
            float since = hit.Step * step - fallTime;
            TestContext.Out.WriteLine($"impulse {hit.Impulse.y} N s at step {hit.Step}, {since:0.000} s after the touch");
            Assert.That(-hit.Impulse.y, Is.InRange(0.9f * slap, 1.1f * slap + flow * (since + 0.5f * step)));
            Assert.That(new Vector2(hit.Impulse.x, hit.Impulse.z).magnitude, Is.LessThan(0.05f * slap), "straight down");
            Assert.That(plate.TryGetForce(out _, out _), Is.False, "which Measures Force would bring");

            plate.transform.position = new Vector3(0f, 0.44f, 0f);
            plate.Teleport();
            yield return Frames(24);
            Assert.That(told, Is.EqualTo(new[] { "touched", "hit", "left" }), "the water is below it");
        }

        [UnityTest]
        public IEnumerator A_listener_that_throws_is_logged_and_others_hear_all_the_same_and_the_fluid_goes_on()
        {
            told.Clear();
            FluidSimulation fluid = Fluid("Fluid", new Vector3(0.8f, 0.8f, 0.8f), 0.05f, 2000, new Vector3(0.8f, 0.4f, 0.8f));
            FluidCollider first = Plate(new Vector3(-0.25f, -0.2f, 0f)), second = Plate(new Vector3(0.25f, -0.2f, 0f));
            foreach (FluidCollider plate in new[] { first, second })
            {
                plate.HitImpulse = 1e-6f;
                plate.OnEnter += contact => throw new System.InvalidOperationException("touched by " + contact.Fluid.name);
                plate.OnEnter += contact => told.Add("enter");
                plate.OnHit += contact => told.Add("hit");
                plate.OnExit += contact => throw new System.InvalidOperationException("left " + contact.Fluid.name);
            }
            for (int i = 0; i < 2; i++)
                LogAssert.Expect(LogType.Exception, new Regex("InvalidOperationException: touched by Fluid"));
            yield return Frames(10);
            Assert.That(told, Is.EqualTo(new[] { "enter", "hit", "enter", "hit" }));

            first.transform.position = second.transform.position = new Vector3(10f, 0f, 0f);
            for (int i = 0; i < 2; i++)
                LogAssert.Expect(LogType.Exception, new Regex("InvalidOperationException: left Fluid"));
            int step = fluid.StepCount;
            yield return Frames(5);
            Assert.That(fluid.StepCount, Is.EqualTo(step + 5), "no step was missed");
        }

        [UnityTest]
        public IEnumerator What_leaves_the_box_leaves_the_water_and_listeners_may_disable_anything()
        {
            told.Clear();
            FluidSimulation fluid = Fluid("Fluid", new Vector3(0.6f, 0.6f, 0.6f), 0.05f, 1000, new Vector3(0.6f, 0.3f, 0.6f));
            FluidCollider plate = Plate(new Vector3(0f, -0.2f, 0f));
            plate.OnEnter += contact => told.Add("touched");
            plate.OnExit += contact =>
            {
                told.Add($"left {contact.Fluid.name} {contact.Impulse}");
                plate.enabled = fluid.enabled = false;
            };
            yield return Frames(10);
            plate.transform.position = new Vector3(10f, 0f, 0f);
            yield return Frames(3);
            Assert.That(told, Is.EqualTo(new[] { "touched", $"left Fluid {Vector3.zero}" }));
            Assert.That(fluid.enabled, Is.False);
        }

        [UnityTest]
        public IEnumerator A_fluid_that_begins_again_forgets_what_it_did_to_colliders()
        {
            told.Clear();
            FluidSimulation fluid = Fluid("Fluid", new Vector3(0.6f, 0.6f, 0.6f), 0.05f, 1000, new Vector3(0.6f, 0.3f, 0.6f));
            yield return Frames(2);
            FluidCollider plate = Plate(new Vector3(0f, -0.2f, 0f));
            plate.MeasuresForce = true;
            plate.OnEnter += contact => told.Add("touched");
            plate.OnExit += contact => told.Add("left");
            yield return Frames(16);
            Assert.That(plate.TryGetForce(out _, out _));
            Assert.That(told, Is.EqualTo(new[] { "touched" }));
            fluid.Restart();
            Assert.That(plate.TryGetForce(out _, out _), Is.False, "of before");
            int step = fluid.StepCount;
            int touched = 0;
            plate.OnEnter += contact => touched = contact.Step;
            yield return Frames(10);
            Assert.That(plate.TryGetForce(out _, out _), "of now");
            Assert.That(told, Is.EqualTo(new[] { "touched", "touched" }), "it did not leave");
            Assert.That(touched, Is.GreaterThan(step), "no step of before");
        }

        [UnityTest]
        public IEnumerator A_restored_fluid_does_to_colliders_what_it_did_and_tells_no_contact_twice([Values(0, 1)] int framesBefore)
        {
            told.Clear();
            FluidSimulation fluid = Fluid("Fluid", new Vector3(0.6f, 0.6f, 0.6f), 0.05f, 1000, new Vector3(0.6f, 0.3f, 0.6f));
            yield return Frames(2);
            FluidCollider plate = Plate(new Vector3(0f, -0.2f, 0f));
            plate.MeasuresForce = true;
            plate.OnEnter += contact => told.Add("touched");
            plate.OnExit += contact => told.Add("left");
            yield return Frames(10);
            FluidSnapshotRequest request = fluid.RequestSnapshot();
            var expected = new List<Vector3>();
            yield return Forces(plate, expected);
            yield return Frames(framesBefore);      // an answer may be pending, and is not in the snapshot
            fluid.Restore(request.Snapshot);
            var found = new List<Vector3>();
            yield return Forces(plate, found);
            Assert.That(found, Is.EqualTo(expected));
            Assert.That(expected.Distinct().Count(), Is.GreaterThan(2), "forces change");
            Assert.That(told, Is.EqualTo(new[] { "touched" }));
        }

        static IEnumerator Forces(FluidCollider plate, List<Vector3> to)
        {
            for (int i = 0; i < 8; i++)
            {
                Assert.That(plate.TryGetForce(out Vector3 force, out _));
                to.Add(force);
                yield return null;
            }
        }

        [UnityTest]
        public IEnumerator Without_a_listener_no_force_is_read_back()
        {
            FluidSimulation fluid = Fluid("Fluid", new Vector3(0.6f, 0.6f, 0.6f), 0.05f, 1000, new Vector3(0.6f, 0.3f, 0.6f));
            FluidCollider plate = Plate(new Vector3(0f, -0.2f, 0f));
            void Listen(FluidContact contact) => told.Add("touched");
            yield return Frames(3);
            Assert.That(fluid.Solver.Reactions, Is.Null);
            plate.OnEnter += Listen;
            yield return Frames(2);
            Assert.That(fluid.Solver.Reactions, Is.Not.Null);
            plate.OnEnter -= Listen;
            yield return Frames(2);
            Assert.That(fluid.Solver.Reactions, Is.Null);
        }

        [Test]
        public void An_impulse_out_of_range_is_clamped_and_said()
        {
            FluidCollider plate = Plate(Vector3.zero);
            LogAssert.Expect(LogType.Warning, new Regex("FluidCollider 'Plate': hit impulse 0 is outside"));
            plate.HitImpulse = 0f;
            Assert.That(plate.HitImpulse, Is.EqualTo(1e-6f));
            LogAssert.NoUnexpectedReceived();
        }

        FluidCollider Plate(Vector3 position)
        {
            var thing = new GameObject("Plate");
            made.Add(thing);
            thing.transform.position = position;
            var plate = thing.AddComponent<FluidCollider>();
            plate.Size = new Vector3(0.4f, 0.1f, 0.4f);
            return plate;
        }
    }
}
