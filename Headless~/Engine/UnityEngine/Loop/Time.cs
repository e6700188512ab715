using System.Diagnostics;
using UnityEngine.Headless;

namespace UnityEngine
{
    public class Time
    {
        internal static readonly Clock Clock = new Clock();

        /// <summary>Inside FixedUpdate the fixed time, as everything below that mentions it.</summary>
        public static float time => (float)timeAsDouble;
        public static double timeAsDouble => Clock.InFixedStep ? Clock.Fixed : Clock.Scaled;
        public static float deltaTime => Clock.InFixedStep ? Clock.FixedDelta : Clock.Delta;
        public static float fixedTime => (float)Clock.Fixed;
        public static double fixedTimeAsDouble => Clock.Fixed;
        public static float unscaledTime => (float)unscaledTimeAsDouble;
        public static double unscaledTimeAsDouble => Clock.InFixedStep ? Clock.FixedUnscaled : Clock.Unscaled;
        public static float unscaledDeltaTime => Clock.InFixedStep ? Clock.FixedUnscaledDelta : Clock.UnscaledDelta;
        public static float fixedUnscaledTime => (float)Clock.FixedUnscaled;
        public static double fixedUnscaledTimeAsDouble => Clock.FixedUnscaled;
        public static float fixedUnscaledDeltaTime => Clock.FixedUnscaledDelta;
        public static float smoothDeltaTime => Clock.SmoothDelta;
        public static float timeSinceLevelLoad => (float)timeSinceLevelLoadAsDouble;
        public static double timeSinceLevelLoadAsDouble => timeAsDouble - Clock.LevelLoad;
        public static float realtimeSinceStartup => (float)realtimeSinceStartupAsDouble;
        public static double realtimeSinceStartupAsDouble => Clock.Real.Elapsed.TotalSeconds;
        public static int frameCount => Clock.Frame;
        public static int renderedFrameCount => Clock.Frame;
        public static bool inFixedTimeStep => Clock.InFixedStep;

        public static float fixedDeltaTime
        {
            get => Clock.FixedDelta;
            set => Clock.FixedDelta = Mathf.Clamp(value, 0.0001f, 10);
        }

        public static float maximumDeltaTime
        {
            get => Clock.MaximumDelta;
            set => Clock.MaximumDelta = Mathf.Max(value, Clock.FixedDelta);
        }

        public static float maximumParticleDeltaTime { get; set; } = 0.03f;

        public static float timeScale
        {
            get => Clock.Scale;
            set
            {
                if (value < 0 || value > 100)
                    Debug.LogError("Time.timeScale is out of range. The value must be between 0.0 and 100.0");
                else
                    Clock.Scale = value;
            }
        }

        /// <summary>When set, every frame advances time by this much, whatever the host asks for.</summary>
        public static float captureDeltaTime { get => Clock.CaptureDelta; set => Clock.CaptureDelta = Mathf.Max(0, value); }
        public static int captureFramerate
        {
            get => captureDeltaTime == 0 ? 0 : Mathf.RoundToInt(1 / captureDeltaTime);
            set => captureDeltaTime = value <= 0 ? 0 : 1f / value;
        }
    }
}

namespace UnityEngine.Headless
{
    /// <summary>The state behind Time.</summary>
    internal sealed class Clock
    {
        public double Scaled, Unscaled, Fixed, FixedUnscaled, LevelLoad;
        public float Delta, UnscaledDelta, SmoothDelta, FixedDelta, MaximumDelta, Scale, CaptureDelta;
        public int Frame;
        public bool InFixedStep;
        public readonly Stopwatch Real = Stopwatch.StartNew();

        public Clock() => Reset();

        public float FixedUnscaledDelta => Scale > 0 ? FixedDelta / Scale : FixedDelta;

        /// <summary>Unity's project defaults.</summary>
        public void Reset()
        {
            Scaled = Unscaled = Fixed = FixedUnscaled = LevelLoad = 0;
            Delta = UnscaledDelta = SmoothDelta = CaptureDelta = 0;
            FixedDelta = 0.02f;
            MaximumDelta = 1f / 3;
            Scale = 1;
            Frame = 0;
            InFixedStep = false;
            Real.Restart();
        }

        public void BeginFrame(float deltaTime)
        {
            Frame++;
            UnscaledDelta = CaptureDelta > 0 ? CaptureDelta : deltaTime;
            Delta = Mathf.Min(UnscaledDelta, MaximumDelta) * Scale;
            SmoothDelta = Frame == 1 ? Delta : SmoothDelta * 0.8f + Delta * 0.2f;
            Unscaled += UnscaledDelta;
            Scaled += Delta;
        }

        /// <summary>Fraction of the coming fixed step that has passed, 0 to 1.</summary>
        public float StepFraction => Mathf.Clamp01((float)((Scaled - Fixed) / FixedDelta));

        /// <summary>Enters the next fixed step that is due; false when there is none.</summary>
        public bool StepFixed()
        {
            // In floats' steps: a frame as long as a fixed step must hold exactly one, whatever the sums' rounding.
            if (Scaled - Fixed < FixedDelta - 1e-9)
            {
                InFixedStep = false;
                return false;
            }
            Fixed += FixedDelta;
            FixedUnscaled += FixedUnscaledDelta;
            InFixedStep = true;
            return true;
        }
    }
}
