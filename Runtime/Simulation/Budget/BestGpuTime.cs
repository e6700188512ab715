using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>The best that this player has: steps' own times while they come, otherwise the model with the whole frame's.</summary>
    sealed class BestGpuTime : IGpuTimeSource
    {
        const float LostSeconds = 1f;

        readonly IGpuTimeSource measured;
        readonly FrameGpuTime modeled;
        float sinceMeasured;

        /// <param name="measured">Null on a device that cannot.</param>
        public BestGpuTime(IGpuTimeSource measured, FrameGpuTime modeled)
        {
            this.measured = measured;
            this.modeled = modeled;
        }

        public static BestGpuTime OfThisPlayer(FrameGpuTime modeled)
            => new BestGpuTime(MeasuredGpuTime.IsSupported ? new MeasuredGpuTime() : null, modeled);

        public GpuTimeKind Kind { get; private set; }

        public void BeginStep(CommandBuffer commands) => measured?.BeginStep(commands);
        public void EndStep(CommandBuffer commands) => measured?.EndStep(commands);

        public StepTime Read(float seconds, WorkHistory work)
        {
            StepTime time = measured?.Read(seconds, work) ?? default;
            sinceMeasured = time.Milliseconds > 0f ? 0f : sinceMeasured + seconds;
            if (measured != null && sinceMeasured < LostSeconds)
            {
                Kind = time.Milliseconds > 0f ? GpuTimeKind.Measured : Kind;
                return time;
            }
            time = modeled.Read(seconds, work);
            Kind = modeled.Kind;
            return time;
        }

        public void Dispose()
        {
            measured?.Dispose();
            modeled.Dispose();
        }
    }
}
