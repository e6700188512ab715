using NUnit.Framework;
using UnityEngine;

namespace Rill.Editor.Tests
{
    /// <summary>The line that tells whether Deep Water is on, before anything plays.</summary>
    public class DeepWaterStateTests
    {
        EditorScene scene;
        FluidSimulation fluid;

        [SetUp]
        public void MakeScene()
        {
            scene = new EditorScene();
            fluid = scene.Add<FluidSimulation>("Pool");
            fluid.enabled = false;
            fluid.gameObject.SetActive(true);
            fluid.Configure(new Vector3(2f, 4f, 1f), 0.1f, 10000);
        }

        [TearDown]
        public void DestroyScene() => scene.Dispose();

        [TestCase(0.4f, "off: water 4 layers deep, at most 4")]
        [TestCase(0.5f, "on: water 5 layers deep, more than 4 (and stays above 3)")]
        [TestCase(9f, "on: water 40 layers deep, more than 4 (and stays above 3)", TestName = "no_deeper_than_its_box")]
        public void Automatic_goes_by_the_depth_of_the_volumes(float depth, string line)
        {
            Fill(depth);
            Assert.That(DeepWaterState.Describe(fluid), Is.EqualTo(line));
        }

        [Test]
        public void A_choice_is_told_with_the_depth()
        {
            Fill(2f);
            fluid.DeepWater = DeepWater.Off;
            Assert.That(DeepWaterState.Describe(fluid), Is.EqualTo("off: deep water is set to Off, water 20 layers deep"));
            fluid.DeepWater = DeepWater.On;
            Assert.That(DeepWaterState.Describe(fluid), Is.EqualTo("on: deep water is set to On, water 20 layers deep"));
        }

        [Test]
        public void An_emitter_counts_from_where_it_stands_down_to_the_floor()
        {
            Assert.That(DeepWaterState.Layers(fluid), Is.Zero, "empty");
            var emitter = new GameObject("Tap").AddComponent<FluidEmitter>();
            emitter.transform.SetParent(fluid.transform, false);
            emitter.transform.SetLocalPositionAndRotation(new Vector3(0f, 1f, 0f), Quaternion.Euler(90f, 0f, 0f));
            Assert.That(DeepWaterState.Layers(fluid), Is.EqualTo(31f).Within(0.01f), "with its radius");
            emitter.enabled = false;
            Assert.That(DeepWaterState.Layers(fluid), Is.Zero);
        }

        [Test]
        public void Depth_is_along_gravity_in_a_box_that_is_turned_and_none_without_gravity()
        {
            Fill(2f);
            fluid.transform.rotation = Quaternion.Euler(0f, 0f, 90f);
            Assert.That(DeepWaterState.Layers(fluid), Is.EqualTo(20f).Within(0.01f), "2 m wide");
            fluid.transform.rotation = Quaternion.Euler(90f, 0f, 0f);
            Assert.That(DeepWaterState.Layers(fluid), Is.EqualTo(10f).Within(0.01f), "1 m long");
            fluid.Gravity = Vector3.zero;
            Assert.That(DeepWaterState.Layers(fluid), Is.Zero);
        }

        // 14 layers stand with it off, and 24 do not: Research~/report.md, "Floating bodies".
        [TestCase(DeepWater.Off, 1.4f, false)]
        [TestCase(DeepWater.Off, 1.5f, true)]
        [TestCase(DeepWater.Automatic, 2.4f, false)]
        public void Bodies_in_water_of_more_than_14_layers_without_Deep_Water_get_a_warning(DeepWater mode, float depth, bool warns)
        {
            Fill(depth);
            fluid.DeepWater = mode;
            string problem = DeepWaterState.FloatingProblem(fluid);
            Assert.That(problem != null, Is.EqualTo(warns), problem);
            if (warns)
                Assert.That(problem, Does.Contain("'Pool'").And.Contain("15 layers").And.Contain("Above 14 layers").And.Contain("Automatic"));
            GameObject inIt = scene.Keep(new GameObject("Body")), faraway = scene.Keep(new GameObject("Other"));
            faraway.transform.position = new Vector3(50f, 0f, 0f);
            Assert.That(DeepWaterState.FloatingProblems(inIt), Is.EqualTo(warns ? new[] { problem } : new string[0]));
            Assert.That(DeepWaterState.FloatingProblems(faraway), Is.Empty);
        }

        void Fill(float depth)
        {
            var volume = new GameObject("Water").AddComponent<FluidVolume>();
            volume.transform.SetParent(fluid.transform, false);
            volume.transform.localPosition = new Vector3(0f, -2f + 0.5f * depth, 0f);
            volume.Size = new Vector3(2f, depth, 1f);
        }
    }
}
