using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>One name's samples of the last frames.</summary>
    internal sealed class GpuSampler
    {
        /// <summary>Unity's documented delay: a recorder tells of the frame three before the one that asks.</summary>
        public const int FramesLate = 3;

        sealed class FrameOfSamples
        {
            public int Frame = -1;
            public readonly List<(DeviceTimeMark Begin, DeviceTimeMark End)> Blocks = new List<(DeviceTimeMark, DeviceTimeMark)>();
        }

        readonly FrameOfSamples[] frames = { new FrameOfSamples(), new FrameOfSamples(), new FrameOfSamples(), new FrameOfSamples() };

        public bool Enabled;

        public void Begin()
        {
            FrameOfSamples frame = frames[Time.frameCount % frames.Length];
            if (frame.Frame != Time.frameCount)
            {
                Clear(frame);
                frame.Frame = Time.frameCount;
            }
            frame.Blocks.Add((Gpu.Device.MarkTime(), null));
        }

        public void End()
        {
            FrameOfSamples frame = frames[Time.frameCount % frames.Length];
            int last = frame.Blocks.Count - 1;
            if (frame.Frame == Time.frameCount && last >= 0 && frame.Blocks[last].End == null)
                frame.Blocks[last] = (frame.Blocks[last].Begin, Gpu.Device.MarkTime());
        }

        /// <summary>Zeros where nothing was sampled or the GPU has not got there.</summary>
        public (long Nanoseconds, int Blocks) Read()
        {
            int wanted = Time.frameCount - FramesLate;
            if (wanted < 0)
                return default;
            FrameOfSamples frame = frames[wanted % frames.Length];
            if (frame.Frame != wanted)
                return default;
            double milliseconds = 0;
            foreach ((DeviceTimeMark begin, DeviceTimeMark end) in frame.Blocks)
            {
                if (end == null || !begin.TryRead(out double from) || !end.TryRead(out double to))
                    return default;
                milliseconds += to - from;
            }
            return ((long)(milliseconds * 1e6), frame.Blocks.Count);
        }

        public void Reset()
        {
            foreach (FrameOfSamples frame in frames)
                Clear(frame);
        }

        static void Clear(FrameOfSamples frame)
        {
            foreach ((DeviceTimeMark begin, DeviceTimeMark end) in frame.Blocks)
            {
                begin.Dispose();
                end?.Dispose();
            }
            frame.Blocks.Clear();
            frame.Frame = -1;
        }
    }
}
