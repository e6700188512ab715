using System;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>Particles outside of a box that moves: where they were in the world, until the box is there again. Made when first
    /// needed.</summary>
    sealed class OutsideParticles : IDisposable
    {
        readonly Buffers[] sets = new Buffers[2];       // the particles, and room to list them again as the box moves
        int current;

        /// <param name="capacity">Maximum number of particles.</param>
        /// <param name="box">Pose of the frame in which the particles lie, see <see cref="Box"/>.</param>
        public OutsideParticles(int capacity, in RigidPose box)
        {
            Capacity = capacity;
            Box = box;
            sets[0] = new Buffers(capacity);
            sets[1] = new Buffers(capacity);
        }

        public int Capacity { get; }

        /// <summary>Pose of the box in whose frame the particles lie, world space, m.</summary>
        public RigidPose Box { get; private set; }

        public ParticleSet Set => sets[current].Set;

        /// <summary>Returns the set that takes the particles in the frame of a box elsewhere.</summary>
        public ParticleSet Next => sets[1 - current].Set;

        /// <summary>Makes phases and lifetimes go along from here on.</summary>
        public void NeedTags()
        {
            sets[0].NeedTags();
            sets[1].NeedTags();
        }

        public bool HasTags => sets[0].HasTags;

        /// <summary>Moves the particles along with a box that is put elsewhere.</summary>
        /// <param name="from">Former pose of the corner of that box, world space, m.</param>
        /// <param name="to">New pose of the corner.</param>
        public void Teleport(in RigidPose from, in RigidPose to)
        {
            quaternion rotation = math.mul(to.rotation, math.inverse(from.rotation));
            Box = new RigidPose(to.position + math.rotate(rotation, Box.position - from.position), math.mul(rotation, Box.rotation));
        }

        /// <summary>Makes <see cref="Next"/> the current set, once the particles are listed in it.</summary>
        public void Advance(in RigidPose box)
        {
            current = 1 - current;
            Box = box;
            sets[1 - current].Clear();
        }

        public void Dispose()
        {
            sets[0].Dispose();
            sets[1].Dispose();
        }

        public void Describe(StageDescription stage)
        {
            foreach (Buffers buffers in sets)
                buffers.Describe(stage);
        }

        sealed class Buffers : IDisposable
        {
            readonly int capacity;
            GraphicsBuffer positions, velocities, ids, tags, counters, arguments;

            public Buffers(int capacity)
            {
                this.capacity = capacity;
                positions = GpuBuffer.Structured<float4>("Rill.Kept.Positions", capacity);
                velocities = GpuBuffer.Structured<float4>("Rill.Kept.Velocities", capacity);
                ids = GpuBuffer.Structured<uint>("Rill.Kept.Ids", capacity);
                BufferClear.Now(positions, velocities, ids);
                counters = GpuBuffer.Structured<uint>("Rill.Kept.Counters", ParticleBuffers.CounterCount);
                arguments = GpuBuffer.Arguments("Rill.Kept.Arguments");
                Clear();
            }

            public bool HasTags => tags != null;

            public ParticleSet Set => new ParticleSet(positions, velocities, ids, tags, counters, arguments, capacity);

            public void Clear()
            {
                BufferClear.Now(counters);
                arguments.SetData(new uint[arguments.count]);
            }

            public void NeedTags()
            {
                if (tags != null)
                    return;
                tags = GpuBuffer.Structured<uint>("Rill.Kept.Tags", capacity);
                BufferClear.Now(tags);
            }

            public void Describe(StageDescription stage)
            {
                stage.Buffer("Rill.Kept.Positions", positions);
                stage.Buffer("Rill.Kept.Velocities", velocities);
                stage.Buffer("Rill.Kept.Ids", ids);
                stage.Buffer("Rill.Kept.Tags", tags);
            }

            public void Dispose()
            {
                GpuBuffer.Release(ref positions);
                GpuBuffer.Release(ref velocities);
                GpuBuffer.Release(ref ids);
                GpuBuffer.Release(ref tags);
                GpuBuffer.Release(ref counters);
                GpuBuffer.Release(ref arguments);
            }
        }
    }
}
