using System.Linq;
using NUnit.Framework;
using Rill;
using UnityEngine;

namespace Host.Tests
{
    /// <summary>A floor that a block of water has fallen on stays wet, in each render pipeline as in the Built-in one; and what is off costs
    /// nothing.</summary>
    public class WetnessPipelineTests : PipelineSurfaceFixture
    {
        static readonly string[] Pipelines = { "Universal 14", "Universal 17", "Universal 17 by Execute", "HighDefinition 14", "HighDefinition 17" };

        FluidWetness Wetness => simulation.GetComponent<FluidWetness>();

        // Without water in the end: what there is to see is what it has left. Or with it, and more of it to the side.
        void Flood(bool leaves)
        {
            simulation.gameObject.AddComponent<FluidWetness>().Darkening = 0.5f;
            Play(40);
            if (leaves)
                simulation.Clear();
            else
                simulation.RemoveInside(FluidShape.Box(new Vector3(0.4f, -0.4f, 0f), new Vector3(0.8f, 0.8f, 1.6f)));
            Play(2);
            simulation.Paused = true;
            Play(2);
        }

        [Test]
        public void The_floor_is_wet_as_in_the_Built_in_pipeline([ValueSource(nameof(Pipelines))] string name, [Values] bool leaves)
        {
            Vector4[] dry = InTheBuiltInPipeline(2, () =>
            {
                Flood(leaves);
                Wetness.enabled = false;
            });
            Vector4[] builtIn = InTheBuiltInPipeline(0, () => Flood(leaves));
            Build(name);
            Flood(leaves);
            Vector4[] drawn = Pixels();
            Assert.That(Errors, Is.Empty);
            int darker = builtIn.Where((pixel, i) => pixel.y < 0.8f * dry[i].y).Count();
            int others = drawn.Where((pixel, i) => (pixel - builtIn[i]).magnitude > 0.02f).Count();
            TestContext.Out.WriteLine($"{darker} pixels are darker, {others} of {Width * Height} are unlike");
            Assert.That(darker, Is.GreaterThan(Width * Height / 25));
            // URP's copy of the scene, which the water shows, has half the size.
            Assert.That(others, Is.LessThan(leaves ? Width * Height / 500 : Width * Height / 50));
        }

        [Test]
        public void Off_it_costs_what_none_costs([Values(null, "Universal 14", "Universal 17", "HighDefinition 17")] string name)
        {
            if (name == null)
                Build(null, null);
            else
                Build(name);
            Object.DestroyImmediate(simulation.GetComponent<FluidSurface>());
            Play(3);
            Footprint without = Footprint.Of(() => Play(1));
            DepthTextureMode depth = camera.depthTextureMode;
            var wetness = simulation.gameObject.AddComponent<FluidWetness>();
            Play(3);
            Footprint on = Footprint.Of(() => Play(1));
            Assert.That(new[] { "Wetness.compute MarkWet", "Wetness.shader" }, Is.SubsetOf(on.Work));
            Assert.That(on.Work.Count(entry => entry.StartsWith("Wetness")), Is.EqualTo(2));
            simulation.Paused = true;
            Play(2);
            Assert.That(Footprint.Of(() => Play(1)).Work.Where(entry => entry == "Wetness.compute MarkWet"), Is.Empty, "paused");
            simulation.Paused = false;
            wetness.enabled = false;
            Play(5);
            Assert.That(Footprint.Of(() => Play(1)).Since(without), Is.Empty);
            Assert.That(camera.depthTextureMode, Is.EqualTo(depth));
        }
    }
}
