using System.Linq;
using NUnit.Framework;
using Rill;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace Host.Tests
{
    /// <summary>Fluids in a player without a graphics device: a dedicated server, or a build machine's play-mode tests.</summary>
    public class NoGraphicsTests : GraphicsFixture
    {
        const float FrameTime = 1f / 60f;
        const string Notice = "is inactive, like every other: this player has no graphics device";

        [SetUp]
        public void RemoveDevice() => Player.Device = null;

        [TearDown]
        public void GiveItBack() => Player.Device = HostSetup.Device;

        [TestCase("Dam Break")]
        [TestCase("Tap and Basin")]
        [TestCase("Water Wheel")]
        [TestCase("Flooded Quay")]
        [TestCase("Floating Bodies")]
        public void A_sample_plays_on_and_logs_one_line_that_is_no_warning(string sample)
        {
            Assert.That(SystemInfo.graphicsDeviceType, Is.EqualTo(GraphicsDeviceType.Null));
            using (new SampleScene(sample))
                for (int frame = 0; frame < 150; frame++)      // longer than FluidBuoyancy waits for a fluid
                    PlayerLoop.Frame(FrameTime);
            Assert.That(Logged.Single(), Does.Contain(Notice).And.StartWith("Log: "), string.Join("\n", Logged));
        }

        [Test]
        public void What_a_game_asks_of_the_fluid_is_harmless()
        {
            FluidSimulation simulation = FluidSceneTests.Build("particles and domain drawn");
            var jet = new GameObject("Emitter");
            jet.transform.SetParent(simulation.transform);
            var emitter = jet.AddComponent<FluidEmitter>();
            PlayerLoop.Frame(FrameTime);
            using (var positions = new NativeArray<float3>(3, Allocator.Persistent))
            using (var velocities = new NativeArray<float3>(3, Allocator.Persistent))
            using (var other = new NativeArray<float3>(2, Allocator.Persistent))
            {
                simulation.AddParticles(positions, velocities);
                Assert.That(() => simulation.AddParticles(positions, other), Throws.ArgumentException);
            }
            simulation.Restart();
            simulation.Configure(new Vector3(1f, 1f, 1f), 0.1f, 100);
            PlayerLoop.Frame(FrameTime);
            Assert.That(simulation.TryGetStatistics(out _), Is.False);
            Assert.That(emitter.Emitted, Is.Zero);
            Assert.That(simulation.enabled, Is.True, "a game's own check that it left the fluid on shall hold");
            Assert.That(simulation.IsRunning, Is.False);
            Assert.That(simulation.Results.Describe(), Is.Empty);
            simulation.enabled = false;
            simulation.enabled = true;
            PlayerLoop.Frame(FrameTime);
            Assert.That(Logged, Has.Count.EqualTo(1).And.Some.Contains(Notice), string.Join("\n", Logged));
        }
    }
}
