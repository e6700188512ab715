using System.Collections.Generic;
using UnityEditor;
using UnityEngine;
using static System.FormattableString;

namespace Rill.Editor
{
    [CustomEditor(typeof(FluidPlayback))]
    [CanEditMultipleObjects]
    sealed class FluidPlaybackEditor : RillEditor
    {
        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection("Playback", true,
                new InspectorField("recording"),
                new InspectorField("playOnEnable"),
                new InspectorField("speed"),
                new InspectorField("loop"),
                new InspectorField("waitForFrames")),
        };

        FluidPlayback Playback => (FluidPlayback)target;

        internal override InspectorSection[] Sections => AllSections;

        internal override void ListLive(List<(string label, string text)> live)
        {
            if (!Playback.IsOpen)
            {
                live.Add(("Recording", "none is open"));
                return;
            }
            live.Add(("Recording", Invariant($"{Playback.FrameCount:N0} frames, {Playback.Duration:0.00} ") +
                $"s{(Playback.WasCutShort ? ", cut short" : "")}"));
            live.Add(("Shown", Playback.ShownFrame >= 0 ? Invariant($"frame {Playback.ShownFrame:N0} at {Playback.Time:0.00} ") +
                "s" : "nothing yet"));
            if (Playback.MissedFrames > 0)
                live.Add(("Missed", Invariant($"{Playback.MissedFrames:N0} frames were not read in time")));
        }

        private protected override void DrawLive()
        {
            if (!Playback.IsOpen)
                return;
            if (GUILayout.Button(Playback.IsPlaying ? "Pause" : "Play"))
            {
                if (Playback.IsPlaying)
                    Playback.Pause();
                else
                    Playback.Play();
            }
            int shown = Mathf.Max(Playback.ShownFrame, 0);
            int frame = EditorGUILayout.IntSlider(new GUIContent("Frame", "Goes to a frame of the recording."), shown, 0, Playback.FrameCount - 1);
            if (frame != shown)
                Playback.Time = Playback.TimeOf(frame);
        }
    }
}
