using System.Linq;
using Host.Assets;
using Host.Pipelines;
using NUnit.Framework;
using Rill;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace Host.Tests
{
    /// <summary>The mesh of a block of water under a lid and over a floor is drawn, throws a shadow and receives one as a cube of its size is,
    /// with the same lit material, in each render pipeline and with no adapter of the package.</summary>
    public class RenderedMeshPipelineTests : UniversalFixture
    {
        const float Side = 0.8f;

        ProjectAssets assets;
        IAssetSource assetsBefore;
        FluidSimulation simulation;
        MeshRenderer water, cube, lid;

        [SetUp]
        public void KeepAssets() => assetsBefore = Player.Assets;

        [TearDown]
        public void EndScene()
        {
            if (simulation != null)
                Object.DestroyImmediate(simulation.gameObject);
            Play(1);        // what was destroyed goes with the frame
            UnityEngine.SceneManagement.SceneManager.UnloadEverything();
            assets?.ReloadAll();
            assets = null;
            Player.Assets = assetsBefore;
        }

        static readonly string[] Pipelines = { "Built-in", "Universal 14", "Universal 17", "HighDefinition 14", "HighDefinition 17" };

        // In the Built-in pipeline Unity's own lit shader; the stand-ins have none, and get the package's for solids, which knows nothing of water.
        Material Lit(Color color)
        {
            Material lit = pipeline == null ? new Material(Shader.Find("Standard"))
                : RenderPassFixture.MaterialOf("Solid.shader", Player.PipelineTag);
            lit.SetColor("_Color", color);
            return lit;
        }

        void Build(string name)
        {
            if (name != "Built-in")
                pipeline = PlayedPipeline.Start(name.StartsWith("Universal") ? PipelineKind.Universal : PipelineKind.HighDefinition,
                    PipelineVersion.Find(name.Substring(name.IndexOf(' ') + 1)), null);
            assets = new ProjectAssets(ProjectFolders.Of(Session.Root()), new[] { typeof(FluidSimulation).Assembly }, strict: true);
            Player.Assets = assets;
            RenderSettings.ambientMode = AmbientMode.Flat;
            RenderSettings.ambientSkyColor = new Color(0.3f, 0.3f, 0.3f);
            var sun = new GameObject("Sun").AddComponent<Light>();
            sun.type = LightType.Directional;
            sun.transform.rotation = Quaternion.LookRotation(new Vector3(-0.15f, -0.95f, 0.2f));
            sun.shadows = LightShadows.Hard;
            camera.transform.position = new Vector3(0.4f, 1.2f, -2.2f);
            camera.transform.LookAt(new Vector3(0, -0.2f, 0));
            Add(PrimitiveType.Plane, new Vector3(0, -0.9f, 0), Vector3.one, Lit(Color.white));
            lid = Add(PrimitiveType.Cube, new Vector3(0.1f, 0.9f, -0.1f), new Vector3(0.3f, 0.02f, 0.3f), Lit(Color.white));
            Material blue = Lit(new Color(0.2f, 0.4f, 0.9f));
            cube = Add(PrimitiveType.Cube, Vector3.zero, Vector3.one * Side, blue);

            var fluid = new GameObject("Fluid");
            fluid.SetActive(false);
            simulation = fluid.AddComponent<FluidSimulation>();
            simulation.Configure(new Vector3(1.6f, 1.6f, 1.6f), 0.05f, 4500);
            simulation.StatisticsInterval = 0;
            simulation.Gravity = Vector3.zero;
            fluid.AddComponent<FluidVolume>().Size = Vector3.one * Side;
            fluid.AddComponent<FluidSurfaceMesh>();
            water = fluid.GetComponent<MeshRenderer>();
            water.sharedMaterial = blue;
            fluid.SetActive(true);
        }

        static MeshRenderer Add(PrimitiveType type, Vector3 position, Vector3 scale, Material material)
        {
            GameObject one = GameObject.CreatePrimitive(type);
            one.transform.position = position;
            one.transform.localScale = scale;
            var drawn = one.GetComponent<MeshRenderer>();
            drawn.sharedMaterial = material;
            return drawn;
        }

        static void Play(int frames)
        {
            for (int i = 0; i < frames; i++)
                PlayerLoop.Frame(1f / 60);
        }

        /// <summary>Returns the camera's picture of the water, or of the cube instead, or of neither.</summary>
        Vector4[] Picture(MeshRenderer shown)
        {
            (water.enabled, cube.enabled) = (shown == water, shown == cube);
            Play(2);
            return Pixels();
        }

        Vector4 At(Vector4[] picture, Vector3 world)
        {
            Vector3 at = camera.WorldToScreenPoint(world);
            return picture[(int)at.y * Width + (int)at.x];
        }

        [Test]
        public void It_looks_and_throws_and_receives_shadows_as_a_cube_does([ValueSource(nameof(Pipelines))] string name)
        {
            Build(name);
            Play(2);
            Vector4[] drawn = Picture(water), expected = Picture(cube), empty = Picture(null);
            int covered = drawn.Where((pixel, i) => (pixel - empty[i]).magnitude > 0.02f).Count();
            int others = drawn.Where((pixel, i) => (pixel - expected[i]).magnitude > 0.2f).Count();
            TestContext.Out.WriteLine($"{covered} of {Width * Height} pixels with water or its shadow, {others} unlike the cube's");
            Assert.That(covered, Is.GreaterThan(Width * Height / 12));
            Assert.That(others, Is.LessThan(covered / 4), "those at its edges, which are round");
            Vector3 top = new Vector3(-0.2f, 0.5f * Side, 0.1f), front = new Vector3(0, 0, -0.5f * Side);
            Assert.That((At(drawn, top) - At(expected, top)).magnitude, Is.LessThan(0.03f), "top");
            Assert.That((At(drawn, front) - At(expected, front)).magnitude, Is.LessThan(0.03f), "front");
            Assert.That(At(drawn, top).y, Is.GreaterThan(1.15f * At(drawn, front).y), "lit from above");
            Assert.That(Logged.Where(line => !line.StartsWith("Log") && !line.StartsWith("Warning")), Is.Empty);
            if (name.StartsWith("HighDefinition"))      // whose stand-in has no shadow maps
            {
                Assert.That(CastsInItsPass(), Is.GreaterThan(Width * Height / 30));
                return;
            }

            // On the floor beside it, and on its top.
            Vector3 below = new Vector3(-0.15f, -0.9f, -0.3f), shaded = new Vector3(0.02f, 0.5f * Side, 0f);
            Assert.That(At(drawn, below).y, Is.EqualTo(At(expected, below).y).Within(0.03f));
            Assert.That(At(drawn, shaded).y, Is.EqualTo(At(expected, shaded).y).Within(0.03f));
            water.shadowCastingMode = ShadowCastingMode.Off;
            lid.shadowCastingMode = ShadowCastingMode.Off;
            Vector4[] without = Picture(water);
            Assert.That(At(drawn, shaded).y, Is.LessThan(0.8f * At(without, shaded).y), "the lid's shadow falls on it");
            int inShadow = drawn.Where((pixel, i) => (without[i] - empty[i]).magnitude < 0.02f && pixel.y < 0.8f * without[i].y).Count();
            TestContext.Out.WriteLine($"{inShadow} pixels of the floor in its shadow");
            Assert.That(inShadow, Is.GreaterThan(Width * Height / 60), "its shadow falls on the floor");
        }

        // Pixels in which the material's pass for shadow maps leaves something of the mesh, seen from the camera.
        int CastsInItsPass()
        {
            Picture(water);
            BuiltinVariables.SetCamera(camera, Width, Height);
            int pass = water.sharedMaterial.FindPass("ShadowCaster");
            Assert.That(pass, Is.GreaterThanOrEqualTo(0));
            var depth = new RenderTexture(Width, Height, UnityEngine.Experimental.Rendering.GraphicsFormat.None,
                UnityEngine.Experimental.Rendering.GraphicsFormat.D32_SFloat);
            using (var cmd = new CommandBuffer())
            {
                cmd.SetRenderTarget(depth);
                cmd.ClearRenderTarget(true, false, Color.clear);
                cmd.DrawMesh(water.GetComponent<MeshFilter>().sharedMesh, water.transform.localToWorldMatrix, water.sharedMaterial, 0, pass);
                Graphics.ExecuteCommandBuffer(cmd);
            }
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(depth);
            request.WaitForCompletion();
            int count = request.GetData<float>().ToArray().Count(value => value > 0f);
            depth.Release();
            return count;
        }

        [Test]
        public void Off_it_costs_what_none_costs()
        {
            Build("Built-in");
            Object.DestroyImmediate(simulation.GetComponent<FluidSurfaceMesh>());
            Play(3);
            Footprint without = Footprint.Of(() => Play(1));
            var mesh = simulation.gameObject.AddComponent<FluidSurfaceMesh>();
            Play(3);
            Footprint on = Footprint.Of(() => Play(1));
            Assert.That(on.Work, Has.Member("RenderedMesh.compute CopyVertices").And.Member("RenderedMesh.compute CopyIndices")
                .And.Member("SurfaceMesh.compute FinishMesh"));
            Assert.That(on.Work.Where(entry => entry.StartsWith("Water") || entry.StartsWith("Surface.")), Is.Empty, "nor the water's own shaders");
            mesh.enabled = false;
            Play(40);       // the solver keeps its stage for a while
            Assert.That(Footprint.Of(() => Play(1)).Since(without), Is.Empty);
        }
    }
}
