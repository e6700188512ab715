using System;
using Rill;
using Unity.Collections;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Host.Fluids
{
    /// <summary>
    /// The benchmark's dam: a block of fluid 1 m high in the left half of a closed box twice as long and 2 m tall, on a
    /// cubic lattice with offsets of ±0.02 spacings.
    /// </summary>
    sealed class BenchScene
    {
        // Blocks that published figures of this project refer to.
        static readonly (int Particles, int3 Lattice)[] Reference =
        {
            (100_000, new int3(50, 50, 40)),
            (1_000_000, new int3(100, 100, 100)),
            (10_000_000, new int3(216, 216, 216)),
        };

        public BenchScene(int particles)
        {
            Lattice = LatticeOf(particles);
            Spacing = 1f / Lattice.y;
        }

        /// <summary>A block of its own size.</summary>
        public BenchScene(int3 lattice, float spacing)
        {
            Lattice = lattice;
            Spacing = spacing;
        }

        public int3 Lattice { get; }
        public int Particles => Lattice.x * Lattice.y * Lattice.z;
        /// <summary>m.</summary>
        public float Spacing { get; }
        /// <summary>m.</summary>
        public float3 Domain => new float3(2f * Lattice.x * Spacing, 2f, Lattice.z * Spacing);

        /// <summary>Fills a solver that was just cleared.</summary>
        public void Fill(PbfSolver solver)
        {
            using var positions = new NativeArray<float4>(Particles, Allocator.Persistent);
            using var velocities = new NativeArray<float4>(Particles, Allocator.Persistent);
            NativeArray<float4> to = positions;
            var random = new Random(7);
            int i = 0;
            for (int z = 0; z < Lattice.z; z++)
                for (int y = 0; y < Lattice.y; y++)
                    for (int x = 0; x < Lattice.x; x++)
                        to[i++] = new float4((new float3(x, y, z) + 0.5f + random.NextFloat3(-0.02f, 0.02f)) * Spacing, 0f);
            solver.Add(positions, velocities);
        }

        static int3 LatticeOf(int particles)
        {
            foreach ((int count, int3 lattice) in Reference)
                if (count == particles)
                    return lattice;
            int side = Math.Max(1, (int)Math.Round(Math.Cbrt(particles)));
            return new int3(side, side, Math.Max(1, (int)Math.Round(particles / (double)(side * side))));
        }
    }
}
