using System.Collections;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Bodies of so little draft that single particles would carry them.</summary>
    [Category("LongRun")]
    public class LightBodyTests
    {
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

        [UnityTest]
        public IEnumerator A_light_body_gains_no_energy_and_floats_at_its_draft([Values(5f, 20f)] float density,
            [Values(DeepWater.Off, DeepWater.On)] DeepWater deepWater, [Values(ColliderShape.Box, ColliderShape.Sphere)] ColliderShape shape)
        {
            Vector3 size = shape == ColliderShape.Box ? new Vector3(0.5f, 0.3f, 0.5f) : 0.4f * Vector3.one;
            scene = new FloatingScene(shape, size, density / FloatingScene.Density, 0.6f + 0.5f * size.y, deepWater: deepWater, side: 22);
            yield return scene.Play(4f);
            int from = scene.Heights.Count - 60;
            float[] heights = scene.Heights.Skip(from).ToArray(), speeds = scene.Speeds.Skip(from).ToArray();
            float draft = scene.Level - (heights.Average() - 0.5f * size.y);
            TestContext.Out.WriteLine($"draft {draft:0.000} m for {Draft(shape, size.y, density):0.000}, at most {speeds.Max():0.000} m/s");
            Assert.That(speeds.Max(), Is.LessThan(0.1f));
            Assert.That(draft, Is.EqualTo(Draft(shape, size.y, density)).Within(0.4f * FloatingScene.Spacing));
            Assert.That(scene.Heights.Max(), Is.LessThan(0.7f + 0.5f * size.y), "nor was it thrown up, but for the waves of the start");
            if (shape == ColliderShape.Box)
                Assert.That(Vector3.Angle(scene.Body.rotation * Vector3.up, Vector3.up), Is.LessThan(3f));
        }

        [UnityTest]
        public IEnumerator A_light_body_that_is_let_go_under_water_comes_up_and_stays_on_it()
        {
            scene = new FloatingScene(ColliderShape.Box, new Vector3(0.4f, 0.3f, 0.4f), 0.005f, 0.3f, side: 22);
            scene.Body.isKinematic = true;
            yield return scene.Play(0.5f);
            scene.Body.isKinematic = false;
            yield return scene.Play(3f);
            Assert.That(scene.Heights.Max(), Is.LessThan(0.9f), "it does not jump out");
            Assert.That(scene.Heights.Last(), Is.EqualTo(scene.Level + 0.15f).Within(0.04f), "on the water with half of its height");
            Assert.That(scene.Speeds.Last(), Is.LessThan(0.1f));
        }

        [UnityTest]
        public IEnumerator A_light_body_floats_in_a_lighter_liquid_at_the_draft_that_it_has_there()
        {
            FluidMaterialAsset oil = FluidMaterialAsset.Create("Oil", 0.5f * FloatingScene.Density);
            var size = new Vector3(0.5f, 0.3f, 0.5f);
            scene = new FloatingScene(ColliderShape.Box, size, 0.1f, 0.6f + 0.5f * size.y, side: 22, liquid: oil);
            yield return scene.Play(4f);
            float draft = scene.Level - (scene.Heights.Skip(scene.Heights.Count - 60).Average() - 0.5f * size.y);
            TestContext.Out.WriteLine($"draft {draft:0.000} m for {0.2f * size.y:0.000}, {scene.Buoyancy.SubmergedFraction:0.00} under water");
            Assert.That(draft, Is.EqualTo(0.2f * size.y).Within(0.4f * FloatingScene.Spacing));
            Assert.That(scene.Buoyancy.SubmergedFraction, Is.EqualTo(0.2f).Within(0.06f));
            Object.Destroy(oil);
        }

        // Draft of a prism; for a ball whose cap of the depth x, as a fraction of its diameter, has the fraction 3x² - 2x³.
        static float Draft(ColliderShape shape, float height, float density)
        {
            float ratio = density / FloatingScene.Density, depth = shape == ColliderShape.Box ? ratio : Mathf.Sqrt(ratio / 3f);
            for (int i = 0; i < 20 && shape == ColliderShape.Sphere; i++)
                depth = Mathf.Sqrt(ratio / (3f - 2f * depth));
            return depth * height;
        }
    }
}
