using System;
using UnityEngine;
using UnityEngine.Playables;
using UnityEngine.Timeline;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Part of a recording on a <see cref="FluidPlaybackTrack"/>, with the Timeline's <i>Clip In</i> and
    /// <i>Speed Multiplier</i>.</summary>
    public sealed class FluidPlaybackClip : PlayableAsset, ITimelineClipAsset, IAppliesSettings
    {
        [Tooltip("Time of the recording with which the clip begins, s since its first frame, 0 or more. Clip In is added to it.")]
        [SerializeField] double begin;

        [NonSerialized] ClampedSettings clamped;

        /// <summary>Time of the recording with which the clip begins, s since its first frame, 0 or more; the clip's own Clip In is
        /// added to it. Out-of-range values are clamped with a warning.</summary>
        public double Begin { get => begin; set { begin = value; Changed(); } }

        /// <summary>That it can be trimmed at its start and played faster or slower.</summary>
        public ClipCaps clipCaps => ClipCaps.ClipIn | ClipCaps.SpeedMultiplier;

        /// <summary>Time from <see cref="Begin"/> to the end of the recording, s; infinite while the recording is not known. It is known
        /// once a timeline was built with a playback bound to the track.</summary>
        public override double duration => RecordingDuration > begin ? RecordingDuration - begin : base.duration;

        /// <summary>Duration of the recording bound to the track, s; 0 while it is unknown.</summary>
        [field: NonSerialized] internal double RecordingDuration { get; set; }

        /// <summary>Makes a playable that stands for the clip. The track does the rest.</summary>
        public override Playable CreatePlayable(PlayableGraph graph, GameObject owner) => Playable.Create(graph);

        void OnValidate() => ChangedSettings.ApplyLater(this);

        void Changed() => ChangedSettings.Apply(this);

        void IAppliesSettings.CheckSettings()
        {
            bool isTime = begin >= 0.0 && !double.IsInfinity(begin);
            clamped.Set(isTime ? null : Invariant($"begin {begin} is not a time since the first frame, 0 s or more; 0 is used."));
            begin = isTime ? begin : 0.0;
        }

        void IAppliesSettings.ApplySettings() => clamped.Log(this);
    }
}
