using System;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Jacobi iterations of the density constraint (Macklin and Müller 2013, algorithm 1, lines 5-19).</summary>
    sealed class DensityConstraint : IDisposable
    {
        static readonly ProfilerMarker ListMarker = GpuMarker.Create("Rill.List");
        static readonly ProfilerMarker LambdaMarker = GpuMarker.Create("Rill.Lambda");
        static readonly ProfilerMarker DisplaceMarker = GpuMarker.Create("Rill.ApplyDeltaP");

        readonly ComputeShader shader = StageShader.LoadCompute("DensityConstraint");
        readonly KernelVariants buildList, solveLambda;                 // deep, with colliders; with colliders
        readonly KernelVariants applyDeltaP, applyDeltaPWithTension;    // deep, with artificial pressure; deep
        readonly StepKeywords keywords;

        public DensityConstraint(SolverLayout layout)
        {
            buildList = new KernelVariants(shader, "BuildList", "BuildListDeep", "BuildListWithColliders", "BuildListDeepWithColliders");
            solveLambda = new KernelVariants(shader, "SolveLambda", "SolveLambdaWithColliders");
            applyDeltaP = new KernelVariants(shader, "ApplyDeltaP", "ApplyDeltaPDeep", "ApplyDeltaPWithPressure", "ApplyDeltaPDeepWithPressure");
            applyDeltaPWithTension = new KernelVariants(shader, "ApplyDeltaPWithTension", "ApplyDeltaPDeepWithTension");
            keywords = new StepKeywords(shader, readsLists: true, skipsAsleep: true, weighs: true);
            Lists = new NeighborLists(layout);
        }

        public NeighborLists Lists { get; }

        /// <summary>Records the list and all iterations: Predicted ends corrected. The coarse grid's density correction
        /// joins the first.</summary>
        public void Record(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            ParticleBuffers particles = step.Particles;
            int iterations = step.Input.settings.iterations;
            if (SurfaceTension.IsNeeded(step.Input))
                SurfaceTension.Bind(step, shader);
            RecordList(step);
            step.Coarse?.RecordDensity(step);
            for (int i = 0; i < iterations; i++)
            {
                if (i > 0)
                {
                    cmd.BeginSample(LambdaMarker);
                    int solve = solveLambda.For(step.Colliders != null);
                    step.Colliders?.Bind(cmd, shader, solve);
                    Dispatch(step, solve, particles.Predicted, particles.Multipliers);
                    cmd.EndSample(LambdaMarker);
                }

                cmd.BeginSample(DisplaceMarker);
                bool takesCorrection = i == 0 && step.Coarse != null;
                Kernel kernel = ApplyDeltaP(step.Input, takesCorrection);
                if (takesCorrection)
                    cmd.SetComputeBufferParam(shader, kernel, CoarseIds.Displacements, step.Coarse.Displacements);
                Dispatch(step, kernel, particles.Multipliers, particles.Predicted);
                cmd.EndSample(DisplaceMarker);
                step.Colliders?.RecordPass(step, i == iterations - 1);
            }
        }

        /// <summary>Records the list and the first multipliers, at Predicted, into Multipliers; their errors into the bins of the coarse
        /// grid.</summary>
        public void RecordList(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            int build = buildList.For(step.Coarse != null, step.Colliders != null);
            cmd.BeginSample(ListMarker);
            keywords.Record(step);
            step.Colliders?.Bind(cmd, shader, build);
            step.BindConstants(shader);
            if (step.Coarse != null)
                step.BindCoarseConstants(shader);
            Ids.Build.Bind(cmd, shader, build, step.Search.CellStarts, step.Coarse?.Bins);
            Dispatch(step, build, step.Particles.Predicted, step.Particles.Multipliers);
            cmd.EndSample(ListMarker);
        }

        public void Dispose() => Lists.Dispose();

        public StageDescription Describe(in StepContext step)
        {
            bool deep = step.Coarse != null, withColliders = step.Colliders != null;
            string variant = keywords.Variant(step);
            int substeps = step.Substeps, iterations = step.Input.settings.iterations;
            string lists = Lists.TwoLists ? "two buffers, as one would be larger than this device binds" : "one buffer";
            var stage = new StageDescription("Density constraint", true, Invariant($"{iterations} iterations in each of {substeps} ") +
                Invariant($"substeps, neighbor lists in {lists}, artificial pressure is {ArtificialPressure(step.Input)}, ") +
                SurfaceTension.Describe(step));
            stage.Kernel(buildList.For(deep, withColliders), substeps, variant);
            if (Contacts.IsNeeded(step.Input))
            {
                Lists.Describe(stage);
                return stage;
            }
            if (iterations > 1)
                stage.Kernel(solveLambda.For(withColliders), substeps * (iterations - 1), variant);
            if (deep)
                stage.Kernel(ApplyDeltaP(step.Input, true), substeps, variant);
            if (!deep || iterations > 1)
                stage.Kernel(ApplyDeltaP(step.Input, false), substeps * (deep ? iterations - 1 : iterations), variant);
            Lists.Describe(stage);
            return stage;
        }

        Kernel ApplyDeltaP(in StepInput input, bool takesCorrection)
            => SurfaceTension.IsNeeded(input) ? applyDeltaPWithTension.For(takesCorrection)
                : applyDeltaP.For(takesCorrection, ArtificialPressure(input) > 0f);

        static float ArtificialPressure(in StepInput input) => SurfaceTension.IsNeeded(input) ? 0f : input.material.artificialPressure;

        void Dispatch(in StepContext step, int kernel, GraphicsBuffer from, GraphicsBuffer to)
        {
            CommandBuffer cmd = step.Commands;
            step.BindLists(shader, kernel);
            step.Materials?.Bind(step, shader, kernel);
            step.Particles.Bind(cmd, shader, kernel);
            ParticleIds.Pass.Bind(cmd, shader, kernel, from, to);
            step.Particles.DispatchSorted(cmd, shader, kernel);
        }

        static class Ids
        {
            public static readonly ShaderParameters Build = new ShaderParameters("_CellStarts", "_Bins");
        }
    }
}
