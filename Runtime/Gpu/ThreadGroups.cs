using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Limits and helpers for the thread groups of every dispatch.</summary>
    static class ThreadGroups
    {
        /// <summary>of a dispatch, along each axis; more fold into y</summary>
        [GenerateHlsl("ThreadGroups")] public const int MaxGroups = 65535;

        /// <summary>Records a kernel for so many groups, folded into two dimensions: ParticleIndex of Solver.hlsl numbers its threads.</summary>
        /// <param name="groups">At least 1, at most <see cref="MaxGroups"/> squared.</param>
        public static void Dispatch(CommandBuffer cmd, ComputeShader shader, int kernel, long groups)
            => cmd.DispatchCompute(shader, kernel, (int)Math.Min(groups, MaxGroups), (int)((groups + MaxGroups - 1) / MaxGroups), 1);
    }
}
