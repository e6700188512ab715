using System;
using System.Collections.Generic;
using Host.Experiments;
using Rill;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Host.Studies.Methods
{
    /// <summary>
    /// The package's stages in the order of <see cref="PbfSolver.Step"/> with another method for the passes and other
    /// parameters of the two-level correction. With <see cref="Jacobi"/> and none it is the package's solver bit for bit.
    /// </summary>
    sealed class StudySolver : IExperimentSolver
    {
        readonly StepInput input;
        readonly ConstraintMethod method;
        readonly CoarseVariation variation;
        readonly DensityConstraint constraint;
        readonly VelocityUpdate velocityUpdate = new();
        readonly ParticleUpload particleUpload = new();
        readonly StatisticsPass statistics;
        readonly ComputeShader displacements = StudyShader.Load("Displacements");
        readonly GraphicsBuffer constants;
        readonly Dictionary<float, GraphicsBuffer> constantsByRelaxation = new();
        uint stepIndex;

        /// <param name="input">Of every step; deep water On or Off, vorticity and artificial pressure 0.</param>
        /// <param name="method">The solver's from now on.</param>
        public StudySolver(SolverLayout layout, in StepInput input, ConstraintMethod method, CoarseVariation variation = null)
        {
            if (input.settings.deepWater == DeepWater.Automatic || input.material.vorticity > 0f || input.material.shearModulus > 0f
                || input.material.artificialPressure > 0f)
                throw new ArgumentException("The study's solver takes deep water On or Off, no vorticity, no elasticity and no artificial pressure.");
            Layout = layout;
            this.input = input;
            this.method = method;
            this.variation = variation ?? new CoarseVariation();
            Particles = new ParticleBuffers(layout.Capacity);
            Search = new NeighborSearch(layout);
            constraint = new DensityConstraint(layout);
            statistics = new StatisticsPass(layout.Capacity);
            constants = GpuBuffer.Constants<SolverConstants>("Study.Constants");
            if (input.settings.deepWater == DeepWater.On)
                Coarse = this.variation.Create(layout, input);
            using var cmd = new CommandBuffer { name = "Study.Clear" };
            particleUpload.Clear(cmd, Particles);
            Graphics.ExecuteCommandBuffer(cmd);
        }

        public SolverLayout Layout { get; }
        public ParticleBuffers Particles { get; }
        public NeighborSearch Search { get; }
        public NeighborLists Lists => constraint.Lists;
        /// <summary>Null without deep water.</summary>
        public CoarseCorrection Coarse { get; }

        public void Add(NativeArray<float4> positions, NativeArray<float4> velocities)
        {
            using NativeArray<float4> scaledPositions = InSpacings(positions);
            using NativeArray<float4> scaledVelocities = InSpacings(velocities);
            particleUpload.Append(Particles, Layout.Capacity, scaledPositions, scaledVelocities);
            particleUpload.Trim();
        }

        public void Step(CommandBuffer cmd)
        {
            stepIndex++;
            UploadConstants(cmd);
            StepContext step = Context(cmd, input, constants);
            for (int substep = 0; substep < input.settings.substeps; substep++)
            {
                if (Coarse != null)
                    variation.RecordStart(cmd, Coarse);
                Coarse?.RecordProjection(step);
                Search.RecordSort(step, takesProjection: Coarse != null);
                method.Record(cmd, this, input);
                if (!method.EndsInPackagePass)
                    RecordDisplacements(cmd);
                velocityUpdate.Record(step);
                Particles.Advance();
            }
        }

        /// <summary>Records the neighbor list, the density correction and so many of the package's own passes.</summary>
        public void RecordPackagePasses(CommandBuffer cmd, float relaxation, int passes)
        {
            StepInput other = input;
            other.settings.iterations = passes;
            constraint.Record(Context(cmd, other, ConstantsFor(relaxation)));
        }

        StepContext Context(CommandBuffer cmd, in StepInput input, GraphicsBuffer constants)
            => new StepContext(cmd, constants, Particles, Search, Lists, Layout, input, Coarse);

        /// <summary>Records the step's constants, with another relaxation, as what a shader reads.</summary>
        public void BindConstants(CommandBuffer cmd, ComputeShader shader, float relaxation) =>
            cmd.SetComputeConstantBufferParam(shader, SolverIds.Constants, ConstantsFor(relaxation), 0, constants.stride);

        public void BindConstants(CommandBuffer cmd, ComputeShader shader) => BindConstants(cmd, shader, input.settings.relaxation);

        /// <summary>Records a kernel over the particles of this substep.</summary>
        public void DispatchParticles(CommandBuffer cmd, ComputeShader shader, int kernel)
        {
            cmd.SetComputeBufferParam(shader, kernel, Ids.Counters, Particles.Counters);
            cmd.DispatchCompute(shader, kernel, Particles.SortedArguments, GpuBuffer.DispatchArgumentsAt);
        }

        // What the package's last pass leaves for the viscosity.
        void RecordDisplacements(CommandBuffer cmd)
        {
            int kernel = displacements.FindKernel("PackDisplacements");
            BindConstants(cmd, displacements);
            cmd.SetComputeBufferParam(displacements, kernel, "_StartPositions", Particles.Start);
            cmd.SetComputeBufferParam(displacements, kernel, "_Corrected", Particles.Predicted);
            DispatchParticles(cmd, displacements, kernel);
        }

        public void RecordStatistics(CommandBuffer cmd)
        {
            UploadConstants(cmd);
            statistics.Record(Context(cmd, input, constants));
        }

        public FluidStatistics FetchStatistics()
        {
            statistics.Request();
            AsyncGPUReadback.WaitAllRequests();
            return FluidStatistics.From(statistics.Latest, Layout, input.material.density, input.gravity, input.timeStep);
        }

        public long Bytes => 0;     // memory is not what the study compares

        public void Dispose()
        {
            method.Dispose();
            Particles.Dispose();
            Search.Dispose();
            constraint.Dispose();
            particleUpload.Dispose();
            statistics.Dispose();
            Coarse?.Dispose();
            constants.Release();
            foreach (GraphicsBuffer buffer in constantsByRelaxation.Values)
                buffer.Release();
        }

        // Those of another relaxation are made once: nothing else in them changes that a pass reads.
        GraphicsBuffer ConstantsFor(float relaxation)
        {
            if (relaxation == input.settings.relaxation)
                return constants;
            if (!constantsByRelaxation.TryGetValue(relaxation, out GraphicsBuffer buffer))
            {
                SolverConstants values = Constants();
                values.relaxation = relaxation;
                constantsByRelaxation.Add(relaxation, buffer = GpuBuffer.Constants<SolverConstants>("Study.ScheduledConstants"));
                buffer.SetData(new[] { values });
            }
            return buffer;
        }

        SolverConstants Constants() => SolverConstants.For(Layout, input, stepIndex);

        void UploadConstants(CommandBuffer cmd) => cmd.SetBufferData(constants, new[] { Constants() });

        NativeArray<float4> InSpacings(NativeArray<float4> metres)
        {
            var scaled = new NativeArray<float4>(metres.Length, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
            for (int i = 0; i < metres.Length; i++)
                scaled[i] = metres[i] / Layout.Spacing;
            return scaled;
        }

        static class Ids
        {
            public static readonly int Counters = Shader.PropertyToID("_Counters");
        }
    }
}
