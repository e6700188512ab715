using System;
using System.Collections.Generic;
using Rill;
using UnityEngine;
using UnityEngine.Rendering;

namespace Host.Studies.Methods
{
    /// <summary>
    /// The package's solver with another method for the passes and other parameters of the two-level correction. With
    /// <see cref="Jacobi"/> and none it is the package's bit for bit.
    /// </summary>
    sealed class StudySolver : PbfSolver
    {
        readonly ConstraintMethod method;
        readonly CoarseVariation variation;
        readonly ComputeShader displacements = StudyShader.Load("Displacements");
        readonly Dictionary<float, GraphicsBuffer> constantsByRelaxation = new();

        /// <param name="method">The solver's from now on.</param>
        public StudySolver(SolverLayout layout, ConstraintMethod method, CoarseVariation variation = null) : base(layout)
        {
            this.method = method;
            this.variation = variation ?? new CoarseVariation();
        }

        protected override float CoarseCellSize(in StepInput input) => variation.CellSize > 0 ? variation.CellSize : base.CoarseCellSize(input);

        protected override CoarseCorrection MakeCoarse(float cellSize)
        {
            CoarseCorrection coarse = base.MakeCoarse(cellSize);
            variation.Apply(coarse);
            return coarse;
        }

        protected override void RecordCorrection(in StepContext step)
        {
            if (step.Colliders != null || step.Input.material.artificialPressure > 0f)
                throw new ArgumentException("The methods of the study know no colliders and no artificial pressure: take them out of the scene.");
            method.Record(step, this);
            if (step.Coarse != null)
                variation.RecordEnd(step);
            if (!method.EndsInPackagePass)
                RecordDisplacements(step);
        }

        /// <summary>Records the neighbor list, the density correction and so many of the package's own passes.</summary>
        public void RecordPackagePasses(in StepContext step, float relaxation, int passes)
        {
            StepInput input = step.Input;
            input.settings.iterations = passes;
            base.RecordCorrection(new StepContext(step.Commands, ConstantsFor(step, relaxation), step.Particles, step.Search, step.Lists, Layout,
                input, step.Coarse));
        }

        /// <summary>Records the step's constants, with another relaxation, as what a shader reads.</summary>
        public void BindConstants(in StepContext step, ComputeShader shader, float relaxation) =>
            step.Commands.SetComputeConstantBufferParam(shader, SolverIds.Constants, ConstantsFor(step, relaxation), 0, step.Constants.stride);

        /// <summary>Records a kernel over the particles of this substep.</summary>
        public static void DispatchParticles(in StepContext step, ComputeShader shader, int kernel)
        {
            step.Commands.SetComputeBufferParam(shader, kernel, Ids.Counters, step.Particles.Counters);
            step.Commands.DispatchCompute(shader, kernel, step.Particles.SortedArguments, GpuBuffer.DispatchArgumentsAt);
        }

        public override void Dispose()
        {
            base.Dispose();
            method.Dispose();
            foreach (GraphicsBuffer buffer in constantsByRelaxation.Values)
                buffer.Release();
        }

        // What the package's last pass leaves for the viscosity.
        void RecordDisplacements(in StepContext step)
        {
            int kernel = displacements.FindKernel("PackDisplacements");
            step.BindConstants(displacements);
            step.Commands.SetComputeBufferParam(displacements, kernel, "_StartPositions", step.Particles.Start);
            step.Commands.SetComputeBufferParam(displacements, kernel, "_Corrected", step.Particles.Predicted);
            DispatchParticles(step, displacements, kernel);
        }

        // Those of another relaxation are made once: nothing else in them changes that a pass reads.
        GraphicsBuffer ConstantsFor(in StepContext step, float relaxation)
        {
            if (relaxation == step.Input.settings.relaxation)
                return step.Constants;
            if (!constantsByRelaxation.TryGetValue(relaxation, out GraphicsBuffer buffer))
            {
                SolverConstants values = SolverConstants.For(Layout, step.Input, 0);
                values.relaxation = relaxation;
                constantsByRelaxation.Add(relaxation, buffer = GpuBuffer.Constants<SolverConstants>("Study.ScheduledConstants"));
                buffer.SetData(new[] { values });
            }
            return buffer;
        }

        static class Ids
        {
            public static readonly int Counters = Shader.PropertyToID("_Counters");
        }
    }
}
