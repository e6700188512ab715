using UnityEditor;
using UnityEngine;
using static System.FormattableString;

namespace Rill.Editor
{
    /// <summary>Inspector that describes a snapshot, or tells why it cannot be used.</summary>
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
            EditorGUILayout.LabelField("Particles", Invariant($"{snapshot.ParticleCount:N0}"));
            EditorGUILayout.LabelField("Particle Spacing", Invariant($"{snapshot.ParticleSpacing} m"));
            EditorGUILayout.LabelField("Domain Size", Invariant($"{box.x} x {box.y} x {box.z} m"));
            EditorGUILayout.LabelField("Taken At", Invariant($"step {snapshot.StepCount}, {snapshot.FluidTime:0.###} s"));
            EditorGUILayout.LabelField("Size", EditorUtility.FormatBytes(asset.Size));
        }
    }
}
