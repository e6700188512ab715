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

        /// <param name="share">That equation's ω.</param>
        public NeighborMean(float fraction) => this.fraction = fraction;

        protected override void AfterPass(CommandBuffer cmd, StudySolver solver, int pass, int passes)
        {
            ParticleBuffers particles = solver.Particles;
            int kernel = shader.FindKernel("Average");
            solver.BindConstants(cmd, shader);
            solver.Lists.Bind(cmd, shader, kernel);
            cmd.SetComputeFloatParam(shader, "_Share", fraction);
            cmd.SetComputeBufferParam(shader, kernel, "_Corrected", particles.Predicted);
            cmd.SetComputeBufferParam(shader, kernel, "_Averaged", particles.Current);
            solver.DispatchParticles(cmd, shader, kernel);
            (particles.Current, particles.Predicted) = (particles.Predicted, particles.Current);
        }
    }
}
