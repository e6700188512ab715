using System.Linq;
using Host.Pipelines;
using NUnit.Framework;
using Rill;
using Rill.Tests;
using Unity.Mathematics;
using UnityEngine;

namespace Host.Tests
{
    /// <summary>The mesh of the water looks in each render pipeline as in the Built-in one, from above and from within.</summary>
    public class WaterPipelineTests : PipelineSurfaceFixture
    {
        ShapeMesh mesh;

        [SetUp]
        public void MakeMesh()
        {
            // A drop above a pool.
            mesh = new ShapeMesh(Vector3.one * 16f, p => math.max(ShapeMesh.Ball(p, new float3(8f, 11f, 8f), 3f), 5f - p.y));
        }

        [TearDown]
        public void ReleaseMesh()
        {
            mesh?.Dispose();
            mesh = null;
        }

        void Arrange(bool refraction, bool inside)
        {
            FluidSurface surface = simulation.GetComponent<FluidSurface>();
            surface.Refraction = refraction;
            surface.CastShadows = UnityEngine.Rendering.ShadowCastingMode.Off;
            surface.Mesh = mesh.Frame(Matrix4x4.Scale(Vector3.one * 0.1f) * Matrix4x4.Translate(Vector3.one * -8f), 0.1f);
            GameObject post = GameObject.CreatePrimitive(PrimitiveType.Cube);
            post.transform.position = new Vector3(0.3f, 0f, 0.6f);
            post.transform.localScale = new Vector3(0.3f, 2f, 0.3f);
            post.GetComponent<MeshRenderer>().sharedMaterial = RenderPassFixture.MaterialOf("Solid.shader", UnityEngine.Headless.Player.PipelineTag);
            if (!inside)
                return;
            camera.nearClipPlane = 0.02f;
            camera.transform.position = new Vector3(0f, -0.5f, -0.6f);
            camera.transform.LookAt(new Vector3(0f, -0.2f, 0f));
        }

        static readonly string[] Pipelines = { "Universal 14", "Universal 17", "Universal 17 by Execute", "HighDefinition 14", "HighDefinition 17" };

        [Test]
        public void It_looks_as_in_the_Built_in_pipeline([ValueSource(nameof(Pipelines))] string name, [Values] bool refraction)
            => Compare(name, refraction, false);

        [Test]
        public void From_within_it_looks_as_in_the_Built_in_pipeline([Values("Universal 17", "HighDefinition 17")] string name)
            => Compare(name, true, true);

        // Above all else the floor under the pool, which has to be brighter in some places and darker in others.
        [Test]
        public void The_sun_lights_what_stands_in_it_as_in_the_Built_in_pipeline([Values("Universal 17", "HighDefinition 17")] string name)
            => Compare(name, true, false, true);

        // intensity: that of which a white surface shows 1; in HDRP it is in lux. Ambient light is HDRP's sky there, which is black here.
        void LetTheSunIn(float intensity)
        {
            RenderSettings.ambientSkyColor = Color.black;
            Light sun = UnityEngine.Object.FindObjectOfType<Light>();
            sun.intensity = intensity;
            simulation.GetComponent<FluidSurface>().Sun = sun;
        }

        void Compare(string name, bool refraction, bool inside, bool sun = false)
        {
            Vector4[] dry = sun ? InTheBuiltInPipeline(3, () => Arrange(refraction, inside)) : null;
            Vector4[] builtIn = InTheBuiltInPipeline(3, () =>
            {
                Arrange(refraction, inside);
                if (sun)
                    LetTheSunIn(1f);
            });
            if (sun)
            {
                int changed = dry.Where((pixel, i) => (pixel - builtIn[i]).magnitude > 0.02f).Count();
                TestContext.Out.WriteLine($"{changed} pixels are lit otherwise");
                Assert.That(changed, Is.GreaterThan(Width * Height / 50));
            }
            int space = name.IndexOf(' ');
            Build(name.StartsWith("Universal") ? PipelineKind.Universal : PipelineKind.HighDefinition, name.Substring(space + 1));
            Arrange(refraction, inside);
            if (sun)
                LetTheSunIn(name.StartsWith("High") ? math.PI : 1f);
            Play(3);
            Vector4[] drawn = Pixels();
            Assert.That(Errors, Is.Empty);
            if (sun)
            {
                // The sun brightens what the pipelines' copies of the scene differ by, so it is the light that counts. HDRP's ambient light is
                // another.
                float unlike = drawn.Zip(builtIn, (a, b) => (a - b).magnitude).Sum() / dry.Zip(builtIn, (a, b) => (a - b).magnitude).Sum();
                TestContext.Out.WriteLine($"{unlike:0.000} of what the sun changes");
                Assert.That(unlike, Is.LessThan(name.StartsWith("Universal") ? 0.1f : 0.2f));
            }
            int others = drawn.Where((pixel, i) => (pixel - builtIn[i]).magnitude > 0.02f).Count();
            TestContext.Out.WriteLine($"{others} pixels of {Width * Height}");
            simulation.GetComponent<FluidSurface>().Mesh = null;
            // URP's copy of the scene has half the size.
            Assert.That(others, Is.LessThan(Width * Height / (sun || name.StartsWith("Universal") ? 50 : 200)));
            Assert.That(Covered(drawn), Is.GreaterThan(Width * Height / 20), "it is there");
        }
    }
}
