using System;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Finds the particles that a collider may touch in a substep, for the kernels of <see cref="Colliders"/> to run for those alone.</summary>
    sealed class NearColliders : IDisposable
    {
        /// <summary>Of dispatch arguments, = kPaths and kPasses in NearColliders.hlsl: bytes in <see cref="Arguments"/>.</summary>
        public const uint PathsAt = 0, PassesAt = 16;

        readonly ComputeShader shader = StageShader.LoadCompute("NearColliders");
        readonly int findPaths, findPathsDeep, findNear, findLate;
        GraphicsBuffer near, counts, arguments;
        NativeArray<uint> none, noGroups;

        public NearColliders(int capacity)
        {
            findPaths = shader.FindKernel("FindPaths");
            findPathsDeep = shader.FindKernel("FindPathsDeep");
            findNear = shader.FindKernel("FindNear");
            findLate = shader.FindKernel("FindLate");
            near = GpuBuffer.Structured<uint>("Rill.Colliders.Near", capacity);
            counts = GpuBuffer.Structured<uint>("Rill.Colliders.NearCounts", 2);
            arguments = GpuBuffer.Arguments("Rill.Colliders.NearArguments");
            none = new NativeArray<uint>(2, Allocator.Persistent);
            noGroups = new NativeArray<uint>(new uint[] { 0, 0, 1, 0, 0, 0, 1, 0 }, Allocator.Persistent);
        }

        public GraphicsBuffer Arguments => arguments;

        public void RecordConstants(CommandBuffer cmd, GraphicsBuffer solverConstants) => cmd.SetComputeConstantBufferParam(shader, SolverIds.Constants, solverConstants, 0, solverConstants.stride);

        /// <summary>Records the search for particles whose way comes near a collider; in deep water after the displacement of the projection was added to their velocities.</summary>
        /// <param name="colliders">Of the substep.</param>
        public void RecordPaths(CommandBuffer cmd, Colliders colliders, ParticleBuffers particles, CoarseCorrection coarse, RestingRegions resting)
        {
            cmd.SetBufferData(counts, none);
            cmd.SetBufferData(arguments, noGroups);
            int kernel = coarse != null ? findPathsDeep : findPaths;
            colliders.BindShapes(cmd, shader, kernel);
            colliders.BindResting(cmd, shader, kernel, resting);
            if (coarse != null)
            {
                cmd.SetComputeConstantBufferParam(shader, CoarseIds.Constants, coarse.Constants, 0, coarse.Constants.stride);
                cmd.SetComputeBufferParam(shader, kernel, CoarseIds.Displacements, coarse.Displacements);
            }
            cmd.SetComputeBufferParam(shader, kernel, Ids.Positions, particles.Current);
            cmd.SetComputeBufferParam(shader, kernel, Ids.Velocities, particles.Velocities);
            Dispatch(cmd, kernel, particles, particles.AliveArguments);
        }

        /// <summary>Records the search for particles whose predicted position is near a collider, and that no particle has density from one or a distance to keep.</summary>
        public void RecordNear(CommandBuffer cmd, Colliders colliders, ParticleBuffers particles, GraphicsBuffer boundary, GraphicsBuffer insets)
        {
            colliders.BindShapes(cmd, shader, findNear);
            cmd.SetComputeBufferParam(shader, findNear, Ids.Predicted, particles.Predicted);
            cmd.SetComputeBufferParam(shader, findNear, Ids.Boundary, boundary);
            cmd.SetComputeBufferParam(shader, findNear, Ids.Insets, insets);
            Dispatch(cmd, findNear, particles, particles.SortedArguments);
        }

        /// <summary>Records the search for particles that have come near a collider since, by the positions that a pass left in Predicted.</summary>
        public void RecordLate(CommandBuffer cmd, Colliders colliders, ParticleBuffers particles, GraphicsBuffer insets)
        {
            colliders.BindShapes(cmd, shader, findLate);
            cmd.SetComputeBufferParam(shader, findLate, Ids.Corrected, particles.Predicted);
            cmd.SetComputeBufferParam(shader, findLate, Ids.Insets, insets);
            Dispatch(cmd, findLate, particles, particles.SortedArguments);
        }

        /// <summary>Records the particles found as what a kernel reads.</summary>
        public void Bind(CommandBuffer cmd, ComputeShader reader, int kernel)
        {
            cmd.SetComputeBufferParam(reader, kernel, Ids.Near, near);
            cmd.SetComputeBufferParam(reader, kernel, Ids.NearCounts, counts);
        }

        /// <param name="deep">Whether a coarse correction runs.</param>
        public void Describe(StageDescription description, in SolverSettings settings, bool deep)
        {
            description.Kernel("NearColliders", deep ? "FindPathsDeep" : "FindPaths", settings.substeps);
            description.Kernel("NearColliders", "FindNear", settings.substeps);
            description.Kernel("NearColliders", "FindLate", settings.substeps * settings.iterations);
            description.Buffer("Rill.Colliders.Near", near);
            description.Buffer("Rill.Colliders.NearCounts", counts);
            description.Buffer("Rill.Colliders.NearArguments", arguments);
        }

        public void Dispose()
        {
            GpuBuffer.Release(ref near);
            GpuBuffer.Release(ref counts);
            GpuBuffer.Release(ref arguments);
            none.Dispose();
            noGroups.Dispose();
        }

        void Dispatch(CommandBuffer cmd, int kernel, ParticleBuffers particles, GraphicsBuffer all)
        {
            cmd.SetComputeBufferParam(shader, kernel, Ids.Near, near);
            cmd.SetComputeBufferParam(shader, kernel, Ids.NearCounts, counts);
            cmd.SetComputeBufferParam(shader, kernel, Ids.NearArguments, arguments);
            cmd.SetComputeBufferParam(shader, kernel, Ids.Counters, particles.Counters);
            cmd.DispatchCompute(shader, kernel, all, GpuBuffer.DispatchArgumentsAt);
        }

        static class Ids
        {
            public static readonly int Positions = Shader.PropertyToID("_Positions");
            public static readonly int Velocities = Shader.PropertyToID("_Velocities");
            public static readonly int Predicted = Shader.PropertyToID("_Predicted");
            public static readonly int Corrected = Shader.PropertyToID("_Corrected");
            public static readonly int Boundary = Shader.PropertyToID("_Boundary");
            public static readonly int Insets = Shader.PropertyToID("_Insets");
            public static readonly int Near = Shader.PropertyToID("_Near");
            public static readonly int NearCounts = Shader.PropertyToID("_NearCounts");
            public static readonly int NearArguments = Shader.PropertyToID("_NearArguments");
            public static readonly int Counters = Shader.PropertyToID("_Counters");
        }
    }
}
