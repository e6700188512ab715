using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>A fluid with components that let particles in and out, stepped by the test and not by frames.</summary>
    sealed class SourceScene : IDisposable
    {
        public const float Step60 = 1f / 60f;

        readonly List<GameObject> made = new List<GameObject>();
        public readonly FluidSimulation Fluid;

        /// <param name="box">m; its center is the origin.</param>
        public SourceScene(Vector3 box, float spacing, int capacity, DeepWater deepWater = DeepWater.Off)
        {
            GameObject gameObject = Make("Fluid", null);
            gameObject.SetActive(false);
            Fluid = gameObject.AddComponent<FluidSimulation>();
            Fluid.Configure(box, spacing, capacity);
            Fluid.StatisticsInterval = 0;
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = deepWater;
            Fluid.Settings = settings;
            gameObject.SetActive(true);
        }

        public float ParticleVolume => Fluid.ParticleSpacing * Fluid.ParticleSpacing * Fluid.ParticleSpacing;

        public T Add<T>(Vector3 position, Vector3 forward, Action<T> set = null) where T : FluidPart
        {
            GameObject gameObject = Make(typeof(T).Name, Fluid.transform);
            gameObject.SetActive(false);
            gameObject.transform.position = position;
            gameObject.transform.rotation = Quaternion.LookRotation(forward, math.abs(forward.y) < 0.9f ? Vector3.up : Vector3.forward);
            T part = gameObject.AddComponent<T>();
            set?.Invoke(part);
            gameObject.SetActive(true);
            return part;
        }

        /// <summary>Still water from the floor up to a height, m.</summary>
        public SourceScene Fill(float height)
        {
            GameObject gameObject = Make("Water", Fluid.transform);
            Vector3 box = Fluid.DomainSize;
            gameObject.transform.position = new Vector3(0f, (height - box.y) * 0.5f, 0f);
            gameObject.AddComponent<FluidVolume>().Size = new Vector3(box.x, height, box.z);
            Fluid.Restart();
            return this;
        }

        /// <summary>Still water in a ball around the center of the box, m.</summary>
        public SourceScene FillSphere(float radius)
        {
            FluidVolume volume = Make("Water", Fluid.transform).AddComponent<FluidVolume>();
            volume.Shape = VolumeShape.Sphere;
            volume.Radius = radius;
            Fluid.Restart();
            return this;
        }

        /// <summary>Takes fixed steps, one to a frame.</summary>
        public SourceScene Step(int count = 1)
        {
            for (int i = 0; i < count; i++)
                Fluid.Advance(Step60);
            return this;
        }

        public int Count(ParticleCounter counter) => (int)GpuTest.Read<uint>(Fluid.Solver.Counters, ParticleBuffers.CounterCount)[(int)counter];

        /// <summary>In d, in the domain's frame.</summary>
        public ParticleState Read() => TestFluid.Read(Fluid.Solver);

        /// <summary>Measured now, waiting for the device.</summary>
        public FluidStatistics Measure()
        {
            GpuTest.Run(cmd => Fluid.Solver.RecordStatistics(cmd, Fluid.Input));
            Fluid.Solver.RequestStatistics();
            AsyncGPUReadback.WaitAllRequests();
            Assert.That(Fluid.TryGetStatistics(out FluidStatistics statistics));
            return statistics;
        }

        /// <summary>Fails unless every particle is accounted for; the statistics.</summary>
        public FluidStatistics AssertConserved()
        {
            FluidStatistics s = Measure();
            ParticleState state = Read();
            string counts = $"added {s.added}, emitted {s.emitted}, handed in {s.handedIn} and out {s.handedOut}, drained {s.drained}, " +
                $"not finite {s.nonFinite}, alive {state.Count}, refused {s.refused}, blocked {s.blocked}, waiting {s.waiting}, " +
                $"recycling {s.recycling}";
            Assert.That(s.added + s.emitted + s.handedIn - s.drained - s.handedOut - s.nonFinite - state.Count, Is.Zero, counts);
            Assert.That(s.particles, Is.EqualTo(state.Count), counts);
            Assert.That(state.ids.Distinct().Count(), Is.EqualTo(state.Count), "different ids");
            Assert.That(s.escaped, Is.Zero, "escaped");
            Assert.That(state.positions.All(p => math.all(math.isfinite(p.xyz)))
                && state.velocities.All(v => math.all(math.isfinite(v.xyz))), "finite");
            return s;
        }

        /// <summary>Statistics after the numbers of all emitters have come back too.</summary>
        public void ReadBack()
        {
            Fluid.Solver.RequestSourceCounts();
            AsyncGPUReadback.WaitAllRequests();
        }

        public void Dispose()
        {
            foreach (GameObject gameObject in made)
                if (gameObject != null)
                    Object.DestroyImmediate(gameObject);
        }

        GameObject Make(string name, Transform parent)
        {
            var gameObject = new GameObject(name);
            gameObject.transform.SetParent(parent, false);
            made.Insert(0, gameObject);
            return gameObject;
        }
    }
}
