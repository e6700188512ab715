using System.Linq;
using NUnit.Framework;
using Rill;
using UnityEngine;

namespace Host.Tests
{
    /// <summary>Smoke looks in each render pipeline as in the Built-in one: its draw needs no adapter.</summary>
    public class SmokePipelineTests : PipelineSurfaceFixture
    {
        void Smoke(bool isOn)
        {
            Object.DestroyImmediate(simulation.GetComponent<FluidSurface>());
            FluidSmoke smoke = simulation.gameObject.AddComponent<FluidSmoke>();
            smoke.Glow = 0f;
            smoke.Color = Color.white;
            smoke.Ambient = new Color(0.4f, 0.4f, 0.4f);
            smoke.Sun = Object.FindObjectsOfType<Light>().First(light => light.type == LightType.Directional);
            var source = new GameObject("Fire").AddComponent<FluidSmokeSource>();
            source.transform.parent = simulation.transform;
            source.transform.localPosition = Vector3.zero;
            source.Radius = 0.25f * Mathf.Min(simulation.DomainSize.x, simulation.DomainSize.y);
            source.Density = 10f;
            Play(8);
            simulation.Paused = true;
            smoke.enabled = isOn;
            Play(2);
        }

        [Test]
        public void Smoke_is_seen_as_in_the_Built_in_pipeline([Values("Universal 14", "HighDefinition 17")] string name)
        {
            Vector4[] without = InTheBuiltInPipeline(2, () => Smoke(false));
            Vector4[] builtIn = InTheBuiltInPipeline(0, () => Smoke(true));
            Build(name);
            Smoke(true);
            Vector4[] drawn = Pixels();
            Assert.That(Errors, Is.Empty);
            int seen = builtIn.Where((pixel, i) => (pixel - without[i]).magnitude > 0.05f).Count();
            int others = drawn.Where((pixel, i) => (pixel - builtIn[i]).magnitude > 0.03f).Count();
            TestContext.Out.WriteLine($"{seen} pixels have smoke, {others} of {Width * Height} are unlike");
            Assert.That(seen, Is.GreaterThan(Width * Height / 25));
            Assert.That(others, Is.LessThan(Width * Height / 100));
        }
    }
}
