using System;
using System.Diagnostics;
using Host.Testing;
using NUnit.Framework;
using Rill;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>Cost of the start: no frame of it fills the garbage collector.</summary>
    [Category(FixtureOrder.Alone)]      // its figures are times
    public class StartupTests : GraphicsFixture
    {
        const long MaxManagedBytes = 1 << 20;       // of a frame

        /// <summary>A detector for the test below: arrays of zeros for an eighth of these particles would pass the limit.</summary>
        [Test]
        public void A_managed_array_is_counted()
        {
            long before = NativeWork.ScriptBytes;
            var zeros = new uint[MaxManagedBytes / sizeof(uint)];
            Assert.That(NativeWork.ScriptBytes - before, Is.GreaterThanOrEqualTo(MaxManagedBytes));
            GC.KeepAlive(zeros);
        }

        [Test]
        public void No_frame_of_a_fluid_that_begins_and_uses_everything_allocates_a_megabyte()
        {
            GameObject water = Water(400000);
            PlayerLoop.Frame(1f / 60f);     // imports the shaders, which Unity does as it builds
            water.SetActive(false);
            for (int frame = 0; frame < 4; frame++)
                PlayerLoop.Frame(1f / 60f);
            for (int frame = 0; frame < 4; frame++)
            {
                long before = NativeWork.ScriptBytes;
                if (frame == 0)
                    water.SetActive(true);
                PlayerLoop.Frame(1f / 60f);
                long bytes = NativeWork.ScriptBytes - before;
                TestContext.Out.WriteLine($"frame {frame}: {bytes:N0} bytes");
                Assert.That(bytes, Is.LessThan(MaxManagedBytes), $"frame {frame}");
            }
            Assert.That(water.GetComponent<FluidSimulation>().StepCount, Is.GreaterThan(0));
            UnityEngine.Object.DestroyImmediate(water);
        }

        [Test]
        public void A_million_particles_are_made_without_managed_memory([Values(VolumeShape.Box, VolumeShape.Sphere)] VolumeShape shape)
        {
            var volume = new GameObject("Volume").AddComponent<FluidVolume>();
            volume.Shape = shape;
            volume.Size = Vector3.one;
            volume.Radius = math.pow(3f / (4f * math.PI), 1f / 3f);
            for (int run = 0; run < 3; run++)
            {
                long before = NativeWork.ScriptBytes;
                var watch = Stopwatch.StartNew();
                using (NativeArray<float4> positions = volume.CreatePositions(0.01f, 1))
                {
                    double milliseconds = watch.Elapsed.TotalMilliseconds;
                    Assert.That(positions.Length, Is.EqualTo(1000000).Within(30000));
                    TestContext.Out.WriteLine($"{positions.Length:N0} particles in {milliseconds:0.0} ms");
                }
                Assert.That(NativeWork.ScriptBytes - before, Is.LessThan(20000));
            }
            UnityEngine.Object.DestroyImmediate(volume.gameObject);
        }

        /// <summary>Prints what a whole start takes of the main thread: positions, upload and commands, without the GPU's own work.</summary>
        [Test]
        public void A_fluid_of_a_million_particles_begins_without_managed_memory()
        {
            var water = new GameObject("Water");
            water.SetActive(false);
            var simulation = water.AddComponent<FluidSimulation>();
            simulation.Configure(new Vector3(2f, 2f, 2f), 0.02f, 1000000);
            water.AddComponent<FluidVolume>().Size = new Vector3(2f, 2f, 2f);
            water.SetActive(true);
            var counters = new uint[ParticleBuffers.CounterCount];
            for (int run = 0; run < 5; run++)
            {
                long before = NativeWork.ScriptBytes;
                var watch = Stopwatch.StartNew();
                simulation.Restart();
                TestContext.Out.WriteLine($"1,000,000 particles in {watch.Elapsed.TotalMilliseconds:0.0} ms");
                Assert.That(NativeWork.ScriptBytes - before, Is.LessThan(20000));
                simulation.Solver.Counters.GetData(counters);       // lavapipe shares the cores: the next run begins when it is done
                Assert.That(counters[(int)ParticleCounter.Alive], Is.EqualTo(1000000));
            }
            UnityEngine.Object.DestroyImmediate(water);
        }

        static GameObject Water(int capacity)
        {
            var water = new GameObject("Water");
            water.SetActive(false);
            var simulation = water.AddComponent<FluidSimulation>();
            simulation.Configure(new Vector3(2f, 2f, 2f), 0.03f, capacity);
            simulation.StatisticsInterval = 1;
            FluidMaterial material = FluidMaterial.Water;
            material.shearModulus = 10f;
            simulation.Material = material;
            SolverSettings settings = simulation.Settings;
            settings.sleepSpeed = 0.02f;
            settings.deepWater = DeepWater.On;
            simulation.Settings = settings;
            water.AddComponent<FluidVolume>().Size = new Vector3(0.3f, 0.3f, 0.3f);
            var emitter = new GameObject("Emitter").AddComponent<FluidEmitter>();
            emitter.transform.SetParent(water.transform, false);
            emitter.Phase = 1;
            emitter.Lifetime = 1f;
            water.SetActive(true);
            return water;
        }
    }
}
