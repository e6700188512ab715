using Rill;
using UnityEngine;

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

        public sealed override void Record(in StepContext step, StudySolver solver)
        {
            int passes = step.Input.settings.iterations;
            for (int pass = 0; pass < passes; pass++)
            {
                float relaxation = Relaxation(pass, step.Input.settings);
                if (pass == 0)
                    solver.RecordPackagePasses(step, relaxation, 1);
                else
                    RecordPass(step, solver, relaxation);
                AfterPass(step, pass, passes);
            }
        }

        protected virtual float Relaxation(int pass, in SolverSettings settings) => settings.relaxation;

        /// <summary>Predicted holds the position after the pass, Multipliers that before it.</summary>
        protected virtual void AfterPass(in StepContext step, int pass, int passes) { }

        void RecordPass(in StepContext step, StudySolver solver, float relaxation)
        {
            ParticleBuffers particles = step.Particles;
            solver.BindConstants(step, shader, relaxation);
            Dispatch(step, solveLambda, particles.Predicted, particles.Multipliers);
            step.Commands.SetComputeBufferParam(shader, applyDeltaP, Ids.StartPositions, particles.Start);
            Dispatch(step, applyDeltaP, particles.Multipliers, particles.Predicted);
        }

        void Dispatch(in StepContext step, int kernel, GraphicsBuffer from, GraphicsBuffer to)
        {
            step.Lists.Bind(step.Commands, shader, kernel);
            step.Commands.SetComputeBufferParam(shader, kernel, Ids.Positions, from);
            step.Commands.SetComputeBufferParam(shader, kernel, Ids.Corrected, to);
            StudySolver.DispatchParticles(step, shader, kernel);
        }

        static class Ids
        {
            public static readonly int Positions = Shader.PropertyToID("_Positions");
            public static readonly int StartPositions = Shader.PropertyToID("_StartPositions");
            public static readonly int Corrected = Shader.PropertyToID("_Corrected");
        }
    }
}
