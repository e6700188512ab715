using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEngine;
using static System.FormattableString;

namespace Rill.Editor
{
    /// <summary>The button below Mesh Fields: it bakes the meshes near the box that have no field, and adds both to the list.</summary>
    static class MissingFields
    {
        const string Title = "Bake Missing Fields";

        static readonly GUIContent Label = new GUIContent(Title + "...",
            "Opens the window that bakes the meshes of the Mesh Colliders near the box that have no field, and adds them to Mesh Fields.");

        /// <summary>Draws it where colliders can be looked for: not for a prefab that is not open, which is in no scene.</summary>
        public static void Draw(Object[] targets)
        {
            List<FluidPhysicsColliders> all = targets.Cast<FluidPhysicsColliders>()
                .Where(one => one.TakenLayers != 0 && one.gameObject.scene.IsValid()).ToList();
            if (all.Count == 0 || !GUILayout.Button(Label))
                return;
            List<(FluidPhysicsColliders of, List<Mesh> meshes)> missing = all.Select(one => (one, MeshesOf(one))).ToList();
            Mesh[] meshes = missing.SelectMany(pair => pair.meshes).Distinct().ToArray();
            if (meshes.Length > 0)
                BakeWindow.Open(meshes, ReceiverFor(missing));
            else
            {
                EditorUtility.DisplayDialog(Title, "The mesh of every Mesh Collider that is near the box now and on its layers has a field.",
                    "OK");
                GUIUtility.ExitGUI();       // the dialog has ended this event's layout
            }
        }

        static List<Mesh> MeshesOf(FluidPhysicsColliders colliders)
        {
            var meshes = new List<Mesh>();
            colliders.ListMissingFields(meshes);
            return meshes;
        }

        static FieldReceiver ReceiverFor(List<(FluidPhysicsColliders of, List<Mesh> meshes)> missing)
        {
            string label = missing.Count == 1 ? $"Mesh Fields of '{missing[0].of.name}'" : Invariant($"Mesh Fields of {missing.Count} ") +
                "objects";
            if (Application.isPlaying)
                label += ", until play mode ends";
            return new FieldReceiver(label, (mesh, field) =>
            {
                bool isTaken = false;
                foreach ((FluidPhysicsColliders of, List<Mesh> meshes) in missing)
                    if (of != null && meshes.Contains(mesh) && of.FieldOf(mesh) == null)
                    {
                        Add(of, mesh, field);
                        isTaken = true;
                    }
                return isTaken;
            });
        }

        static void Add(FluidPhysicsColliders to, Mesh mesh, SignedDistanceField field)
        {
            using (var serialized = new SerializedObject(to))
            {
                SerializedProperty pairs = serialized.FindProperty("meshFields");
                int index = 0;
                while (index < pairs.arraySize && MeshAt(pairs, index).objectReferenceValue != mesh)
                    index++;
                if (index == pairs.arraySize)
                    pairs.arraySize++;
                MeshAt(pairs, index).objectReferenceValue = mesh;
                pairs.GetArrayElementAtIndex(index).FindPropertyRelative("field").objectReferenceValue = field;
                serialized.ApplyModifiedProperties();
            }
        }

        static SerializedProperty MeshAt(SerializedProperty pairs, int index) => pairs.GetArrayElementAtIndex(index).FindPropertyRelative("mesh");
    }
}
