using System;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>GPU time of a simulation's steps, some frames late.</summary>
    interface IGpuTimeSource : IDisposable
    {
        /// <summary>Kind of the newest readings; None while there are none.</summary>
        GpuTimeKind Kind { get; }

        /// <summary>Around the commands of a step.</summary>
        void BeginStep(CommandBuffer commands);
        void EndStep(CommandBuffer commands);

        /// <summary>Once a frame, before its steps.</summary>
        /// <param name="seconds">Since the last call, s.</param>
        /// <param name="work">What earlier frames recorded, by the cost model.</param>
        StepTime Read(float seconds, WorkHistory work);
    }

    /// <summary>One step's time and what the cost model says of it, ms; 0 where it is not known.</summary>
    readonly struct StepTime
    {
        public readonly float Milliseconds, Modeled;

        public StepTime(float milliseconds, float modeled)
        {
            Milliseconds = milliseconds;
            Modeled = modeled;
        }
    }
}
