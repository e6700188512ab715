using System.Linq;
using Rill;
using Unity.Mathematics;
using UnityEngine;

namespace Host.Tests
{
    /// <summary>Foam that a test puts where it wants it, instead of what the water makes.</summary>
    static class PlantedFoam
    {
        /// <summary>A component that makes no foam of its own.</summary>
        public static FluidFoam Add(GameObject fluid)
        {
            FluidFoam foam = fluid.AddComponent<FluidFoam>();
            FoamSettings settings = foam.Settings;
            settings.amount = 0;
            foam.Settings = settings;
            foam.Radius = 0.06f;
            return foam;
        }

        /// <summary>Plants foam of the largest size, halfway through its life: on a square on top of a block of water and spray beside it. The fluid
        /// is paused.</summary>
        /// <param name="top">Center of the block's upper face, from the center of the domain, m.</param>
        public static void Plant(FluidSimulation fluid, Vector3 top)
        {
            Foam stage = fluid.Solver.Foam;
            FoamParticle[] particles = Enumerable.Range(0, 64).Select(i =>
            {
                bool isSpray = i >= 32;
                var at = new float3((i % 8 - 3.5f) * 0.1f, isSpray ? 0.3f : 0f, (i / 8 % 4 - 1.5f) * 0.15f);
                float3 position = ((float3)(top + 0.5f * fluid.DomainSize) + at) / fluid.ParticleSpacing;
                return new FoamParticle { a = new uint4(math.asuint(position), math.asuint(20f)),
                    b = new uint4(0u, 0u, 0u, (isSpray ? 1u : 2u) | 6400u << 2 | 255u << 16) };
            }).ToArray();
            stage.Particles.SetData(particles, 0, 0, particles.Length);
            stage.Counters.SetData(new[] { (uint)particles.Length, 0u, 0u, 0u, 0u, 0u, 0u, 0u });
            uint vertices = (uint)(particles.Length * GpuBuffer.VerticesPerParticle);
            stage.Arguments.SetData(new[] { vertices, 1u, 0u, 0u, 1u, 1u, 1u, (uint)particles.Length, vertices, 2u, 0u, 0u });
        }
    }
}
