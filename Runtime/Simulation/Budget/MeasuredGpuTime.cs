using UnityEngine;
using UnityEngine.Profiling;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>
    /// Time stamps around each step, by a recorder of Unity's profiler: in the Editor and in development players, on devices
    /// with SystemInfo.supportsGpuRecorder. Elsewhere it stays silent.
    /// </summary>
    sealed class MeasuredGpuTime : IGpuTimeSource
    {
        /// <summary>Documented of Recorder.gpuElapsedNanoseconds.</summary>
        const int FramesLate = 3;
        const float MillisecondsOfNanosecond = 1e-6f;

        readonly int slot;
        readonly CustomSampler sampler;
        readonly Recorder recorder;

        public MeasuredGpuTime()
        {
            // A name of its own for each simulation: a recorder sums all samples of a name.
            slot = SamplerSlots.Take();
            sampler = CustomSampler.Create(SamplerSlots.NameOf(slot), true);
            recorder = sampler.GetRecorder();
            recorder.enabled = true;
        }

        public static bool IsSupported => SystemInfo.supportsGpuRecorder;

        public GpuTimeKind Kind => recorder.isValid ? GpuTimeKind.Measured : GpuTimeKind.None;

        public void BeginStep(CommandBuffer commands) => commands.BeginSample(sampler);
        public void EndStep(CommandBuffer commands) => commands.EndSample(sampler);

        public StepTime Read(float seconds, WorkHistory work)
        {
            int steps = recorder.gpuSampleBlockCount;
            return steps > 0 ? new StepTime(recorder.gpuElapsedNanoseconds * MillisecondsOfNanosecond / steps, work.StepCost(FramesLate)) : default;
        }

        public void Dispose()
        {
            recorder.enabled = false;
            SamplerSlots.Give(slot);
        }
    }
}
