using System;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using Random = Unity.Mathematics.Random;

namespace Rill
{
    /// <summary>A box of fluid at the start: on a <see cref="FluidSimulation"/> or below it. Follows position and rotation, not scale.</summary>
    [AddComponentMenu("Rill/Fluid Volume")]
    public sealed class FluidVolume : MonoBehaviour
    {
        [Tooltip("Size of the box, m, around this object.")]
        [SerializeField] Vector3 size = Vector3.one;

        [Tooltip("Velocity at the start in world space, m/s.")]
        [SerializeField] Vector3 velocity;

        /// <summary>Offset of a particle from its lattice place, spacings: breaks the symmetry that a perfect lattice would keep.</summary>
        const float Jitter = 0.02f;

        /// <summary>Size of the box, m.</summary>
        public Vector3 Size { get => size; set => size = value; }

        /// <summary>Velocity at the start in world space, m/s.</summary>
        public Vector3 Velocity { get => velocity; set => velocity = value; }

        /// <summary>Particles that fit along each axis.</summary>
        /// <param name="spacing">m.</param>
        public int3 LatticeCounts(float spacing)
        {
            // A box of a whole number of spacings holds that many in spite of rounding.
            return (int3)math.floor((float3)size / spacing + 1e-3f);
        }

        /// <summary>Places of the particles on a cubic lattice, each offset a little; the caller disposes both arrays.</summary>
        /// <param name="spacing">m.</param>
        /// <param name="positions">xyz, world space, m.</param>
        /// <param name="velocities">xyz, world space, m/s.</param>
        /// <exception cref="ArgumentException">Size, velocity or transform is not finite, or the particles are too many for any simulation.</exception>
        internal void Fill(float spacing, int seed, out NativeArray<float4> positions, out NativeArray<float4> velocities)
        {
            float3 center = transform.position;
            if (!math.all(math.isfinite((float3)size)) || !math.all(math.isfinite((float3)velocity)) || !math.all(math.isfinite(center)))
                throw new ArgumentException($"size {size}, velocity {velocity} or position {transform.position} is not finite. Set them to numbers.");
            float3 across = math.max((float3)size / spacing, 0f);
            if (across.x * across.y * across.z > SolverLayout.MaxCapacity)
                throw new ArgumentException($"size {size} m holds more than {SolverLayout.MaxCapacity:N0} particles of spacing {spacing} m, the most of one simulation. Shrink it or raise the spacing.");

            int3 counts = math.max(LatticeCounts(spacing), 0);
            positions = new NativeArray<float4>(counts.x * counts.y * counts.z, Allocator.Persistent);
            velocities = new NativeArray<float4>(positions.Length, Allocator.Persistent);
            var random = new Random(math.hash(new int2(seed, positions.Length)) | 1u);
            float3 first = (float3)(counts - 1) * -0.5f;
            int i = 0;
            for (int z = 0; z < counts.z; z++)
                for (int y = 0; y < counts.y; y++)
                    for (int x = 0; x < counts.x; x++, i++)
                    {
                        float3 local = (first + new float3(x, y, z) + random.NextFloat3(-Jitter, Jitter)) * spacing;
                        positions[i] = new float4(center + (float3)(transform.rotation * (Vector3)local), 0f);
                        velocities[i] = new float4(velocity, 0f);
                    }
        }
    }
}
