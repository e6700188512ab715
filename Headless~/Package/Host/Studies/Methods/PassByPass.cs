using Rill;
using UnityEngine;
using UnityEngine.Rendering;

namespace Host.Studies.Methods
{
    /// <summary>The package's Jacobi passes one by one, each with a relaxation of its own and something to follow it.</summary>
    abstract class PassByPass : ConstraintMethod
    {
        readonly ComputeShader shader = StageShader.LoadCompute("DensityConstraint");
        readonly int solveLambda, applyDeltaP;

        protected PassByPass()
        {
            solveLambda = shader.FindKernel("SolveLambda");
            applyDeltaP = shader.FindKernel("ApplyDeltaP");
        }

        public sealed override void Record(CommandBuffer cmd, StudySolver solver, in StepInput input)
        {
            for (int pass = 0; pass < input.settings.iterations; pass++)
            {
                float relaxation = Relaxation(pass, input.settings);
                if (pass == 0)
                    solver.RecordPackagePasses(cmd, relaxation, 1);
                else
                    RecordPass(cmd, solver, relaxation);
                AfterPass(cmd, solver, pass, input.settings.iterations);
            }
        }

        protected virtual float Relaxation(int pass, in SolverSettings settings) => settings.relaxation;

        /// <summary>Predicted holds the position after the pass, Current that before it.</summary>
        protected virtual void AfterPass(CommandBuffer cmd, StudySolver solver, int pass, int passes) { }

        void RecordPass(CommandBuffer cmd, StudySolver solver, float relaxation)
        {
            ParticleBuffers particles = solver.Particles;
            solver.BindConstants(cmd, shader, relaxation);
            Dispatch(cmd, solver, solveLambda, particles.Predicted, particles.Current);
            cmd.SetComputeBufferParam(shader, applyDeltaP, Ids.StartPositions, particles.Start);
            Dispatch(cmd, solver, applyDeltaP, particles.Current, particles.Predicted);
        }

        void Dispatch(CommandBuffer cmd, StudySolver solver, int kernel, GraphicsBuffer from, GraphicsBuffer to)
        {
            solver.Lists.Bind(cmd, shader, kernel);
            cmd.SetComputeBufferParam(shader, kernel, Ids.Positions, from);
            cmd.SetComputeBufferParam(shader, kernel, Ids.Corrected, to);
            solver.DispatchParticles(cmd, shader, kernel);
        }

        static class Ids
        {
            public static readonly int Positions = Shader.PropertyToID("_Positions");
            public static readonly int StartPositions = Shader.PropertyToID("_StartPositions");
            public static readonly int Corrected = Shader.PropertyToID("_Corrected");
        }
    }
}
