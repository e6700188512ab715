using System;
using System.Collections.Generic;
using UnityEngine.Playables;
using UnityEngine.Timeline;

namespace Rill
{
    /// <summary>Sets the time of the playback that is bound to a track, by the clips alone: what is shown does not depend on what was
    /// shown before.</summary>
    sealed class FluidPlaybackMixer : PlayableBehaviour
    {
        FluidPlayback driven;

        /// <summary>All of the track, with assets of the type FluidPlaybackClip. They may be moved while the graph lives.</summary>
        public List<TimelineClip> Clips { get; set; }

        public override void ProcessFrame(Playable playable, FrameData info, object playerData)
        {
            var bound = playerData as FluidPlayback;
            if (!ReferenceEquals(bound, driven))
                LetGo();
            if (bound == null || Clips.Count == 0)
                return;
            driven = bound;
            // The root's time is the timeline's own, whatever plays the track within it.
            driven.Drive(RecordingTime(playable.GetGraph().GetRootPlayable(0).GetTime()));
        }

        public override void OnPlayableDestroy(Playable playable) => LetGo();

        void LetGo()
        {
            if (driven != null)
                driven.LetGo();
            driven = null;
        }

        double RecordingTime(double time)
        {
            TimelineClip first = Clips[0], shown = null;
            foreach (TimelineClip clip in Clips)
            {
                if (clip.start < first.start)
                    first = clip;
                if (clip.start <= time && (shown == null || clip.start >= shown.start))
                    shown = clip;
            }
            shown ??= first;
            return ((FluidPlaybackClip)shown.asset).Begin + shown.ToLocalTime(Math.Min(Math.Max(time, shown.start), shown.end));
        }
    }
}
