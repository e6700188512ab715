using System;
using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;
using static System.FormattableString;

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
            ILookup<bool, T> byFrame = empty.ToLookup(one => MeshOf(one) != null);
            List<T> own = byFrame[true].ToList();
            // If all meshes are shown in other frames, the window can give the objects that show them colliders.
            bool toWindow = typeof(T) == typeof(FluidCollider) && own.Count == 0;
            if (!toWindow && byFrame[false].FirstOrDefault() is T other)
                EditorGUILayout.HelpBox($"The mesh below '{other.name}' has another position, rotation or scale, and its field would not fit here: " +
                    $"put a {ObjectNames.NicifyVariableName(typeof(T).Name)} on the object that shows it.", MessageType.Info);
            if ((toWindow ? empty : own).Count == 0 || !GUILayout.Button(Label))
                return;
            if (toWindow)
                BakeWindow.Open(empty.Select(one => one.gameObject));
            else
                BakeWindow.Open(own.Select(MeshOf).Distinct(), ReceiverFor(own, needsField));
        }

        static FieldReceiver ReceiverFor<T>(List<T> empty, Func<T, bool> needsField) where T : Component
        {
            string label = empty.Count == 1 ? $"Field of '{empty[0].name}'" : Invariant($"Field of {empty.Count} objects");
            return new FieldReceiver(label, (mesh, field) =>
            {
                List<T> takers = empty.FindAll(one => one != null && needsField(one) && MeshOf(one) == mesh);
                takers.ForEach(one => Set(one, field));
                return takers.Count > 0;
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
