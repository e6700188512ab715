using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using Rill;

namespace Host.Studies.Methods
{
    /// <summary>Jacobi passes whose motion is carried on: the kernels of Momentum.compute and an earlier iterate.</summary>
    abstract class MomentumMethod : PassByPass
    {
        readonly ComputeShader shader = StudyShader.Load("Momentum");
        GraphicsBuffer previous;

        public override void Dispose() => GpuBuffer.Release(ref previous);

        protected void RecordKernel(in StepContext step, string name, double weight)
        {
            previous ??= GpuBuffer.Structured<float4>("Study.Previous", step.Layout.Capacity);
            int kernel = shader.FindKernel(name);
            CommandBuffer cmd = step.Commands;
            step.BindConstants(shader);
            cmd.SetComputeFloatParam(shader, "_Weight", (float)weight);
            cmd.SetComputeBufferParam(shader, kernel, "_From", step.Particles.Multipliers);
            cmd.SetComputeBufferParam(shader, kernel, "_Previous", previous);
            cmd.SetComputeBufferParam(shader, kernel, "_Corrected", step.Particles.Predicted);
            StudySolver.DispatchParticles(step, shader, kernel);
        }
    }
}
