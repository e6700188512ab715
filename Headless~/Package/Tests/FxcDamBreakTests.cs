using System;
using System.Linq;
using System.Reflection;
using Host.Assets;
using Host.Shaders;
using NUnit.Framework;
using Rill;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>Runs one small dam break with the package's kernels from glslang and from FXC's bytecode.</summary>
    public class FxcDamBreakTests : GraphicsFixture
    {
        const int Frames = 60;
        const float FrameTime = 1f / 60f;

        // With assets of their own: those of the run have their kernels already.
        static T With<T>(IShaderBackend backend, Func<T> play)
        {
            IShaderBackend backendBefore = ShaderBackend.Current;
            IAssetSource assetsBefore = Player.Assets;
            ShaderBackend.Current = backend;
            var assets = new ProjectAssets(ProjectFolders.Of(Session.Root()), new[] { typeof(FluidSimulation).Assembly }, strict: true);
            Player.Assets = assets;
            try
            {
                return play();
            }
            finally
            {
                PlayerLoop.Reset();
                assets.ReloadAll();
                Player.Assets = assetsBefore;
                ShaderBackend.Current = backendBefore;
            }
        }

        static FluidStatistics Collapse()
        {
            FluidSimulation simulation = Build(drawn: false);
            for (int i = 0; i < Frames; i++)
                PlayerLoop.Frame(FrameTime);
            HostSetup.Device.WaitIdle();
            PlayerLoop.Frame(0f);
            Assert.That(simulation.TryGetStatistics(out FluidStatistics statistics), Is.True);
            return statistics;
        }

        static byte[] Picture()
        {
            Player.ScreenWidth = 160;
            Player.ScreenHeight = 96;
            Build(drawn: true);
            PlayerLoop.Frame(FrameTime);
            return Screenshot.ReadRgba();
        }

        // 1,280 particles against one wall of a tank.
        static FluidSimulation Build(bool drawn)
        {
            var fluid = new GameObject("Fluid");
            fluid.SetActive(false);
            var simulation = fluid.AddComponent<FluidSimulation>();
            simulation.Configure(new Vector3(2f, 1f, 0.8f), 0.1f, 1400);
            simulation.StatisticsInterval = 1;
            FluidMaterial material = simulation.Material;
            material.vorticity = 0.5f;
            material.artificialPressure = 0.05f;
            simulation.Material = material;
            var block = new GameObject("Block");
            block.transform.SetParent(fluid.transform);
            block.transform.localPosition = new Vector3(-0.5f, 0f, 0f);
            block.AddComponent<FluidVolume>().Size = new Vector3(1f, 1f, 0.8f);
            if (drawn)
            {
                fluid.AddComponent<ParticleRenderer>();
                fluid.AddComponent<DomainRenderer>();
                new GameObject("Camera").AddComponent<Camera>().transform.position = new Vector3(0f, 0f, -2f);
            }
            fluid.SetActive(true);
            return simulation;
        }

        [Test]
        public void Water_collapses_the_same_way()
        {
            FluidStatistics expected = With(ShaderBackend.Glslang, Collapse), got = With(ShaderBackend.Fxc, Collapse);
            string[] kernels = ShaderBackend.Bytecode().Where(name => name.Contains(".compute")).ToArray();
            Assert.That(kernels.Length, Is.GreaterThanOrEqualTo(15), "kernels from bytecode: " + string.Join(", ", kernels));

            Assert.That(expected.particles, Is.GreaterThan(700));
            Assert.That(got.particles, Is.EqualTo(expected.particles));
            Assert.That(got.step, Is.EqualTo(expected.step));
            Assert.That(new[] { got.nonFinite, got.escaped, got.refused }, Is.All.Zero);
            foreach (FieldInfo field in typeof(FluidStatistics).GetFields().Where(f => f.FieldType == typeof(float)))
                Assert.That(float.IsNaN((float)field.GetValue(got)) || float.IsInfinity((float)field.GetValue(got)), Is.False, field.Name);

            // The splash is chaotic, so that particles diverge; what they do together does not.
            Assert.That(got.volumeRatio, Is.EqualTo(expected.volumeRatio).Within(0.05f * expected.volumeRatio));
            Assert.That(got.speed, Is.EqualTo(expected.speed).Within(0.1f * expected.speed));
            Assert.That(got.furthest.x, Is.EqualTo(expected.furthest.x).Within(0.1f));
            Assert.That(got.densityError, Is.EqualTo(expected.densityError).Within(0.01f));
            TestContext.WriteLine($"volume {expected.volumeRatio} {got.volumeRatio}, speed {expected.speed} {got.speed}, front " +
                $"{expected.furthest.x} {got.furthest.x}, density error {expected.densityError} {got.densityError}");
        }

        [Test]
        public void It_looks_the_same()
        {
            byte[] expected = With(ShaderBackend.Glslang, Picture), got = With(ShaderBackend.Fxc, Picture);
            Assert.That(ShaderBackend.Bytecode().Count(name => name.Contains(".shader")), Is.GreaterThanOrEqualTo(4),
                "both stages of particles and domain from bytecode");
            Assert.That(expected.Distinct().Count(), Is.GreaterThan(20), "there is something to see");
            // A sphere's edge may fall on the other side of a pixel's center.
            int different = Enumerable.Range(0, expected.Length).Count(i => Math.Abs(expected[i] - got[i]) > 2);
            Assert.That(different, Is.LessThanOrEqualTo(expected.Length / 500));
        }
    }
}
