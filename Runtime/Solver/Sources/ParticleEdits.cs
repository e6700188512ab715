using System;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>What scripts do to the particles between steps: removes those inside a shape, moves them against the box, and adds those of a batch that have room. Made when first needed.</summary>
    sealed class ParticleEdits : IDisposable
    {
        const int MaxBatch = 1 << 20;

        readonly ComputeShader shader = StageShader.LoadCompute("ParticleEdits");
        readonly int removeInside, removeInsideAsleep, shift, findSpace, findSpaceWithColliders, addFree, addFreeTagged, commitFree;
        readonly CommandBuffer commands = new CommandBuffer { name = "Rill.ParticleEdits" };

        public ParticleEdits()
        {
            removeInside = shader.FindKernel("RemoveInside");
            removeInsideAsleep = shader.FindKernel("RemoveInsideAsleep");
            shift = shader.FindKernel("Shift");
            findSpace = shader.FindKernel("FindSpace");
            findSpaceWithColliders = shader.FindKernel("FindSpaceWithColliders");
            addFree = shader.FindKernel("AddFree");
            addFreeTagged = shader.FindKernel("AddFreeTagged");
            commitFree = shader.FindKernel("CommitFree");
        }

        /// <summary>Takes out the particles inside a shape, at once: the next sort leaves them out.</summary>
        /// <param name="shape">In the domain's frame, d.</param>
        /// <param name="resting">Null for none.</param>
        public void RemoveInside(GraphicsBuffer constants, ParticleBuffers particles, in RoundedBox shape, RestingRegions resting)
        {
            int kernel = resting != null ? removeInsideAsleep : removeInside;
            commands.Clear();
            commands.SetComputeConstantBufferParam(shader, SolverIds.Constants, constants, 0, constants.stride);
            commands.SetComputeVectorParam(shader, Ids.ShapeCenter, new float4(shape.center, shape.radius));
            commands.SetComputeVectorParam(shader, Ids.ShapeHalf, new float4(shape.half, 0f));
            commands.SetComputeVectorParam(shader, Ids.ShapeRotation, shape.rotation.value);
            commands.SetComputeBufferParam(shader, kernel, Ids.Positions, particles.Current);
            commands.SetComputeBufferParam(shader, kernel, Ids.Counters, particles.Counters);
            resting?.BindMotion(commands, shader, kernel);
            particles.DispatchAlive(commands, shader, kernel);
            Graphics.ExecuteCommandBuffer(commands);
        }

        /// <summary>Moves all particles in the domain's frame at once, and takes out those that then lie outside.</summary>
        /// <param name="by">d.</param>
        public void Shift(GraphicsBuffer constants, ParticleBuffers particles, float3 by)
        {
            commands.Clear();
            commands.SetComputeConstantBufferParam(shader, SolverIds.Constants, constants, 0, constants.stride);
            commands.SetComputeVectorParam(shader, Ids.ShiftBy, new float4(by, 0f));
            commands.SetComputeBufferParam(shader, shift, Ids.Positions, particles.Current);
            commands.SetComputeBufferParam(shader, shift, Ids.StartPositions, particles.Start);
            commands.SetComputeBufferParam(shader, shift, Ids.Counters, particles.Counters);
            particles.DispatchAlive(commands, shader, shift);
            Graphics.ExecuteCommandBuffer(commands);
        }

        /// <summary>Adds the particles of a batch that are not too near to one that is there, nor in a collider, at once. Their upload buffers are given back.</summary>
        /// <param name="positions">xyz, d, in the domain's frame.</param>
        /// <param name="velocity">d/s, of all.</param>
        /// <param name="tag">Of all, see ParticleTags.hlsl.</param>
        /// <param name="tags">Null for none.</param>
        /// <param name="colliders">As the last step left them; null for none.</param>
        public void AddWhereFree(GraphicsBuffer constants, ParticleBuffers particles, NeighborSearch search, int capacity, NativeArray<float4> positions, float3 velocity, uint tag, ParticleTags tags, Colliders colliders)
        {
            int most = Math.Min(positions.Length, MaxBatch);
            if (most == 0)
                return;
            GraphicsBuffer batch = null, free = null, freeBefore = null;
            PrefixSum sum = null;
            try
            {
                batch = GpuBuffer.Structured<float4>("Rill.BatchPositions", most);
                free = GpuBuffer.Structured<uint>("Rill.BatchFree", most + 1);
                freeBefore = GpuBuffer.Structured<uint>("Rill.BatchFreeBefore", most + 1);
                sum = new PrefixSum(StageShader.LoadCompute("PrefixSum"), most + 1);
                for (int first = 0; first < positions.Length; first += most)
                {
                    int count = Math.Min(most, positions.Length - first);
                    batch.SetData(positions, first, 0, count);
                    commands.Clear();
                    if (first == 0)
                        search.RecordOrderAtRest(commands, constants, particles);
                    RecordFind(constants, particles, search, batch, free, count, colliders);
                    sum.Record(commands, free, freeBefore, count + 1);
                    RecordAdd(constants, particles, batch, freeBefore, count, capacity, velocity, tag, tags);
                    Graphics.ExecuteCommandBuffer(commands);
                }
            }
            finally
            {
                GpuBuffer.Release(ref batch);
                GpuBuffer.Release(ref free);
                GpuBuffer.Release(ref freeBefore);
                sum?.Dispose();
            }
        }

        public void Dispose() => commands.Dispose();

        void RecordFind(GraphicsBuffer constants, ParticleBuffers particles, NeighborSearch search, GraphicsBuffer batch, GraphicsBuffer free, int count, Colliders colliders)
        {
            int kernel = colliders != null ? findSpaceWithColliders : findSpace;
            commands.SetComputeConstantBufferParam(shader, SolverIds.Constants, constants, 0, constants.stride);
            commands.SetComputeIntParam(shader, Ids.BatchCount, count);
            colliders?.BindShapes(commands, shader, kernel);
            commands.SetComputeBufferParam(shader, kernel, Ids.BatchPositions, batch);
            commands.SetComputeBufferParam(shader, kernel, Ids.CellStarts, search.CellStarts);
            commands.SetComputeBufferParam(shader, kernel, Ids.Order, search.Order);
            commands.SetComputeBufferParam(shader, kernel, Ids.Positions, particles.Current);
            commands.SetComputeBufferParam(shader, kernel, Ids.Free, free);
            commands.DispatchCompute(shader, kernel, Groups(count + 1), 1, 1);
        }

        void RecordAdd(GraphicsBuffer constants, ParticleBuffers particles, GraphicsBuffer batch, GraphicsBuffer freeBefore, int count, int capacity, float3 velocity, uint tag, ParticleTags tags)
        {
            int kernel = tags != null ? addFreeTagged : addFree;
            commands.SetComputeIntParam(shader, Ids.BatchCapacity, capacity);
            commands.SetComputeIntParam(shader, Ids.BatchTag, (int)tag);
            commands.SetComputeVectorParam(shader, Ids.BatchVelocity, new float4(velocity, 0f));
            commands.SetComputeBufferParam(shader, kernel, Ids.BatchPositions, batch);
            commands.SetComputeBufferParam(shader, kernel, Ids.FreeBefore, freeBefore);
            commands.SetComputeBufferParam(shader, kernel, Ids.Positions, particles.Current);
            commands.SetComputeBufferParam(shader, kernel, Ids.Velocities, particles.Velocities);
            commands.SetComputeBufferParam(shader, kernel, Ids.ParticleIds, particles.Ids);
            commands.SetComputeBufferParam(shader, kernel, Ids.Counters, particles.Counters);
            if (tags != null)
                commands.SetComputeBufferParam(shader, kernel, ParticleTags.Ids.Tags, tags.Current);
            commands.DispatchCompute(shader, kernel, Groups(count), 1, 1);

            commands.SetComputeBufferParam(shader, commitFree, Ids.FreeBefore, freeBefore);
            commands.SetComputeBufferParam(shader, commitFree, Ids.Counters, particles.Counters);
            commands.SetComputeBufferParam(shader, commitFree, Ids.AliveArguments, particles.AliveArguments);
            commands.DispatchCompute(shader, commitFree, 1, 1, 1);
        }

        static int Groups(int count) => (count + ParticleBuffers.Group - 1) / ParticleBuffers.Group;

        static class Ids
        {
            public static readonly int BatchPositions = Shader.PropertyToID("_BatchPositions");
            public static readonly int BatchCount = Shader.PropertyToID("_BatchCount");
            public static readonly int BatchCapacity = Shader.PropertyToID("_BatchCapacity");
            public static readonly int BatchTag = Shader.PropertyToID("_BatchTag");
            public static readonly int BatchVelocity = Shader.PropertyToID("_BatchVelocity");
            public static readonly int ShapeCenter = Shader.PropertyToID("_ShapeCenter");
            public static readonly int ShapeHalf = Shader.PropertyToID("_ShapeHalf");
            public static readonly int ShapeRotation = Shader.PropertyToID("_ShapeRotation");
            public static readonly int CellStarts = Shader.PropertyToID("_CellStarts");
            public static readonly int ShiftBy = Shader.PropertyToID("_ShiftBy");
            public static readonly int StartPositions = Shader.PropertyToID("_StartPositions");
            public static readonly int Order = Shader.PropertyToID("_Order");
            public static readonly int Free = Shader.PropertyToID("_Free");
            public static readonly int FreeBefore = Shader.PropertyToID("_FreeBefore");
            public static readonly int Positions = Shader.PropertyToID("_Positions");
            public static readonly int Velocities = Shader.PropertyToID("_Velocities");
            public static readonly int ParticleIds = Shader.PropertyToID("_Ids");
            public static readonly int Counters = Shader.PropertyToID("_Counters");
            public static readonly int AliveArguments = Shader.PropertyToID("_AliveArguments");
        }
    }
}
