using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Playables;
using UnityEngine.Timeline;

namespace Rill
{
    /// <summary>
    /// Track of a Timeline that says which time of its recording a <see cref="FluidPlayback"/> shows. Bind the playback to it, and lay
    /// <see cref="FluidPlaybackClip">clips</see> on it.
    /// </summary>
    /// <remarks>
    /// At each time of the timeline the same frame is shown, however it was reached. After a clip its last frame stays, before the first
    /// clip its first. Where clips overlap, the one that starts later is shown. Once the timeline stops, the playback goes on from what it
    /// shows: it plays where it played before.
    /// Without the package com.unity.timeline this type is not there.
    /// </remarks>
    [TrackColor(0.16f, 0.55f, 0.8f)]
    [TrackBindingType(typeof(FluidPlayback))]
    [TrackClipType(typeof(FluidPlaybackClip))]
    public sealed class FluidPlaybackTrack : TrackAsset
    {
        /// <summary>Makes the playable that sets the time of what is bound.</summary>
        public override Playable CreateTrackMixer(PlayableGraph graph, GameObject go, int inputCount)
        {
            var clips = new List<TimelineClip>();
            foreach (TimelineClip clip in GetClips())
                if (clip.asset is FluidPlaybackClip)
                    clips.Add(clip);
            if (go.TryGetComponent(out PlayableDirector director) && director.GetGenericBinding(this) is FluidPlayback playback
                && playback != null && playback.TryFindDuration(out double seconds))
                foreach (TimelineClip clip in clips)
                    ((FluidPlaybackClip)clip.asset).RecordingDuration = seconds;
            ScriptPlayable<FluidPlaybackMixer> mixer = ScriptPlayable<FluidPlaybackMixer>.Create(graph, inputCount);
            mixer.GetBehaviour().Clips = clips;
            return mixer;
        }
    }
}
