using System;
using System.Linq;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>Particles on the CPU and the box around them, in d: made for a test, put into buffers, read back.</summary>
    sealed class ParticleState
    {
        public float3 box;
        public float4[] positions, velocities;
        public uint[] ids;

        public int Count => positions.Length;

        /// <summary>At rest, numbered in their order.</summary>
        public ParticleState(float3 box, float3[] points)
        {
            this.box = box;
            positions = points.Select(p => new float4(p, 0f)).ToArray();
            velocities = new float4[points.Length];
            ids = Enumerable.Range(0, points.Length).Select(i => (uint)i).ToArray();
        }

        /// <summary>Positions anywhere in a box of three different sides, about as many as its volume: densities on both sides of rest.</summary>
        public static ParticleState Random(int count, int seed, float speed = 0f)
        {
            float side = math.max((float)Math.Pow(count, 1.0 / 3.0), 5f);
            float3 box = side * new float3(1f, 1.25f, 0.8f);
            var random = new Unity.Mathematics.Random((uint)seed * 7919u + 1u);
            var state = new ParticleState(box, Enumerable.Range(0, count).Select(_ => random.NextFloat3(0.5f, box - 0.5f)).ToArray());
            for (int i = 0; i < count; i++)
                state.velocities[i] = new float4(random.NextFloat3(-speed, speed), 1f);
            return state;
        }

        /// <summary>A cubic lattice of spacing 1 from <paramref name="first"/> on, each particle up to <paramref name="jitter"/> off its
        /// position.</summary>
        public static ParticleState Lattice(float3 box, float3 first, int3 counts, float jitter = 0f)
        {
            var random = new Unity.Mathematics.Random(4711u);
            var positions = new float3[counts.x * counts.y * counts.z];
            for (int i = 0; i < positions.Length; i++)
            {
                var cell = new float3(i % counts.x, i / counts.x % counts.y, i / (counts.x * counts.y));
                positions[i] = first + cell + random.NextFloat3(-jitter, jitter);
            }
            return new ParticleState(box, positions);
        }

        /// <summary>Returns the particles in another order, with their ids.</summary>
        public ParticleState Shuffled(int seed)
        {
            var random = new System.Random(seed);
            int[] order = Enumerable.Range(0, Count).OrderBy(_ => random.Next()).ToArray();
            return new ParticleState(box, new float3[0])
            {
                positions = order.Select(i => positions[i]).ToArray(),
                velocities = order.Select(i => velocities[i]).ToArray(),
                ids = order.Select(i => ids[i]).ToArray(),
            };
        }

        public ParticleState With(Func<float3, float3> velocityAt)
        {
            velocities = positions.Select(p => new float4(velocityAt(p.xyz), 1f)).ToArray();
            return this;
        }

        /// <summary>Makes them the particles alive; all that a step has to write is garbage.</summary>
        public void WriteTo(ParticleBuffers particles)
        {
            foreach (GraphicsBuffer buffer in new[] { particles.Positions, particles.Start, particles.Predicted, particles.Velocities,
                particles.Ids, particles.SortedIds, particles.Counters, particles.AliveArguments, particles.SortedArguments })
                GpuTest.FillWithGarbage(buffer);

            if (Count > 0)
            {
                particles.Positions.SetData(positions, 0, 0, Count);
                particles.Velocities.SetData(velocities, 0, 0, Count);
                particles.Ids.SetData(ids, 0, 0, Count);
            }

            uint[] counters = Enumerable.Repeat(GpuTest.Garbage, ParticleBuffers.CounterCount).ToArray();
            counters[(int)ParticleCounter.Alive] = counters[(int)ParticleCounter.NextId] = (uint)Count;
            counters[(int)ParticleCounter.Refused] = counters[(int)ParticleCounter.NonFinite] = 0;
            particles.Counters.SetData(counters);
            particles.AliveArguments.SetData(ArgumentsFor(Count));
        }

        /// <summary>Words of a buffer of arguments.</summary>
        public const int ArgumentCount = 12;

        /// <summary>Returns what Arguments.hlsl writes for a number of particles: a draw of one instance, a dispatch, a draw of two.</summary>
        public static uint[] ArgumentsFor(int count)
        {
            uint vertices = (uint)(count * GpuBuffer.VerticesPerParticle);
            uint groups = (uint)Math.Max((count + ParticleBuffers.Group - 1) / ParticleBuffers.Group, 1);
            return new[] { vertices, 1u, 0u, 0u, groups, 1u, 1u, (uint)count, vertices, 2u, 0u, 0u };
        }
    }
}
