using System;
using System.Collections;
using System.Collections.Generic;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>Fluids in a playing scene, a frame to each fixed step. What a test made is destroyed after it.</summary>
    public abstract class PlayedFluidFixture
    {
        protected readonly List<GameObject> made = new List<GameObject>();

        [SetUp]
        public void OneStepAFrame() => Time.captureDeltaTime = 1f / 60f;

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            foreach (GameObject gameObject in made)
                Object.Destroy(gameObject);
            made.Clear();
            Time.captureDeltaTime = 0f;
            yield return null;
        }

        /// <summary>A simulation that starts after 'setUp'; the water stands in the domain's lowest corner.</summary>
        protected FluidSimulation Fluid(string name, Vector3 box, float spacing, int capacity, Vector3 water, Action<FluidSimulation> setUp = null)
        {
            var gameObject = new GameObject(name);
            made.Add(gameObject);
            gameObject.SetActive(false);
            var fluid = gameObject.AddComponent<FluidSimulation>();
            fluid.Configure(box, spacing, capacity);
            if (water != Vector3.zero)
                AddWater(fluid, water, (water - box) * 0.5f);
            setUp?.Invoke(fluid);
            gameObject.SetActive(true);
            return fluid;
        }

        protected static void AddWater(FluidSimulation fluid, Vector3 size, Vector3 center)
        {
            var child = new GameObject("Water");
            child.transform.SetParent(fluid.transform, false);
            child.transform.localPosition = center;
            child.AddComponent<FluidVolume>().Size = size;
        }

        /// <summary>Adds a particle, world space, m and m/s.</summary>
        protected static void Add(FluidSimulation fluid, float3 position, float3 velocity)
        {
            using (var positions = new NativeArray<float3>(new[] { position }, Allocator.Persistent))
            using (var velocities = new NativeArray<float3>(new[] { velocity }, Allocator.Persistent))
                fluid.AddParticles(positions, velocities);
        }

        protected static IEnumerator Frames(int count)
        {
            for (int i = 0; i < count; i++)
                yield return null;
        }
    }
}
