using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>
    /// The cost model, scaled so that it explains how the whole frame's GPU time goes along with the fluid's work. All that the
    /// frame spends besides does not matter as long as it does not change with that work.
    /// </summary>
    /// <remarks>
    /// The slope of a regression that forgets, drawn towards the device factor that the user gave; without one, towards the frame's
    /// time as a whole, which is the most that the fluid can take. FrameTimingManager is always on in development players; in others
    /// the player setting Frame Timing Stats turns it on.
    /// </remarks>
    sealed class FrameGpuTime : IGpuTimeSource
    {
        /// <summary>Documented of FrameTimingManager.</summary>
        const int FramesLate = 4;
        const float MemorySeconds = 3f;
        const float LostSeconds = 1f;
        /// <summary>Weight of what was believed before, as the relative variance of the work that outweighs it.</summary>
        const double Belief = 0.01;

        readonly FrameTiming[] newest = new FrameTiming[1];
        double weight, work, time, workSquared, workTime;
        float sinceReading = LostSeconds;

        /// <summary>Time of a step on this device over the model's, as the user knows it; 0 for unknown.</summary>
        public float DeviceFactor { get; set; }

        public GpuTimeKind Kind => DeviceFactor > 0f || sinceReading < LostSeconds && weight > 0.0 ? GpuTimeKind.Modeled : GpuTimeKind.None;

        public void BeginStep(CommandBuffer commands) { }
        public void EndStep(CommandBuffer commands) { }

        public StepTime Read(float seconds, WorkHistory history)
        {
            FrameTimingManager.CaptureFrameTimings();
            double frame = FrameTimingManager.GetLatestTimings(1, newest) > 0 ? newest[0].gpuFrameTime : 0.0;
            return Read(seconds, history, frame);
        }

        /// <param name="frameMilliseconds">GPU time of the whole frame four frames ago; 0 for unknown.</param>
        internal StepTime Read(float seconds, WorkHistory history, double frameMilliseconds)
        {
            sinceReading += seconds;
            float modeled = history.StepCost(FramesLate);
            if (frameMilliseconds > 0.0 && modeled > 0f)
            {
                sinceReading = 0f;
                Add(history.Steps(FramesLate) * modeled, frameMilliseconds, Math.Exp(-seconds / MemorySeconds));
            }
            // The model says it for the work of now; nothing has to be waited for.
            float current = history.StepCost(1);
            return Kind == GpuTimeKind.Modeled && current > 0f ? new StepTime((float)Slope() * current, current) : default;
        }

        public void Dispose() { }

        void Add(double frameWork, double milliseconds, double keep)
        {
            weight = weight * keep + 1.0;
            work = work * keep + frameWork;
            time = time * keep + milliseconds;
            workSquared = workSquared * keep + frameWork * frameWork;
            workTime = workTime * keep + frameWork * milliseconds;
        }

        double Slope()
        {
            if (weight <= 0.0 || work <= 0.0)
                return DeviceFactor;
            double most = time / work;
            double believed = DeviceFactor > 0f ? Math.Min(DeviceFactor, most) : most;
            double prior = Belief * work * work / weight;
            double slope = (workTime - work * time / weight + prior * believed) / (workSquared - work * work / weight + prior);
            return Math.Min(Math.Max(slope, 0.05 * believed), most);
        }
    }
}
