using System;
using UnityEngine.Playables;

namespace UnityEngine.Timeline
{
    [Flags]
    public enum ClipCaps
    {
        None = 0,
        Looping = 1 << 0,
        Extrapolation = 1 << 1,
        ClipIn = 1 << 2,
        SpeedMultiplier = 1 << 3,
        Blending = 1 << 4,
        All = ~None,
    }

    public interface ITimelineClipAsset
    {
        ClipCaps clipCaps { get; }
    }

    /// <summary>A clip without blends and without extrapolation, which its asset must not ask for: the host has neither.</summary>
    public class TimelineClip
    {
        const double MinSpeed = 1.0 / 1000.0, MaxSpeed = 1000.0;

        double startTime, length = 5.0, speed = 1.0, offset;

        internal TimelineClip() { }

        public double start { get => startTime; set => startTime = Math.Max(value, 0.0); }
        public double duration { get => length; set => length = Math.Max(value, double.Epsilon); }
        public double end => startTime + length;
        public string displayName { get; set; }
        public Object asset { get; set; }
        public ClipCaps clipCaps => asset is ITimelineClipAsset with ? with.clipCaps : ClipCaps.Blending;

        public double timeScale
        {
            get => Has(ClipCaps.SpeedMultiplier) ? Math.Max(MinSpeed, Math.Min(speed, MaxSpeed)) : 1.0;
            set => speed = Has(ClipCaps.SpeedMultiplier) ? Math.Max(MinSpeed, Math.Min(value, MaxSpeed)) : 1.0;
        }

        public double clipIn
        {
            get => Has(ClipCaps.ClipIn) ? offset : 0.0;
            set => offset = Has(ClipCaps.ClipIn) ? Math.Max(value, 0.0) : 0.0;
        }

        public double ToLocalTime(double time) => time < 0.0 ? time : (time - startTime) * timeScale + clipIn;

        bool Has(ClipCaps caps) => (clipCaps & caps) != 0;
    }
}
