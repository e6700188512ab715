using System;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Vorticity confinement (Macklin and Müller 2013, eq. 15-16) with XSPH in its last pass. Made when first needed.</summary>
    sealed class VorticityConfinement : Stage
    {
        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Vorticity");

        readonly ComputeShader shader = StageShader.LoadCompute("VorticityConfinement");
        readonly Kernel curlKernel;
        readonly KernelVariants confineKernel;        // with colliders
        readonly StepKeywords keywords;
        readonly GraphicsBuffer curl, unconfined;

        public VorticityConfinement(int capacity)
        {
            curlKernel = new Kernel(shader, "Curl");
            confineKernel = new KernelVariants(shader, "Confine", "ConfineWithColliders");
            keywords = new StepKeywords(shader, readsLists: true, skipsAsleep: false);
            curl = Buffers.Structured<float4>("Rill.Curl", capacity);
            unconfined = Buffers.Structured<float4>("Rill.Unconfined", capacity, "_Velocities");
        }

        /// <summary>float4 [capacity], xyz vorticity, 1/s; w its magnitude.</summary>
        public GraphicsBuffer Curl => curl;

        /// <summary>float4 [capacity], xyz velocity before the confinement, d/s: the stages before this one write it, see
        /// <see cref="StepContext.NewVelocities"/>.</summary>
        public GraphicsBuffer Unconfined => unconfined;

        public static bool IsNeeded(in StepInput input) => input.material.vorticity > 0f;

        /// <summary>Records both passes, from the unconfined velocities to the particles'.</summary>
        public void Record(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            cmd.BeginSample(Marker);
            keywords.Record(step);
            step.BindConstants(shader);
            Dispatch(step, curlKernel);
            int confine = confineKernel.For(step.Colliders != null);
            step.Colliders?.Bind(cmd, shader, confine);
            cmd.SetComputeBufferParam(shader, confine, Ids.Confined, step.Particles.Velocities);
            Dispatch(step, confine);
            cmd.EndSample(Marker);
        }

        /// <param name="stage">The stage, or null where none was made.</param>
        public static StageDescription Describe(VorticityConfinement stage, in StepContext step)
        {
            bool needed = IsNeeded(step.Input);
            var description = new StageDescription("Vorticity confinement", needed, "vorticity is " +
                Invariant($"{step.Input.material.vorticity} m/s"));
            if (needed && stage != null)
            {
                description.Kernel(stage.curlKernel, step.Substeps, stage.keywords.Variant(step));
                description.Kernel(stage.confineKernel.For(step.Colliders != null), step.Substeps, stage.keywords.Variant(step));
            }
            if (stage != null)
            {
                stage.Buffers.Describe(description);
            }
            return description;
        }

        void Dispatch(in StepContext step, int kernel)
        {
            CommandBuffer cmd = step.Commands;
            step.Lists.Bind(cmd, shader, kernel);
            Buffers.Bind(cmd, shader, kernel);
            Ids.Particles.Bind(cmd, shader, kernel, step.Particles.Predicted, step.Particles.Counters);
            cmd.DispatchCompute(shader, kernel, step.Particles.SortedArguments, GpuBuffer.DispatchArgumentsAt);
        }

        static class Ids
        {
            public static readonly ShaderParameters Particles = new ShaderParameters("_Positions", "_Counters");
            public static readonly int Confined = Shader.PropertyToID("_Confined");
        }
    }
}
