using System;
using Rill;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine.Rendering;

namespace Host.Experiments
{
    /// <summary>Solver that an experiment plays with one input: the package's, or one that differs from it.</summary>
    interface IExperimentSolver : IDisposable
    {
        /// <param name="positions">xyz, m; <paramref name="velocities"/> m/s.</param>
        void Add(NativeArray<float4> positions, NativeArray<float4> velocities);

        void Step(CommandBuffer cmd);

        void RecordStatistics(CommandBuffer cmd);

        /// <summary>Fetches what was recorded, waiting for the device.</summary>
        FluidStatistics FetchStatistics();

        /// <summary>Size of all buffers.</summary>
        long Bytes { get; }
    }
}
