using System;
using System.Collections;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>A body floats alike whenever the physics steps: after FixedUpdate, in Update, or where a script calls it.</summary>
    public class PhysicsStepTests
    {
        const float Ball = 0.4f;

        FloatingScene scene;
        float fixedStep;

        [UnitySetUp]
        public IEnumerator OneFrameEach60th()
        {
            fixedStep = Time.fixedDeltaTime;
            yield return PhysicsClock.Begin(FloatingScene.Frame);
        }

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            scene?.Dispose();
            scene = null;
            Time.captureDeltaTime = 0f;
            Time.fixedDeltaTime = fixedStep;
            UnityEngine.Physics.simulationMode = SimulationMode.FixedUpdate;
            yield return null;
        }

        // With four fixed steps a frame or one in two frames, while the physics steps once a frame. Both ways to float have each mode once.
        [UnityTest, Category("LongRun")]
        public IEnumerator A_body_floats_at_its_draft_however_many_fixed_steps_there_are([Values(SimulationMode.Update,
            SimulationMode.Script)] SimulationMode mode, [Values(1f / 240f, 1f / 30f)] float each)
        {
            bool byLayer = mode == SimulationMode.Update == each < FloatingScene.Frame;
            Time.fixedDeltaTime = each;
            UnityEngine.Physics.simulationMode = mode;
            const int layers = 8;
            scene = new FloatingScene(ColliderShape.Sphere, Ball * Vector3.one, 0.5f, layers * FloatingScene.Spacing, layers, 16,
                byLayer: byLayer);
            Action step = () => UnityEngine.Physics.Simulate(FloatingScene.Frame);
            yield return scene.Play(2f, mode == SimulationMode.Script ? step : null);
            float[] last = scene.Heights.Skip(scene.Heights.Count - scene.Heights.Count / 5).ToArray();
            TestContext.Out.WriteLine($"{(last.Average() - scene.Level) / Ball:0.000} of its height over the draft, restless by " +
                $"{(last.Max() - last.Min()) / Ball:0.000}, fastest {scene.Speeds.Max():0.00} m/s");
            Assert.That(last.Average(), Is.EqualTo(scene.Level).Within(0.15f * Ball), "half of it is under water");
            Assert.That(last.Max() - last.Min(), Is.LessThan(0.25f * Ball), "it is at rest");
            Assert.That(scene.Speeds.Max(), Is.LessThan(1.5f), "nothing threw it");
        }

        [Test]
        public void A_script_s_step_takes_a_turn_along_as_it_takes_a_motion()
        {
            UnityEngine.Physics.simulationMode = SimulationMode.Script;
            Time.fixedDeltaTime = 1f / 40f;
            Rigidbody body = Body();
            PhysicsStep step = PhysicsStep.OfFixedUpdate(body.gameObject);
            Assert.That(step.Time, Is.EqualTo(1f / 40f));
            for (int i = 0; i < 2; i++)
                step.Accelerate(body, new Vector3(0f, 2f, 0f), new Vector3(0f, 0f, 3f));
            UnityEngine.Physics.Simulate(1f / 100f);
            Assert.That(Vector3.Distance(body.GetPointVelocity(body.worldCenterOfMass), new Vector3(0f, 0.1f, 0f)), Is.LessThan(1e-3f), "m/s");
            Assert.That(Vector3.Distance(body.angularVelocity, new Vector3(0f, 0f, 0.15f)), Is.LessThan(1e-3f), "rad/s");
            Object.DestroyImmediate(body.gameObject);
        }

        // About each of its principal axes as much as its moment of inertia lets it; not about one that has none.
        [Test]
        public void A_torque_turns_a_body_by_the_moments_about_its_own_axes_however_it_lies()
        {
            Rigidbody body = Body();
            body.rotation = Quaternion.Euler(30f, 70f, -20f);
            body.inertiaTensor = new Vector3(1f, 2f, 4f);
            body.inertiaTensorRotation = Quaternion.Euler(0f, 40f, 25f);
            Quaternion axes = body.rotation * body.inertiaTensorRotation;
            Vector3 turn = FloatingBody.Turn(body, axes * new Vector3(6f, 6f, 6f));
            Assert.That(Vector3.Distance(turn, axes * new Vector3(6f, 3f, 1.5f)), Is.LessThan(1e-4f));
            body.inertiaTensor = new Vector3(1f, 0f, 4f);
            turn = FloatingBody.Turn(body, axes * new Vector3(6f, 6f, 6f));
            Assert.That(Vector3.Distance(turn, axes * new Vector3(6f, 0f, 1.5f)), Is.LessThan(1e-4f));
            Object.DestroyImmediate(body.gameObject);
        }

        // By 1 / (0.05 s + the step), and of its weight nothing is left.
        [UnityTest]
        public IEnumerator A_body_that_waits_for_its_fluid_stops_to_turn_as_it_stops_to_move()
        {
            scene = new FloatingScene(ColliderShape.Sphere, Ball * Vector3.one, 0.5f, 1f, 2, 6);
            yield return null;
            Assert.That(scene.Fluid.IsRunning);
            UnityEngine.Physics.simulationMode = SimulationMode.Script;
            Time.fixedDeltaTime = 0.1f;
            Rigidbody body = Body();
            body.useGravity = true;
            Vector3 velocity = new Vector3(0.5f, -2f, 1f), spin = new Vector3(-1f, 2f, 0.5f);
            body.AddForce(velocity, ForceMode.VelocityChange);
            body.angularVelocity = spin;
            UnityEngine.Physics.Simulate(1e-4f);
            var floating = new FloatingBody();
            PhysicsStep step = PhysicsStep.OfFixedUpdate(body.gameObject);
            for (int i = 0; i < 2; i++)
            {
                floating.Begin(body, step, 0f, 0f);
                floating.Await(scene.Fluid);
            }
            Assert.That(floating.TryApply(body, 100f));
            UnityEngine.Physics.Simulate(0.1f);
            Assert.That(Vector3.Distance(body.GetPointVelocity(body.worldCenterOfMass), velocity / 3f), Is.LessThan(0.01f), "m/s");
            Assert.That(Vector3.Distance(body.angularVelocity, spin / 3f), Is.LessThan(0.01f), "rad/s");
            Object.DestroyImmediate(body.gameObject);
        }

        static Rigidbody Body()
        {
            var body = GameObject.CreatePrimitive(PrimitiveType.Cube).AddComponent<Rigidbody>();
            body.useGravity = false;
            return body;
        }
    }
}
