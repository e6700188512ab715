using System;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Edits of the particles by scripts between steps: removes those inside a shape, moves them against the box, and adds those
    /// of a batch that have room. Made when first needed.</summary>
    sealed class ParticleEdits : Stage
    {
        const int MaxBatch = 1 << 20;

        readonly ComputeShader shader = StageShader.LoadCompute("ParticleEdits");
        readonly KernelVariants removeInside, findSpace, addFree;     // where water sleeps; with colliders; with tags
        readonly Kernel shift, commitFree;
        readonly CommandBuffer commands = new CommandBuffer { name = "Rill.ParticleEdits" };

        public ParticleEdits()
        {
            removeInside = new KernelVariants(shader, "RemoveInside", "RemoveInsideAsleep");
            findSpace = new KernelVariants(shader, "FindSpace", "FindSpaceWithColliders");
            addFree = new KernelVariants(shader, "AddFree", "AddFreeTagged");
            shift = new Kernel(shader, "Shift");
            commitFree = new Kernel(shader, "CommitFree");
        }

        /// <summary>Command buffer of the contexts that are given to the calls below, which execute it.</summary>
        public CommandBuffer Commands => commands;

        /// <summary>Takes out the particles inside a shape, at once: the next sort leaves them out.</summary>
        /// <param name="shape">In the domain's frame, d.</param>
        public void RemoveInside(in StepContext step, in RoundedBox shape)
        {
            int kernel = removeInside.For(step.MaySleep);
            Begin(step);
            Ids.Shape.Bind(commands, shader, kernel, new float4(shape.center, shape.radius), shape.half, shape.rotation.value);
            step.Particles.Bind(commands, shader, kernel);
            step.BindWaking(shader, kernel);
            step.Particles.DispatchAlive(commands, shader, kernel);
            Graphics.ExecuteCommandBuffer(commands);
        }

        /// <summary>Moves all particles in the domain's frame at once, and takes out those that then lie outside.</summary>
        /// <param name="by">d.</param>
        public void Shift(in StepContext step, float3 by)
        {
            Begin(step);
            commands.SetComputeVectorParam(shader, Ids.ShiftBy, new float4(by, 0f));
            step.Particles.Bind(commands, shader, shift);
            step.Particles.DispatchAlive(commands, shader, shift);
            Graphics.ExecuteCommandBuffer(commands);
        }

        /// <summary>Adds the particles of a batch that are not too near to one that is there, nor in a collider as the last step left it,
        /// at once. Their upload buffers are given back.</summary>
        /// <param name="positions">xyz, d, in the domain's frame.</param>
        /// <param name="velocity">d/s, of all.</param>
        /// <param name="tag">Tag of all, see ParticleTags.hlsl.</param>
        /// <param name="tags">Null for none.</param>
        public void AddIntoFreeSpace(in StepContext step, NativeArray<float4> positions, float3 velocity, uint tag, ParticleTags tags)
        {
            int most = Math.Min(positions.Length, MaxBatch);
            if (most == 0)
                return;
            var buffers = new BufferSet();
            PrefixSum sum = null;
            try
            {
                GraphicsBuffer batch = buffers.Structured<float4>("Rill.BatchPositions", most);
                GraphicsBuffer free = buffers.Structured<uint>("Rill.BatchFree", most + 1, "_Free");
                GraphicsBuffer freeBefore = buffers.Structured<uint>("Rill.BatchFreeBefore", most + 1, "_FreeBefore");
                sum = new PrefixSum(StageShader.LoadCompute("PrefixSum"), most + 1);
                for (int first = 0; first < positions.Length; first += most)
                {
                    int count = Math.Min(most, positions.Length - first);
                    batch.SetData(positions, first, 0, count);
                    Begin(step);
                    if (first == 0)
                        step.Search.RecordOrderAtRest(step);
                    RecordFind(step, buffers, count);
                    sum.Record(commands, free, freeBefore, count + 1);
                    RecordAdd(step, buffers, count, velocity, tag, tags);
                    Graphics.ExecuteCommandBuffer(commands);
                }
            }
            finally
            {
                buffers.Dispose();
                sum?.Dispose();
            }
        }

        public override void Dispose() => commands.Dispose();

        void Begin(in StepContext step)
        {
            commands.Clear();
            step.BindConstants(shader);
        }

        void RecordFind(in StepContext step, BufferSet buffers, int count)
        {
            int kernel = findSpace.For(step.Colliders != null);
            commands.SetComputeIntParam(shader, Ids.BatchCount, count);
            step.Colliders?.BindShapes(commands, shader, kernel);
            buffers.Bind(commands, shader, kernel);
            step.BindOrderAtRest(shader, kernel);
            step.Particles.Bind(commands, shader, kernel);
            commands.DispatchCompute(shader, kernel, ParticleBuffers.Groups(count + 1), 1, 1);
        }

        void RecordAdd(in StepContext step, BufferSet buffers, int count, float3 velocity, uint tag, ParticleTags tags)
        {
            int kernel = addFree.For(tags != null);
            Ids.Batch.Bind(commands, shader, kernel, step.Layout.Capacity, velocity, tag, tags?.Current);
            buffers.Bind(commands, shader, kernel);
            step.Particles.Bind(commands, shader, kernel);
            commands.DispatchCompute(shader, kernel, ParticleBuffers.Groups(count), 1, 1);

            buffers.Bind(commands, shader, commitFree);
            step.Particles.Bind(commands, shader, commitFree);
            commands.DispatchCompute(shader, commitFree, 1, 1, 1);
        }

        static class Ids
        {
            public static readonly int BatchCount = Shader.PropertyToID("_BatchCount");
            public static readonly ShaderParameters Batch = new ShaderParameters("_BatchCapacity", "_BatchVelocity", "_BatchTag", "_Tags");
            public static readonly ShaderParameters Shape = new ShaderParameters("_ShapeCenter", "_ShapeHalf", "_ShapeRotation");
            public static readonly int ShiftBy = Shader.PropertyToID("_ShiftBy");
        }
    }
}
