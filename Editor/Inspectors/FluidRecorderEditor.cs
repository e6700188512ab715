using System;
using System.Collections.Generic;
using System.IO;
using UnityEditor;
using UnityEngine;
using static System.FormattableString;

namespace Rill.Editor
{
    [CustomEditor(typeof(FluidRecorder))]
    [CanEditMultipleObjects]
    sealed class FluidRecorderEditor : RillEditor
    {
        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection("Recording", true,
                new InspectorField("fields"),
                new InspectorField("rate", "1/s"),
                new InspectorField("bufferedFrames")),
        };

        FluidRecorder Recorder => (FluidRecorder)target;

        internal override InspectorSection[] Sections => AllSections;

        internal override void ListLive(List<(string label, string text)> live)
        {
            live.Add(("State", Recorder.IsRecording ? "records" : Recorder.IsWriting ? "writes what is pending" : "off"));
            if (Recorder.FrameCount > 0)
                live.Add(("File", Invariant($"{Recorder.FrameCount:N0} frames, {EditorUtility.FormatBytes(Recorder.FileSize)}")));
        }

        private protected override void DrawLive()
        {
            if (Recorder.IsRecording)
            {
                if (GUILayout.Button("Stop"))
                    Recorder.Stop();
                return;
            }
            using (new EditorGUI.DisabledScope(!Recorder.isActiveAndEnabled || Recorder.IsWriting
                || !Recorder.GetComponent<FluidSimulation>().IsRunning))
                if (GUILayout.Button(new GUIContent("Record", "Records into a new file in the project's persistent data path, which is logged.")))
                    Record();
        }

        void Record()
        {
            string file = Path.Combine(Application.persistentDataPath, $"{Recorder.name} " +
                Invariant($"{DateTime.Now:yyyy-MM-dd HH-mm-ss}.rillrec"));
            Recorder.Record(file);
            Debug.Log($"Rill: FluidRecorder '{Recorder.name}' records into '{file}'.", Recorder);
        }
    }
}
