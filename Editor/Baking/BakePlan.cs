using System;
using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;
using static System.FormattableString;

namespace Rill.Editor
{
    /// <summary>Receivers of a field once it is baked.</summary>
    enum BakeAssign
    {
        /// <summary>Only the asset is made.</summary>
        Nothing,

        /// <summary>Colliders on the objects that show the mesh take it.</summary>
        ToColliders,

        /// <summary>Sets the field of the colliders, and adds a collider to objects without one.</summary>
        AddColliders,
    }

    /// <summary>The meshes of a selection, each once, and their bakes one after the other.</summary>
    sealed class BakePlan
    {
        BakePlan(List<BakeItem> items, List<string> notes) => (Items, Notes) = (items, notes);

        public IReadOnlyList<BakeItem> Items { get; }

        /// <summary>Objects of the selection that are not baked, with the reason.</summary>
        public IReadOnlyList<string> Notes { get; }

        /// <summary>Mesh filters on the selected objects and below them, meshes, models with meshes, and distance fields, which are baked
        /// again.</summary>
        /// <param name="folder">For new assets, as "Assets/Fields".</param>
        /// <param name="analyses">Those that are known; no mesh is analyzed here.</param>
        public static BakePlan Of(IEnumerable<Object> selection, string folder, MeshAnalyses analyses)
        {
            var items = new List<BakeItem>();
            var notes = new List<string>();
            var paths = new HashSet<string>();

            BakeItem Item(Mesh mesh, SignedDistanceField into)
            {
                BakeItem item = items.Find(other => other.Mesh == mesh && (into == null || other.Existing == into));
                if (item != null)
                    return item;
                SignedDistanceField existing = into;
                string path = into != null ? AssetDatabase.GetAssetPath(into) : FieldAssets.PathFor(folder, mesh, paths, out existing);
                paths.Add(path);
                items.Add(item = new BakeItem(analyses.Of(mesh), path, existing));
                return item;
            }

            foreach (Object selected in selection.Where(o => o != null))
                switch (selected)
                {
                    case Mesh mesh:
                        Item(mesh, null);
                        break;
                    case SignedDistanceField field:
                        Mesh source = FieldAssets.MeshOf(field, out string problem);
                        if (source != null)
                            Item(source, field);
                        else
                            notes.Add(problem);
                        break;
                    case GameObject root:
                        Add(root.GetComponentsInChildren<MeshFilter>(true), root.name);
                        break;
                    case MeshFilter filter:
                        Add(new[] { filter }, filter.name);
                        break;
                    default:
                        notes.Add($"'{selected.name}' has no mesh: left out.");
                        break;
                }
            return new BakePlan(items, notes);

            void Add(MeshFilter[] filters, string name)
            {
                if (filters.Length == 0)
                    notes.Add($"'{name}' has no Mesh Filter: left out.");
                foreach (MeshFilter filter in filters)
                    if (filter.sharedMesh == null)
                        notes.Add($"The Mesh Filter of '{filter.name}' has no mesh: assign one.");
                    else
                    {
                        List<GameObject> objects = Item(filter.sharedMesh, null).Objects;
                        if (!objects.Contains(filter.gameObject))
                            objects.Add(filter.gameObject);
                    }
            }
        }

        /// <summary>All of it; what cannot be baked is reported and does not keep the others from it.</summary>
        /// <param name="progress">Told the fraction of the whole that is done and what is being done, and asked whether to go on.</param>
        /// <param name="receiver">Takes the fields instead; null for none.</param>
        /// <returns>False if it was canceled: the items before that are baked.</returns>
        public bool Bake(MeshSdfSettings settings, BakeAssign assign, Func<float, string, bool> progress, FieldReceiver receiver = null)
        {
            for (int i = 0; i < Items.Count; i++)
            {
                BakeItem item = Items[i];
                int before = i;
                if (!item.Bake(settings, (fraction, stage) => progress((before + fraction) / Items.Count,
                    Invariant($"{item.Mesh.name} ({before + 1} of {Items.Count}): {stage}"))))
                    return false;
                if (item.Failed)
                    continue;
                if (receiver != null)
                    item.SetTaken(receiver.Assign(item.Mesh, item.Field));
                else if (assign != BakeAssign.Nothing)
                    foreach (GameObject shown in item.Objects)
                        Assign(shown, item.Field, assign);
            }
            return true;
        }

        /// <summary>Makes the collider of an object, if there is one or shall be one, that of the mesh. Undo takes it back.</summary>
        static void Assign(GameObject shown, SignedDistanceField field, BakeAssign assign)
        {
            FluidCollider collider = shown.GetComponent<FluidCollider>();
            // A model's own object is not the user's to change.
            if (collider == null && (assign != BakeAssign.AddColliders || EditorUtility.IsPersistent(shown)))
                return;
            if (collider == null)
                collider = Undo.AddComponent<FluidCollider>(shown);
            using (var serialized = new SerializedObject(collider))
            {
                serialized.FindProperty("shape").intValue = (int)ColliderShape.Mesh;
                serialized.FindProperty("field").objectReferenceValue = field;
                serialized.ApplyModifiedProperties();
            }
        }
    }
}
