using Host;
using Host.Fluids;
using NUnit.Framework;
using Unity.Mathematics;

namespace Host.Tests
{
    /// <summary>The scenes that figures are measured on.</summary>
    public class ExperimentTests
    {
        [TestCase("dam:100000", 100_000, 0.02f)]
        [TestCase("dam:1000000", 1_000_000, 0.01f)]
        [TestCase("column:120:0.05", 24 * 120 * 24, 0.05f)]
        [TestCase("drop:4", 540_672, 0.0125f)]
        [TestCase("drop:0.5", 24 * 4 * 24 + 8 * 12 * 8, 0.1f)]
        [TestCase("tank:8", 112 * 8 * 112, 0.02f)]
        [TestCase("tank:6:20:0.05", 20 * 6 * 20, 0.05f)]
        public void A_scene_has_the_particles_that_its_name_says(string text, int particles, float spacing)
        {
            ExperimentScene scene = ExperimentScene.Parse(text);
            Assert.That(scene.Particles, Is.EqualTo(particles));
            Assert.That(scene.Spacing, Is.EqualTo(spacing));
            foreach ((float3 corner, int3 counts, float3 _) in scene.Blocks)
                Assert.That(math.all(corner + counts <= scene.Box), "a block reaches out of the box");
        }

        [TestCase("pond")]
        [TestCase("dam:0")]
        [TestCase("dam:many")]
        [TestCase("dam:20000000")]
        [TestCase("column:10:0.05:3")]
        [TestCase("tank:-1")]
        [TestCase("drop:0.3")]
        public void Another_text_is_refused_with_what_would_do(string text)
        {
            var error = Assert.Throws<HostException>(() => ExperimentScene.Parse(text));
            Assert.That(error.Message, Does.Contain($"\"{text}\"").And.Contain("dam:<particles>"));
        }
    }
}
