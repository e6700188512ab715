using System.Linq;
using Host.Pipelines;
using NUnit.Framework;
using Rill;
using UnityEngine;

namespace Host.Tests
{
    /// <summary>A surface that is off costs what none costs: no dispatch, no draw and so no variant, no buffer, no texture.</summary>
    public class SurfaceOffTests : PipelineSurfaceFixture
    {
        [Test]
        public void Off_it_costs_what_none_costs([Values(null, "14", "17")] string version)
        {
            Build(version == null ? null : PipelineKind.Universal, version);
            Object.DestroyImmediate(simulation.GetComponent<FluidSurface>());
            Play(3);
            Footprint without = Footprint.Of(() => Play(1));

            var surface = simulation.gameObject.AddComponent<FluidSurface>();
            Play(3);
            Footprint on = Footprint.Of(() => Play(1));
            string[] work = { "Water.shader", "SurfaceParticles.compute ShapeElements", "SurfaceMesh.compute FindField" };
            Assert.That(work, Is.SubsetOf(on.Work));
            Assert.That(Textures(), Is.Not.Empty);

            surface.enabled = false;
            Play(40);       // textures and the solver's stage are kept for a while
            Assert.That(Footprint.Of(() => Play(1)).Since(without), Is.Empty);
            Assert.That(Textures(), Is.Empty);
        }

        static string[] Textures() => Resources.FindObjectsOfTypeAll<RenderTexture>().Where(texture => texture.name.StartsWith("Rill.")
            && texture.IsCreated()).Select(texture => texture.name).ToArray();
    }
}
