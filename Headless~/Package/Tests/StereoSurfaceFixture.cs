using System;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Host.Pipelines;
using NUnit.Framework;
using Rill;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace Host.Tests
{
    /// <summary>Water that a pipeline's stand-in draws for two eyes in one pass, held against a camera with one eye at each.</summary>
    public abstract class StereoSurfaceFixture : PipelineSurfaceFixture
    {
        private protected const string Refracting = "refracting", Blended = "blended", Milky = "milky", Foamy = "foamy", Sunlit = "sunlit";
        private protected const int Few = 4;

        static readonly string shaders = Path.Combine(PackageFolder.Path, "Shaders", "Rendering");

        [SetUp]
        public void PutOnHeadset()
        {
            Player.ScreenWidth = 2 * Width;
            Player.ScreenHeight = Height;
            Player.Stereo = true;
        }

        [TearDown]
        public void PutDownHeadset() => Player.Stereo = StereoView.IsMultiPass = false;

        /// <summary>XR's Multi Pass.</summary>
        private protected static void DrawEyesOneAfterTheOther() => StereoView.IsMultiPass = true;

        private protected FluidSurface Surface => simulation.GetComponent<FluidSurface>();

        /// <summary>A frame in which the water stands still, near enough for the eyes to see different pictures.</summary>
        private protected void Arrange(string look)
        {
            camera.targetTexture = null;
            camera.transform.position = new Vector3(0.1f, 0.2f, -1.6f);
            camera.transform.LookAt(new Vector3(0, -0.1f, 0));
            camera.fieldOfView = 60;
            GameObject post = GameObject.CreatePrimitive(PrimitiveType.Cube);
            post.transform.position = new Vector3(0.05f, 0, 0.2f);
            post.transform.localScale = new Vector3(0.15f, 2, 0.15f);
            post.GetComponent<MeshRenderer>().sharedMaterial = RenderPassFixture.MaterialOf("Solid.shader", Player.PipelineTag);
            UnityEngine.Object.FindObjectOfType<Light>().intensity = Player.PipelineTag == PipelineKind.HighDefinition.Tag ? Mathf.PI : 1;
            Surface.Refraction = look != Blended;
            if (look == Milky)
                Surface.Preset = SurfacePreset.Milk;
            if (look == Foamy)
                AddFoam();
            if (look == Sunlit)
                Surface.Sun = UnityEngine.Object.FindObjectOfType<Light>();
            Play(3);
            simulation.Paused = true;
            if (look == Foamy)
                PlantFoam();
            Play(2);
            Assert.That(Surface.CausticMap != null, Is.EqualTo(look == Sunlit));
        }

        void AddFoam()
        {
            simulation.gameObject.SetActive(false);
            FluidFoam foam = simulation.gameObject.AddComponent<FluidFoam>();
            foam.Radius = 0.05f;
            FoamSettings settings = foam.Settings;
            settings.amount = 0;
            foam.Settings = settings;
            simulation.gameObject.SetActive(true);
        }

        // Spray in front of the water.
        void PlantFoam()
        {
            const int count = 24;
            Foam stage = simulation.Solver.Foam;
            stage.Particles.SetData(Enumerable.Range(0, count).Select(i => new FoamParticle
            {
                a = new uint4(math.asuint((new float3(-0.5f + 0.2f * (i % 6), -0.2f + 0.15f * (i / 6), -0.6f) + 0.8f) / 0.1f),
                    math.asuint(20f)), b = new uint4(0u, 0u, 0u, 1u | 6400u << 2 | 255u << 16),
            }).ToArray(), 0, 0, count);
            stage.Counters.SetData(new[] { (uint)count, 0u, 0u, 0u, 0u, 0u, 0u, 0u });
            const uint vertices = count * GpuBuffer.VerticesPerParticle;
            // as Arguments.hlsl writes them
            stage.Arguments.SetData(new[] { vertices, 1u, 0u, 0u, 1u, 1u, 1u, (uint)count, vertices, 2u, 0u, 0u });
        }

        /// <summary>Pixels of the eyes that a camera there sees otherwise, and of the left one that the right one sees otherwise.</summary>
        /// <param name="between">Before the cameras with one eye draw.</param>
        private protected (int left, int right, int between) Compare(Action between = null)
        {
            Color32[][] eyes = { Read(StereoView.Eyes, 0), Read(StereoView.Eyes, 1) };
            var unlike = new int[2];
            (Matrix4x4[] views, Matrix4x4[] projections) = ((Matrix4x4[])StereoView.Views.Clone(), (Matrix4x4[])StereoView.Projections.Clone());
            between?.Invoke();
            for (int eye = 0; eye < 2; eye++)
                unlike[eye] = Unlike(eyes[eye], DrawAlone(views[eye], projections[eye]));
            TestContext.Out.WriteLine($"pixels unlike: left {unlike[0]}, right {unlike[1]}, between the eyes {Unlike(eyes[0], eyes[1])}");
            return (unlike[0], unlike[1], Unlike(eyes[0], eyes[1]));
        }

        private protected void AssertEachEyeSeesWhatACameraThereSees()
        {
            (int left, int right, int between) = Compare();
            Assert.That(Errors, Is.Empty);
            Assert.That(between, Is.GreaterThan(Width * Height / 20), "two eyes see two pictures");
            Assert.That(left, Is.LessThanOrEqualTo(Few), "left");
            Assert.That(right, Is.LessThanOrEqualTo(Few), "right");
        }

        private protected void AssertTheFaultIsSeen()
        {
            (int left, int right, _) = Compare();
            Assert.That(Math.Max(left, right), Is.GreaterThan(8 * Few));
        }

        /// <summary>The water's own shader with another line in Water.hlsl, or in SceneColor.hlsl.</summary>
        private protected void ShadeWithFault(string line, string instead)
        {
            string source = File.ReadAllText(Path.Combine(shaders, "Water.hlsl"))
                .Replace("#include \"SceneColor.hlsl\"", File.ReadAllText(Path.Combine(shaders, "SceneColor.hlsl")));
            Assert.That(source, Does.Contain(line));
            // Not for the camera with one eye, which is right.
            string faulty = "#ifdef RILL_STEREO\n" + source.Replace(line, instead) + "\n#else\n" + source + "\n#endif";
            string both = "#include \"View.hlsl\"\n" + faulty;
            ((Material)Get(Surface, "ShaderMaterial")).shader = RenderPassFixture.MaterialOf("Water.shader", Player.PipelineTag,
                text => Regex.Replace(text, "#include \"Water.hlsl\"", _ => both)).shader;
        }

        Color32[] DrawAlone(Matrix4x4 view, Matrix4x4 projection)
        {
            camera.targetTexture = new RenderTexture(Width, Height, StereoView.Eyes.graphicsFormat, StereoView.Eyes.depthStencilFormat);
            camera.transform.position = view.inverse.MultiplyPoint3x4(Vector3.zero);
            camera.worldToCameraMatrix = view;
            camera.projectionMatrix = projection;
            Play(2);
            Color32[] seen = Read(camera.targetTexture, 0);
            camera.targetTexture.Release();
            camera.targetTexture = null;
            return seen;
        }

        private protected int PixelsOfWaterOnTheScreen()
        {
            Color32[] with = Read(ScreenTarget.Texture, 0);
            simulation.gameObject.SetActive(false);
            Play(1);
            return Unlike(with, Read(ScreenTarget.Texture, 0));
        }

        static Color32[] Read(RenderTexture texture, int slice)
        {
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(texture, 0, 0, Width, 0, Height, slice, 1);
            request.WaitForCompletion();
            return request.GetData<Color32>().ToArray();
        }

        static int Unlike(Color32[] a, Color32[] b)
            => a.Zip(b, (x, y) => Math.Abs(x.r - y.r) > 2 || Math.Abs(x.g - y.g) > 2 || Math.Abs(x.b - y.b) > 2).Count(unlike => unlike);
    }
}
