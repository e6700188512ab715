using System;
using System.Linq;
using Rill;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine.Rendering;

namespace Host.Experiments
{
    /// <summary>The package's solver with one input for all steps.</summary>
    sealed class PackageSolver : IDisposable
    {
        readonly StepInput input;

        public PackageSolver(SolverLayout layout, in StepInput input)
        {
            this.input = input;
            Solver = new PbfSolver(layout);
        }

        public PbfSolver Solver { get; }

        /// <param name="positions">xyz, m; <paramref name="velocities"/> m/s.</param>
        public void Add(NativeArray<float4> positions, NativeArray<float4> velocities) => Solver.Add(positions, velocities);

        public void Step(CommandBuffer cmd) => Solver.Step(cmd, input);

        public void RecordStatistics(CommandBuffer cmd) => Solver.RecordStatistics(cmd, input);

        /// <summary>Fetches what was recorded, waiting for the device.</summary>
        public FluidStatistics FetchStatistics()
        {
            Solver.RequestStatistics();
            AsyncGPUReadback.WaitAllRequests();
            Solver.TryGetStatistics(input, out FluidStatistics statistics);
            return statistics;
        }

        /// <summary>The particles alive, d.</summary>
        public float3[] ReadPositions(int alive)
        {
            var positions = new float4[alive];
            Solver.Positions.GetData(positions, 0, 0, alive);
            return positions.Select(p => p.xyz).ToArray();
        }

        public long Bytes => Solver.Describe(input, 0).Sum(stage => stage.Bytes);

        public void Dispose() => Solver.Dispose();
    }
}
