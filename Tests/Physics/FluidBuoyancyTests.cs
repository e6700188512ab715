using System.Collections;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Free bodies in a tank.</summary>
    [Category("LongRun")]
    public class FluidBuoyancyTests
    {
        const float BallSize = 0.4f;
        const int Layer = 8;
        static readonly Vector3 BoxSize = new Vector3(0.5f, 0.3f, 0.5f);

        FloatingScene scene;

        [UnitySetUp]
        public IEnumerator OneStepAFrame() => PhysicsClock.Begin(FloatingScene.Frame);

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            scene?.Dispose();
            scene = null;
            Time.captureDeltaTime = 0f;
            yield return null;
        }

        // Each shape of each ratio once, and each shape and each ratio with and without deep water: all eight together take minutes on a CPU.
        [UnityTest]
        public IEnumerator A_light_body_comes_to_rest_at_Archimedes_draft([Values(ColliderShape.Sphere,
            ColliderShape.Box)] ColliderShape shape, [Values(0.1f, 0.5f)] float ratio)
        {
            DeepWater deepWater = shape == ColliderShape.Sphere == (ratio == 0.5f) ? DeepWater.On : DeepWater.Off;
            Vector3 size = Size(shape);
            scene = new FloatingScene(shape, size, ratio, 0.6f + 0.5f * size.y, deepWater: deepWater);
            yield return scene.Play(3f);
            float[] last = scene.Heights.Skip(scene.Heights.Count - 60).ToArray();
            TestContext.Out.WriteLine($"{(last.Average() - Draft(shape, size.y, ratio, scene.Level)) / size.y:0.000} of its height " +
                $"over Archimedes' draft, restless by {(last.Max() - last.Min()) / size.y:0.000}; water {scene.Level:0.000} m");
            bool onGrains = ratio * size.y < FloatingScene.Spacing;        // which it rides where it is less than one particle deep
            Assert.That(last.Average(), Is.EqualTo(Draft(shape, size.y, ratio, scene.Level)).Within(onGrains ? 1.5f * FloatingScene.Spacing
            : 0.12f * size.y));
            float rest = onGrains ? 0.4f : 0.15f;
            Assert.That(last.Max() - last.Min(), Is.LessThan(rest * size.y), "it is at rest");
            if (shape == ColliderShape.Box)
                Assert.That(Vector3.Angle(scene.Body.rotation * Vector3.up, Vector3.up), Is.LessThan(10f));
            Assert.That(scene.Heights.Max(), Is.LessThan(0.6f + 0.6f * size.y), "nor did the water throw it up");
            AssertBounded();
        }

        [UnityTest]
        public IEnumerator A_body_nearly_as_heavy_as_deep_water_floats_in_it()
        {
            scene = new FloatingScene(ColliderShape.Sphere, Size(ColliderShape.Sphere), 0.9f, 0.85f, 16);
            yield return scene.Play(4f);
            float[] last = scene.Heights.Skip(scene.Heights.Count - 60).ToArray();
            TestContext.Out.WriteLine($"{(last.Average() - Draft(ColliderShape.Sphere, BallSize, 0.9f, scene.Level)) / BallSize:0.000} " +
                $"of its height over Archimedes' draft, restless by {(last.Max() - last.Min()) / BallSize:0.000}");
            Assert.That(last.Average(), Is.EqualTo(Draft(ColliderShape.Sphere, BallSize, 0.9f, scene.Level)).Within(0.15f * BallSize));
            AssertBounded();
        }

        [UnityTest]
        public IEnumerator A_heavy_body_sinks_at_a_bounded_speed([Values(2f, 10f)] float ratio)
        {
            scene = new FloatingScene(ColliderShape.Sphere, Size(ColliderShape.Sphere), ratio, 1f);
            yield return scene.Play(1.5f);
            Assert.That(scene.Heights.Last(), Is.EqualTo(0.5f * BallSize).Within(0.05f));
            Assert.That(scene.Speeds.Max(), Is.LessThan(1.05f * Mathf.Sqrt(2f * FloatingScene.Gravity * 0.8f)), "a fall without water");
            AssertBounded();
        }

        [UnityTest]
        public IEnumerator A_light_body_let_go_at_the_floor_comes_up_and_does_not_fly_off([Values(DeepWater.Off, DeepWater.On)] DeepWater deepWater)
        {
            scene = new FloatingScene(ColliderShape.Sphere, Size(ColliderShape.Sphere), 0.1f, 0.25f, deepWater: deepWater);
            scene.Body.isKinematic = true;
            yield return scene.Play(0.5f);
            Assert.That(scene.Body.position.y, Is.EqualTo(0.25f), "a kinematic body stays where it is");
            scene.Body.isKinematic = false;
            yield return scene.Play(2f);
            Assert.That(scene.Heights.Max(), Is.GreaterThan(0.6f).And.LessThan(0.6f + BallSize));
            Assert.That(scene.Speeds.Max(), Is.LessThan(1.5f));
            Assert.That(Sideways, Is.LessThan(0.5f * BallSize));
            AssertBounded();
        }

        [UnityTest]
        public IEnumerator What_cannot_float_is_said_once()
        {
            LogAssert.Expect(LogType.Error, new Regex("FluidBuoyancy 'Body' carries nothing: its FluidCollider is a plane"));
            scene = new FloatingScene(ColliderShape.Plane, Vector3.one, 1f, 1f, 2, 8);
            yield return scene.Play(0.2f);
            LogAssert.NoUnexpectedReceived();
            scene.Buoyancy.enabled = false;
            LogAssert.Expect(LogType.Warning, new Regex("FluidBuoyancy 'Body': virtual mass NaN"));
            scene.Buoyancy.VirtualMass = float.NaN;
            Assert.That(scene.Buoyancy.VirtualMass, Is.EqualTo(FloatingResponse.DefaultVirtualMass));
        }

        [UnityTest]
        public IEnumerator A_body_that_no_fluid_reaches_falls_freely_and_says_so_once()
        {
            LogAssert.Expect(LogType.Warning, new Regex("FluidBuoyancy 'Body' has met no FluidSimulation in 5 s: none that runs has it in " +
                "its box and the layer of its FluidCollider in Fluid Collider Layers. Place it there, add the layer, or enable"));
            scene = new FloatingScene(ColliderShape.Sphere, Size(ColliderShape.Sphere), 1f, 400f, 2, 8);
            scene.Fluid.enabled = false;
            yield return scene.Play(6f);
            Assert.That(scene.Speeds.Last(), Is.EqualTo(FloatingScene.Gravity * 6f).Within(0.5f));
            yield return scene.Play(6f);
            LogAssert.NoUnexpectedReceived();
        }

        [UnityTest]
        public IEnumerator A_body_on_a_layer_that_the_fluid_does_not_take_falls_through_it()
        {
            scene = new FloatingScene(ColliderShape.Sphere, Size(ColliderShape.Sphere), 0.5f, 0.5f);
            scene.Body.gameObject.layer = Layer;
            yield return scene.Play(1.5f);
            Assert.That(scene.Heights.Last(), Is.GreaterThan(0.4f), "it floats");
            Assert.That(scene.Buoyancy.SubmergedFraction, Is.GreaterThan(0.2f));
            scene.Fluid.FluidColliderLayers = ~(1 << Layer);
            yield return scene.Play(1f);
            Assert.That(scene.Heights.Last(), Is.EqualTo(0.5f * BallSize).Within(0.01f), "on the floor");
            Assert.That(scene.Buoyancy.SubmergedFraction, Is.Zero);
            scene.Fluid.FluidColliderLayers = 1 << Layer;
            yield return scene.Play(1.5f);
            Assert.That(scene.Heights.Last(), Is.GreaterThan(0.4f), "it comes up again");
            AssertBounded();
        }

        void AssertBounded()
        {
            Assert.That(scene.PeakAcceleration, Is.LessThan(scene.Buoyancy.MaxAcceleration + FloatingScene.Gravity + 1f));
            Assert.That(Sideways, Is.LessThan(0.15f), "m: nothing pushes it aside");
        }

        float Sideways => new Vector2(scene.Body.position.x, scene.Body.position.z).magnitude;

        static Vector3 Size(ColliderShape shape) => shape == ColliderShape.Box ? BoxSize : Vector3.one * BallSize;

        // Height of the center of a body that floats as Archimedes has it: a prism, or a ball whose cap of height x (of its diameter) has
        // the fraction 3x² - 2x³.
        static float Draft(ColliderShape shape, float height, float ratio, float level)
        {
            float depth = ratio;
            if (shape == ColliderShape.Sphere)
                for (int i = 0; i < 50; i++)
                    depth -= (depth * depth * (3f - 2f * depth) - ratio) / Mathf.Max(6f * depth * (1f - depth), 0.3f);
            return level + (0.5f - depth) * height;
        }
    }
}
