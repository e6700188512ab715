using System;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Jacobi iterations of the density constraint (Macklin and Müller 2013, algorithm 1, lines 5-19).</summary>
    sealed class DensityConstraint : IDisposable
    {
        static readonly ProfilerMarker ListMarker = GpuMarker.Create("Rill.List");
        static readonly ProfilerMarker LambdaMarker = GpuMarker.Create("Rill.Lambda");
        static readonly ProfilerMarker DisplaceMarker = GpuMarker.Create("Rill.ApplyDeltaP");

        readonly ComputeShader shader = StageShader.LoadCompute("DensityConstraint");
        readonly int buildList, buildListDeep, buildListWithColliders, buildListDeepWithColliders, solveLambda, solveLambdaWithColliders, applyDeltaP, applyDeltaPWithPressure, applyDeltaPDeep, applyDeltaPDeepWithPressure;
        readonly LocalKeyword twoLists, sleep;

        public DensityConstraint(SolverLayout layout)
        {
            buildList = shader.FindKernel("BuildList");
            buildListDeep = shader.FindKernel("BuildListDeep");
            buildListWithColliders = shader.FindKernel("BuildListWithColliders");
            buildListDeepWithColliders = shader.FindKernel("BuildListDeepWithColliders");
            solveLambda = shader.FindKernel("SolveLambda");
            solveLambdaWithColliders = shader.FindKernel("SolveLambdaWithColliders");
            applyDeltaP = shader.FindKernel("ApplyDeltaP");
            applyDeltaPWithPressure = shader.FindKernel("ApplyDeltaPWithPressure");
            applyDeltaPDeep = shader.FindKernel("ApplyDeltaPDeep");
            applyDeltaPDeepWithPressure = shader.FindKernel("ApplyDeltaPDeepWithPressure");
            twoLists = new LocalKeyword(shader, NeighborLists.TwoListsKeyword);
            sleep = new LocalKeyword(shader, RestingRegions.Keyword);
            Lists = new NeighborLists(layout);
        }

        public NeighborLists Lists { get; }

        /// <summary>Records the list and all iterations: Predicted ends corrected; Current is used up.</summary>
        /// <param name="coarse">Adds its density correction to the first iteration; null for none.</param>
        /// <param name="colliders">Add to the density and keep the particles outside; null for none.</param>
        public void Record(CommandBuffer cmd, GraphicsBuffer constants, ParticleBuffers particles, NeighborSearch search, int iterations, bool artificialPressure, CoarseCorrection coarse, RestingRegions resting = null, Colliders colliders = null)
        {
            RecordList(cmd, constants, particles, search, coarse, resting, colliders);
            coarse?.RecordDensity(cmd, constants);
            for (int i = 0; i < iterations; i++)
            {
                if (i > 0)
                {
                    cmd.BeginSample(LambdaMarker);
                    int solve = colliders != null ? solveLambdaWithColliders : solveLambda;
                    colliders?.BindDensity(cmd, shader, solve);
                    colliders?.BindVolume(cmd, shader, solve);
                    Dispatch(cmd, solve, particles, particles.Predicted, particles.Current, resting);
                    cmd.EndSample(LambdaMarker);
                }

                cmd.BeginSample(DisplaceMarker);
                int kernel = artificialPressure ? applyDeltaPWithPressure : applyDeltaP;
                if (i == 0 && coarse != null)
                {
                    kernel = artificialPressure ? applyDeltaPDeepWithPressure : applyDeltaPDeep;
                    cmd.SetComputeBufferParam(shader, kernel, CoarseIds.Displacements, coarse.Displacements);
                }
                Dispatch(cmd, kernel, particles, particles.Current, particles.Predicted, resting);
                cmd.EndSample(DisplaceMarker);
                colliders?.RecordPass(cmd, particles, i == iterations - 1, resting);
            }
        }

        /// <summary>Records the list and the first multipliers, at Predicted, into Current; their errors into the bins of the coarse grid.</summary>
        public void RecordList(CommandBuffer cmd, GraphicsBuffer constants, ParticleBuffers particles, NeighborSearch search, CoarseCorrection coarse, RestingRegions resting = null, Colliders colliders = null)
        {
            int build = colliders == null ? coarse != null ? buildListDeep : buildList : coarse != null ? buildListDeepWithColliders : buildListWithColliders;
            cmd.BeginSample(ListMarker);
            Lists.RecordKeyword(cmd, shader, twoLists);
            RestingRegions.RecordKeyword(cmd, shader, sleep, resting);
            colliders?.BindDensity(cmd, shader, build);
            colliders?.BindVolume(cmd, shader, build);
            cmd.SetComputeConstantBufferParam(shader, SolverIds.Constants, constants, 0, constants.stride);
            if (coarse != null)
            {
                cmd.SetComputeConstantBufferParam(shader, CoarseIds.Constants, coarse.Constants, 0, coarse.Constants.stride);
                cmd.SetComputeBufferParam(shader, build, CoarseIds.Bins, coarse.Bins);
            }
            cmd.SetComputeBufferParam(shader, build, Ids.CellStarts, search.CellStarts);
            Dispatch(cmd, build, particles, particles.Predicted, particles.Current, resting);
            cmd.EndSample(ListMarker);
        }

        public void Dispose() => Lists.Dispose();

        /// <param name="deep">Whether a coarse correction runs.</param>
        /// <param name="resting">Null for none.</param>
        /// <param name="colliders">Null for none.</param>
        public StageDescription Describe(in StepInput input, bool deep, RestingRegions resting, Colliders colliders)
        {
            string variant = RestingRegions.Variant(Lists.Variant, resting);
            int substeps = input.settings.substeps, iterations = input.settings.iterations;
            string lists = Lists.TwoLists ? "two buffers, as one would be larger than this device binds" : "one buffer";
            var stage = new StageDescription("Density constraint", true, $"{iterations} iterations in each of {substeps} substeps, neighbor lists in {lists}, artificial pressure is {input.material.artificialPressure}");
            string withColliders = colliders != null ? "WithColliders" : "";
            stage.Kernel("DensityConstraint", (deep ? "BuildListDeep" : "BuildList") + withColliders, substeps, variant);
            if (iterations > 1)
                stage.Kernel("DensityConstraint", "SolveLambda" + withColliders, substeps * (iterations - 1), variant);
            string pressure = input.material.artificialPressure > 0f ? "WithPressure" : "";
            if (deep)
                stage.Kernel("DensityConstraint", "ApplyDeltaPDeep" + pressure, substeps, variant);
            if (!deep || iterations > 1)
                stage.Kernel("DensityConstraint", "ApplyDeltaP" + pressure, substeps * (deep ? iterations - 1 : iterations), variant);
            Lists.Describe(stage);
            return stage;
        }

        void Dispatch(CommandBuffer cmd, int kernel, ParticleBuffers particles, GraphicsBuffer from, GraphicsBuffer to, RestingRegions resting)
        {
            Lists.Bind(cmd, shader, kernel);
            resting?.Bind(cmd, shader, kernel);
            cmd.SetComputeBufferParam(shader, kernel, Ids.StartPositions, particles.Start);
            cmd.SetComputeBufferParam(shader, kernel, Ids.Positions, from);
            cmd.SetComputeBufferParam(shader, kernel, Ids.Corrected, to);
            cmd.SetComputeBufferParam(shader, kernel, Ids.Counters, particles.Counters);
            particles.DispatchSorted(cmd, shader, kernel);
        }

        static class Ids
        {
            public static readonly int Positions = Shader.PropertyToID("_Positions");
            public static readonly int Corrected = Shader.PropertyToID("_Corrected");
            public static readonly int StartPositions = Shader.PropertyToID("_StartPositions");
            public static readonly int CellStarts = Shader.PropertyToID("_CellStarts");
            public static readonly int Counters = Shader.PropertyToID("_Counters");
        }
    }
}
