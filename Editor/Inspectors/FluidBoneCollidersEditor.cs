using System.Collections.Generic;
using UnityEditor;
using UnityEngine;
using static System.FormattableString;

namespace Rill.Editor
{
    [CustomEditor(typeof(FluidBoneColliders))]
    [CanEditMultipleObjects]
    sealed class FluidBoneCollidersEditor : RillEditor
    {
        static readonly GUIContent FitLabel =
            new GUIContent("Fit to Bones", "Fits a capsule to each bone again. Keeps friction, events and " +
                "other settings of those that are there.");
        static readonly GUIContent ClearLabel = new GUIContent("Remove", "Removes the capsules that it has fitted.");

        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection("Capsules", true,
                new InspectorField("minWeight"),
                new InspectorField("minVertices"),
                new InspectorField("coverage")),
        };

        internal override InspectorSection[] Sections => AllSections;

        internal override bool TryGetFrame(Object of, out Bounds bounds) => FrameBounds.TryGet((FluidBoneColliders)of, out bounds);

        private protected override void DrawBelowSections()
        {
            using (new EditorGUILayout.HorizontalScope())
            {
                if (GUILayout.Button(FitLabel))
                    foreach (Object one in targets)
                        ((FluidBoneColliders)one).Fit();
                if (GUILayout.Button(ClearLabel))
                    foreach (Object one in targets)
                        ((FluidBoneColliders)one).Clear();
            }
        }

        internal override void ListLive(List<(string label, string text)> live)
            => live.Add(("Capsules", Invariant($"{((FluidBoneColliders)target).Capsules.Count}")));
    }
}
