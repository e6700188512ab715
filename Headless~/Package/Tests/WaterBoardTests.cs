using System;
using System.IO;
using Host.Assets;
using NUnit.Framework;
using Rill.Tests;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>The water's shader draws water of a known shape before a checkerboard as a path tracer does, whose pictures are stored.</summary>
    public class WaterBoardTests : GraphicsFixture
    {
        const int Pixels = 256, Square = 2;       // each the mean of so many of the drawn picture along both axes

        IAssetSource assetsBefore;
        ProjectAssets assets;
        MeshScene scene;

        [SetUp]
        public void Make()
        {
            assetsBefore = Player.Assets;
            assets = new ProjectAssets(ProjectFolders.Of(Session.Root()), new[] { typeof(Rill.FluidSimulation).Assembly }, strict: true);
            Player.Assets = assets;
        }

        [TearDown]
        public void End()
        {
            scene?.Dispose();
            scene = null;
            UnityEngine.SceneManagement.SceneManager.UnloadEverything();
            assets.ReloadAll();
            Player.Assets = assetsBefore;
        }

        [TestCase("sphere", 0.9)]
        [TestCase("cylinder", 0.9)]
        [TestCase("sheet", 0.9)]
        [TestCase("empty", 0.97)]
        public void Water_before_a_board_looks_as_a_path_tracer_draws_it(string name, double least)
        {
            double[] drawn = Draw(name), stored = Stored(name);
            double likeness = Ssim.Mean(drawn, stored, Pixels, Pixels);
            TestContext.Out.WriteLine($"{name}: SSIM {likeness:0.000}");
            Assert.That(likeness, Is.GreaterThan(least));
        }

        [Test]
        public void The_board_is_upside_down_in_a_sphere()
        {
            double[] drawn = Draw("sphere");
            // The square right of and above the center is bright; its image is left of and below.
            double upright = drawn[(Pixels / 2 + 12) * Pixels + Pixels / 2 + 12], beside = drawn[(Pixels / 2 + 12) * Pixels + Pixels / 2 - 12];
            Assert.That(upright, Is.EqualTo(drawn[(Pixels / 2 - 12) * Pixels + Pixels / 2 - 12]).Within(0.05));
            Assert.That(Math.Abs(upright - beside), Is.GreaterThan(0.3));
        }

        double[] Draw(string name)
        {
            bool isSheet = name == "sheet";
            scene = new MeshScene(Pixels * Square, isSheet ? new Vector3(3.2f, 3.2f, 2.2f) : name == "cylinder" ? new Vector3(1.6f, 4f, 1.6f)
                : Vector3.one * 1.6f, 0.05f, 0.5f);
            scene.Camera.transform.position = new Vector3(0f, 0f, -4f);
            scene.Camera.fieldOfView = 40f;
            scene.AddBoard(new Vector3(0f, 0f, 3f), Vector3.right, Vector3.up, 0.5f, 24, 0.8f, 0.1f);
            quaternion turn = math.inverse(quaternion.Euler(0f, math.radians(30f), 0f));
            if (name == "sphere")
                scene.Put(p => 0.7f - math.length(p));
            else if (name == "cylinder")
                scene.Put(p => 0.5f - math.length(p.xz));
            else if (isSheet)
                scene.Put(p => ShapeMesh.Box(math.mul(turn, p), new float3(1.5f, 1.5f, 0.15f)));
            PlayerLoop.Frame(1f / 60);
            PlayerLoop.Frame(1f / 60);
            float3[] linear = scene.Pixels(Square);
            MeshScene.Save(name, linear);
            return Array.ConvertAll(linear, pixel => MeshScene.Srgb(pixel.x));
        }

        // sRGB from 0 to 1, the bottom row first.
        static double[] Stored(string name)
        {
            string file = Path.Combine(Session.Root(), "Headless~", "Package", "data", "boards", name + ".png");
            PngImage image = PngImage.Read(File.ReadAllBytes(file), file);
            return Array.ConvertAll(image.Pixels, pixel => pixel.r / 255.0);
        }
    }
}
