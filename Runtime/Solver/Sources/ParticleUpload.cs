using System;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Puts batches of particles into a solver. What does not fit the capacity is refused and counted on the GPU.</summary>
    sealed class ParticleUpload : IDisposable
    {
        const int MaxBatch = 1 << 20;

        /// <summary>Maximum number of particles in a batch whose buffers are retained for the next one.</summary>
        public const int MaxRetainedBatch = 1 << 14;

        readonly ComputeShader shader = StageShader.LoadCompute("ParticleUpload");
        readonly Kernel append, commit, clear, countMarked, removeAll, countRefused;
        readonly LocalKeyword withTags;
        CommandBuffer commands;         // retained: adding allocates nothing
        GraphicsBuffer batchPositions, batchVelocities;

        public ParticleUpload()
        {
            append = new Kernel(shader, "Append");
            commit = new Kernel(shader, "CommitAppend");
            clear = new Kernel(shader, "Clear");
            countMarked = new Kernel(shader, "CountMarked");
            removeAll = new Kernel(shader, "RemoveAll");
            countRefused = new Kernel(shader, "CountRefused");
            withTags = new LocalKeyword(shader, ParticleTags.Keyword);
        }

        /// <summary>Records the removal of all particles and the reset of all counters.</summary>
        public void Clear(CommandBuffer cmd, ParticleBuffers particles)
        {
            particles.Bind(cmd, shader, clear);
            cmd.DispatchCompute(shader, clear, 1, 1, 1);
        }

        /// <summary>Records the removal of all particles, which count as drained; all other counters go on.</summary>
        public void RemoveAll(CommandBuffer cmd, ParticleBuffers particles)
        {
            particles.Bind(cmd, shader, countMarked);
            particles.DispatchAlive(cmd, shader, countMarked);
            particles.Bind(cmd, shader, removeAll);
            cmd.DispatchCompute(shader, removeAll, 1, 1, 1);
        }

        /// <summary>Counts, before and after a batch, what of it is refused.</summary>
        /// <param name="refused">uint [1].</param>
        public void CountRefused(ParticleBuffers particles, GraphicsBuffer refused, bool isIn)
        {
            Commands.Clear();
            Ids.Refused.Bind(Commands, shader, countRefused, isIn, refused);
            particles.Bind(Commands, shader, countRefused);
            Commands.DispatchCompute(shader, countRefused, 1, 1, 1);
            Graphics.ExecuteCommandBuffer(Commands);
        }

        /// <summary>Records the arguments for the particles that the counters tell of.</summary>
        public void RecordArguments(CommandBuffer cmd, ParticleBuffers particles, int capacity) => RecordCommit(cmd, particles, capacity, 0);

        /// <summary>Adds particles at once, in batches; their upload buffers live until the next call or <see cref="Trim"/>.</summary>
        /// <param name="positions">xyz, d, in the domain's frame.</param>
        /// <param name="velocities">xyz, d/s; as many as positions, or one for all.</param>
        /// <param name="tags">Null for none.</param>
        /// <param name="tag">Tag of all of them, see ParticleTags.hlsl: 0 for no phase and no end.</param>
        public void Append(ParticleBuffers particles, int capacity, NativeArray<float4> positions, NativeArray<float4> velocities,
            ParticleTags tags = null, uint tag = 0)
        {
            bool isShared = velocities.Length == 1;
            if (positions.Length != velocities.Length && !isShared)
                throw new ArgumentException(Invariant($"{positions.Length:N0} positions with {velocities.Length:N0} velocities: give ") +
                    "each particle both, or one velocity to all.");

            for (int first = 0; first < positions.Length; first += MaxBatch)
            {
                int count = Math.Min(MaxBatch, positions.Length - first);
                int velocityCount = isShared ? 1 : count;
                Reserve(ref batchPositions, "Rill.BatchPositions", count);
                Reserve(ref batchVelocities, "Rill.BatchVelocities", velocityCount);
                batchPositions.SetData(positions, first, 0, count);
                batchVelocities.SetData(velocities, isShared ? 0 : first, 0, velocityCount);
                Commands.Clear();
                Commands.SetKeyword(shader, withTags, tags != null);
                Ids.Batch.Bind(Commands, shader, append, batchPositions, batchVelocities, isShared ? 0 : 1, tag, tags?.Current);
                Ids.Room.Bind(Commands, shader, append, capacity, count);
                particles.Bind(Commands, shader, append);
                Commands.DispatchCompute(shader, append, ParticleBuffers.Groups(count), 1, 1);
                RecordCommit(Commands, particles, capacity, count);
                Graphics.ExecuteCommandBuffer(Commands);
            }
        }

        /// <summary>Releases upload buffers that are larger than those of a burst.</summary>
        public void TrimLarge()
        {
            if (batchPositions != null && batchPositions.count > MaxRetainedBatch)
                Trim();
        }

        /// <summary>Releases the upload buffers.</summary>
        public void Trim()
        {
            GpuBuffer.Release(ref batchPositions);
            GpuBuffer.Release(ref batchVelocities);
        }

        public void Dispose()
        {
            Trim();
            commands?.Dispose();
            commands = null;
        }

        CommandBuffer Commands => commands ??= new CommandBuffer { name = "Rill.ParticleUpload" };

        static void Reserve(ref GraphicsBuffer buffer, string name, int count)
        {
            if (buffer != null && buffer.count >= count)
                return;
            GpuBuffer.Release(ref buffer);
            buffer = GpuBuffer.Structured<float4>(name, count);
        }

        void RecordCommit(CommandBuffer cmd, ParticleBuffers particles, int capacity, int count)
        {
            Ids.Room.Bind(cmd, shader, commit, capacity, count);
            particles.Bind(cmd, shader, commit);
            cmd.DispatchCompute(shader, commit, 1, 1, 1);
        }

        static class Ids
        {
            public static readonly ShaderParameters Batch = new ShaderParameters(
                "_BatchPositions", "_BatchVelocities", "_VelocityStride", "_BatchTag", "_Tags");
            public static readonly ShaderParameters Room = new ShaderParameters("_BatchCapacity", "_BatchCount");
            public static readonly ShaderParameters Refused = new ShaderParameters("_BatchIsIn", "_RefusedOfScripts");
        }
    }
}
