using System.Globalization;
using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>What a snapshot is of, or why it cannot be used.</summary>
    [CustomEditor(typeof(FluidSnapshotAsset))]
    sealed class FluidSnapshotAssetEditor : UnityEditor.Editor
    {
        public override void OnInspectorGUI()
        {
            var asset = (FluidSnapshotAsset)target;
            if (!asset.Validate(out string problem))
            {
                EditorGUILayout.HelpBox(problem, MessageType.Error);
                return;
            }
            FluidSnapshot snapshot = asset.Snapshot;
            Vector3 box = snapshot.DomainSize;
            EditorGUILayout.LabelField("Particles", Text("{0:N0}", snapshot.ParticleCount));
            EditorGUILayout.LabelField("Particle Spacing", Text("{0} m", snapshot.ParticleSpacing));
            EditorGUILayout.LabelField("Domain Size", Text("{0} x {1} x {2} m", box.x, box.y, box.z));
            EditorGUILayout.LabelField("Taken At", Text("step {0}, {1:0.###} s", snapshot.StepCount, snapshot.FluidTime));
            EditorGUILayout.LabelField("Size", EditorUtility.FormatBytes(asset.Size));
        }

        static string Text(string format, params object[] values) => string.Format(CultureInfo.InvariantCulture, format, values);
    }
}
