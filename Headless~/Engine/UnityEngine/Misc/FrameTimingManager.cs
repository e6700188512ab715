using System;
using System.Diagnostics;
using UnityEngine.Headless;

namespace UnityEngine
{
    public struct FrameTiming
    {
        public ulong cpuTimePresentCalled;
        public double cpuFrameTime;
        public double cpuMainThreadFrameTime;
        public double cpuMainThreadPresentWaitTime;
        public double cpuRenderThreadFrameTime;
        public ulong cpuTimeFrameComplete;
        public double gpuFrameTime;
        public float heightScale;
        public float widthScale;
        public uint syncInterval;
        public ulong frameStartTimestamp;
        public ulong firstSubmitTimestamp;
    }

    /// <summary>Times of whole frames, four frames late as Unity has it. What the host does not know is 0.</summary>
    public static class FrameTimingManager
    {
        public static bool IsFeatureEnabled() => FrameTimes.Supported;
        public static void CaptureFrameTimings() => FrameTimes.Capture();

        /// <summary>Newest first.</summary>
        /// <returns>How many there are.</returns>
        public static uint GetLatestTimings(uint numFrames, FrameTiming[] timings)
            => FrameTimes.Latest(Math.Min(numFrames, (uint)timings.Length), timings);

        public static ulong GetCpuTimerFrequency() => (ulong)Stopwatch.Frequency;
        public static ulong GetGpuTimerFrequency() => 0;
        public static float GetVSyncsPerSecond() => 0;
    }
}
