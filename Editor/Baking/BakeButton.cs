using System;
using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Rill.Editor
{
    /// <summary>The button below an empty Field: it bakes the mesh of the component's object, and the component takes what comes of it.</summary>
    static class BakeButton
    {
        static readonly GUIContent Label =
            new GUIContent("Bake...", "Opens the window that bakes this object's mesh into a field and assigns it.");

        /// <summary>Draws it where one of the components can use it.</summary>
        /// <param name="needsField">Whether a component is to have a field, and has none.</param>
        public static void Draw<T>(Object[] targets, Func<T, bool> needsField) where T : Component
        {
            List<T> empty = targets.Cast<T>().Where(one => needsField(one) && one.GetComponentInChildren<MeshFilter>(true) != null).ToList();
            if (empty.Count == 0 || !GUILayout.Button(Label))
                return;
            // What shows its mesh in another frame needs a component of its own there: the window's Assign.
            FieldReceiver receiver = empty.TrueForAll(one => MeshOf(one) != null) ? ReceiverFor(empty, needsField) : null;
            BakeWindow.Open(empty.Select(one => one.gameObject), receiver);
        }

        static FieldReceiver ReceiverFor<T>(List<T> empty, Func<T, bool> needsField) where T : Component
        {
            string label = empty.Count == 1 ? $"Field of '{empty[0].name}'" : $"Field of {empty.Count} objects";
            return new FieldReceiver(label, (mesh, field) =>
            {
                foreach (T one in empty)
                    if (one != null && needsField(one) && MeshOf(one) == mesh)
                        Set(one, field);
            });
        }

        // On its object, or below it in the same frame; null for none.
        static Mesh MeshOf(Component component)
        {
            foreach (MeshFilter filter in component.GetComponentsInChildren<MeshFilter>(true))
                if (filter.sharedMesh != null && filter.transform.localToWorldMatrix == component.transform.localToWorldMatrix)
                    return filter.sharedMesh;
            return null;
        }

        static void Set(Component component, SignedDistanceField field)
        {
            using (var serialized = new SerializedObject(component))
            {
                serialized.FindProperty("field").objectReferenceValue = field;
                serialized.ApplyModifiedProperties();
            }
        }
    }
}
