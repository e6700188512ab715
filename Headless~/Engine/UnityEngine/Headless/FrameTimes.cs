using System.Diagnostics;

namespace UnityEngine.Headless
{
    /// <summary>Times for FrameTimingManager. Nothing is stamped before the first capture.</summary>
    internal static class FrameTimes
    {
        /// <summary>Unity's documented delay.</summary>
        public const int FramesLate = 4;
        const int Kept = 16;

        sealed class TimedFrame
        {
            public int Number = -1;
            public long Start;
            public double CpuMilliseconds;
            public DeviceTimeMark Begin, End;
        }

        static readonly TimedFrame[] frames = Make();
        static bool isUsed;
        static int captured = -1;
        static TimedFrame current;

        public static bool Supported => Player.Device != null && Player.GpuTimes != GpuTimes.None;

        public static void Capture()
        {
            isUsed = Supported;
            captured = isUsed ? Time.frameCount : -1;
        }

        public static uint Latest(uint count, FrameTiming[] timings)
        {
            uint found = 0;
            for (int number = captured - FramesLate; number >= 0 && number > captured - Kept && found < count; number--)
            {
                TimedFrame frame = frames[number % Kept];
                if (frame.Number != number)
                    break;
                bool known = frame.Begin.TryRead(out double from) & frame.End.TryRead(out double to);
                timings[found++] = new FrameTiming
                {
                    cpuFrameTime = frame.CpuMilliseconds, cpuMainThreadFrameTime = frame.CpuMilliseconds, gpuFrameTime = known ? to - from : 0,
                    frameStartTimestamp = (ulong)frame.Start, heightScale = 1, widthScale = 1,
                };
            }
            return found;
        }

        public static void BeginFrame()
        {
            current = null;
            if (!isUsed || Player.Device == null)
                return;
            current = frames[Time.frameCount % Kept];
            Clear(current);
            current.Start = Stopwatch.GetTimestamp();
            current.Begin = Gpu.Device.MarkTime();
        }

        /// <summary>After the frame's last work, before it is submitted.</summary>
        public static void EndFrame()
        {
            if (current == null)
                return;
            current.End = Gpu.Device.MarkTime();
            current.CpuMilliseconds = (Stopwatch.GetTimestamp() - current.Start) * 1e3 / Stopwatch.Frequency;
            current.Number = Time.frameCount;
            current = null;
        }

        public static void Reset()
        {
            foreach (TimedFrame frame in frames)
                Clear(frame);
            current = null;
            isUsed = false;
            captured = -1;
        }

        static void Clear(TimedFrame frame)
        {
            frame.Number = -1;
            frame.Begin?.Dispose();
            frame.End?.Dispose();
            frame.Begin = frame.End = null;
        }

        static TimedFrame[] Make()
        {
            var made = new TimedFrame[Kept];
            for (int i = 0; i < Kept; i++)
                made[i] = new TimedFrame();
            return made;
        }
    }
}
