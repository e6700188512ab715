using Rill;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Host.Studies.Methods
{
    /// <summary>Colored Gauss-Seidel: blocks of grid cells in colors, color after color within an iteration, in place.</summary>
    sealed class GaussSeidel : ConstraintMethod
    {
        readonly ComputeShader shader = StudyShader.Load("GaussSeidel");
        readonly int sweep, push, stride;

        /// <param name="byConstraint">A constraint moves its neighbors too, in 27 colors; else each particle itself, in 8.</param>
        public GaussSeidel(bool byConstraint)
        {
            sweep = shader.FindKernel(byConstraint ? "SweepConstraints" : "SweepParticles");
            push = shader.FindKernel("Push");
            stride = byConstraint ? 3 : 2;
        }

        /// <summary>Blocks from one of a color to the next along an axis.</summary>
        public int Stride => stride;

        public override void Record(in StepContext step, StudySolver solver)
        {
            CommandBuffer cmd = step.Commands;
            SolverSettings settings = step.Input.settings;
            solver.RecordPackagePasses(step, settings.relaxation, 0);      // the list and first multipliers
            step.BindConstants(shader);
            step.Lists.Bind(cmd, shader, sweep);
            cmd.SetComputeBufferParam(shader, sweep, Ids.Positions, step.Particles.Multipliers);
            cmd.SetComputeBufferParam(shader, sweep, Ids.CellStarts, step.Search.CellStarts);
            cmd.SetComputeIntParam(shader, Ids.Stride, stride);
            int3 perBlock = step.Layout.CellsPerRadius;       // a block is a list radius wide
            cmd.SetComputeIntParams(shader, Ids.BlockCells, perBlock.x, perBlock.y, perBlock.z);
            if (step.Coarse != null)
                RecordPush(step);

            int3 blocks = (step.Layout.CellCounts + perBlock - 1) / perBlock;
            int3 ofColor = (blocks + stride - 1) / stride;
            for (int iteration = 0; iteration < settings.iterations; iteration++)
                for (int color = 0; color < stride * stride * stride; color++)
                {
                    cmd.SetComputeIntParam(shader, Ids.Color, color);
                    CoarseGrid.Dispatch(cmd, shader, sweep, ofColor.x * ofColor.y * ofColor.z);
                }
            step.Particles.SwapPasses();
        }

        void RecordPush(in StepContext step)
        {
            step.BindCoarseConstants(shader);
            step.Commands.SetComputeBufferParam(shader, push, Ids.Positions, step.Particles.Multipliers);
            step.Commands.SetComputeBufferParam(shader, push, CoarseIds.Displacements, step.Coarse.Displacements);
            StudySolver.DispatchParticles(step, shader, push);
        }

        static class Ids
        {
            public static readonly int Positions = Shader.PropertyToID("_Positions");
            public static readonly int CellStarts = Shader.PropertyToID("_CellStarts");
            public static readonly int Color = Shader.PropertyToID("_Color");
            public static readonly int Stride = Shader.PropertyToID("_Stride");
            public static readonly int BlockCells = Shader.PropertyToID("_BlockCells");
        }
    }
}
