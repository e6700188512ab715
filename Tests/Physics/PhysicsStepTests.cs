using System;
using System.Collections;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>A body floats alike whenever the physics steps: after FixedUpdate, in Update, or where a script calls it.</summary>
    public class PhysicsStepTests
    {
        const float Ball = 0.4f;

        FloatingScene scene;
        float fixedStep;

        [SetUp]
        public void OneFrameEach60th()
        {
            fixedStep = Time.fixedDeltaTime;
            Time.captureDeltaTime = FloatingScene.Frame;
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
        [UnityTest]
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
    }
}
