using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using Host.Assets;
using Host.Pipelines;
using NUnit.Framework;
using Rill;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>A block of water over a floor, drawn by a pipeline's stand-in with the package's adapter or by the Built-in pipeline.</summary>
    public abstract class PipelineSurfaceFixture : UniversalFixture
    {
        ProjectAssets assets;
        IAssetSource assetsBefore;
        private protected FluidSimulation simulation;

        [SetUp]
        public void KeepAssets()
        {
            assetsBefore = Player.Assets;
        }

        [TearDown]
        public void EndScene()
        {
            UnityEngine.SceneManagement.SceneManager.UnloadEverything();
            assets?.ReloadAll();
            assets = null;
            Player.Assets = assetsBefore;
        }

        /// <param name="name">Pipeline and its version, as "Universal 17".</param>
        private protected void Build(string name)
        {
            int space = name.IndexOf(' ');
            Build(name.StartsWith("Universal") ? PipelineKind.Universal : PipelineKind.HighDefinition, name.Substring(space + 1));
        }

        // Shaders are imported for the pipeline that runs: by a project of its own.
        private protected void Build(PipelineKind kind, string version, bool editor = false, string adapterRoot = null)
        {
            if (kind != null)
            {
                bool byExecute = version.EndsWith(" by Execute", StringComparison.Ordinal);
                pipeline = PlayedPipeline.Start(kind, PipelineVersion.Find(version.Split(' ')[0]), adapterRoot ?? Session.Root(), byExecute, editor);
                string name = kind.Folder;
                Assembly adapter = pipeline["Rill." + name];
                adapter.GetType($"Rill.{name}.{name}Surfaces").GetMethod("Listen", BindingFlags.Static | BindingFlags.NonPublic).Invoke(null, null);
            }
            assets = new ProjectAssets(ProjectFolders.Of(Session.Root()), new[] { typeof(FluidSimulation).Assembly }, strict: true);
            Player.Assets = assets;

            RenderSettings.ambientMode = UnityEngine.Rendering.AmbientMode.Flat;
            RenderSettings.ambientSkyColor = new Color(0.3f, 0.3f, 0.3f);
            var sun = new GameObject("Sun").AddComponent<Light>();
            sun.type = LightType.Directional;
            sun.transform.rotation = Quaternion.LookRotation(new Vector3(-0.3f, -0.9f, 0.3f));     // as the floor is lit in HDRP
            GameObject floor = GameObject.CreatePrimitive(PrimitiveType.Plane);
            floor.transform.position = new Vector3(0, -0.8f, 0);
            floor.GetComponent<MeshRenderer>().sharedMaterial = RenderPassFixture.MaterialOf("Solid.shader", Player.PipelineTag);
            camera.transform.position = new Vector3(0, 1, -4);
            camera.transform.LookAt(new Vector3(0, -0.3f, 0));

            var fluid = new GameObject("Fluid");
            fluid.SetActive(false);
            simulation = fluid.AddComponent<FluidSimulation>();
            simulation.Configure(new Vector3(1.6f, 1.6f, 1.6f), 0.1f, 600);
            simulation.StatisticsInterval = 0;
            fluid.AddComponent<FluidVolume>().Size = new Vector3(0.8f, 0.8f, 0.8f);
            fluid.AddComponent<FluidSurface>();
            fluid.SetActive(true);
        }

        /// <summary>All that is on the GPU and in native memory, and the objects of the scene, hidden ones too.</summary>
        private protected static List<string> Alive()
            => LiveObjects.Report().Concat(Resources.FindObjectsOfTypeAll<GameObject>().Select(o => $"object '{o.name}'"))
                .OrderBy(line => line, StringComparer.Ordinal).ToList();

        /// <summary>Builds with a fault in the adapter: what the tests would see.</summary>
        private protected void BuildWithFault(PipelineKind kind, string version, string file, string line, string instead)
        {
            string root = Path.Combine(Path.GetTempPath(), "rill-adapter-" + Guid.NewGuid().ToString("N")),
                adapter = Path.GetDirectoryName(Check.Api.PipelineAdapters.FileOf(kind)), folder = Path.Combine(root, adapter);
            Directory.CreateDirectory(folder);
            try
            {
                foreach (string source in Directory.GetFiles(Path.Combine(Session.Root(), adapter)).Where(source => !source.EndsWith(".meta")))
                {
                    string text = File.ReadAllText(source);
                    if (Path.GetFileName(source) == file)
                    {
                        Assert.That(text, Does.Contain(line));
                        text = text.Replace(line, instead);
                    }
                    File.WriteAllText(Path.Combine(folder, Path.GetFileName(source)), text);
                }
                Build(kind, version, adapterRoot: root);
            }
            finally
            {
                Directory.Delete(root, true);
            }
        }

        /// <summary>Returns what the Built-in pipeline draws after some frames; then everything is as before.</summary>
        private protected Vector4[] InTheBuiltInPipeline(int frames, Action arrange = null)
        {
            Build(null, null);
            arrange?.Invoke();
            Play(frames);
            Vector4[] picture = Pixels();
            EndScene();
            PlayerLoop.Reset();
            target.Release();
            MakeCamera();
            return picture;
        }

        private protected static void Play(int frames)
        {
            for (int i = 0; i < frames; i++)
                PlayerLoop.Frame(1f / 60);
        }

        /// <summary>Counts the pixels in which the water changes the picture.</summary>
        private protected int Covered(Vector4[] with)
        {
            simulation.gameObject.SetActive(false);
            Play(1);
            Vector4[] without = Pixels();
            return with.Where((pixel, i) => (pixel - without[i]).magnitude > 0.02f).Count();
        }
    }
}
