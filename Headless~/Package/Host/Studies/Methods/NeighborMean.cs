using Rill;
using UnityEngine;
using UnityEngine.Rendering;

namespace Host.Studies.Methods
{
    /// <summary>After each Jacobi pass, p* ← (1 − ω) p* + ω · mean of the neighbors' p* (Svensson 2016, eq. 4.14).</summary>
    sealed class NeighborMean : PassByPass
    {
        readonly ComputeShader shader = StudyShader.Load("NeighborMean");
        readonly float fraction;

        /// <param name="fraction">That equation's ω.</param>
        public NeighborMean(float fraction) => this.fraction = fraction;

        protected override void AfterPass(in StepContext step, int pass, int passes)
        {
            CommandBuffer cmd = step.Commands;
            int kernel = shader.FindKernel("Average");
            step.BindConstants(shader);
            step.Lists.Bind(cmd, shader, kernel);
            cmd.SetComputeFloatParam(shader, "_Fraction", fraction);
            cmd.SetComputeBufferParam(shader, kernel, "_Corrected", step.Particles.Predicted);
            cmd.SetComputeBufferParam(shader, kernel, "_Averaged", step.Particles.Multipliers);
            StudySolver.DispatchParticles(step, shader, kernel);
            step.Particles.SwapPasses();
        }
    }
}
