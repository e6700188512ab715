using System;
using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor
{
    /// <summary>Prefabs as the host has them: loaded from their files, with their instances expanded, and never written.</summary>
    public sealed class PrefabUtility
    {
        /// <summary>Paths of the prefabs that scripts saved.</summary>
        internal static readonly List<string> Saved = new List<string>();

        public static GameObject SavePrefabAsset(GameObject asset)
        {
            string path = AssetDatabase.GetAssetPath(asset);
            if (path.Length == 0 || asset.transform.parent != null)
                throw new ArgumentException("Can't save a GameObject that is not the root of a Prefab Asset");
            Saved.Add(path);
            return asset;
        }

        /// <summary>Of packages that the project does not own.</summary>
        public static bool IsPartOfImmutablePrefab(Object componentOrGameObject)
            => AssetDatabase.GetAssetPath(componentOrGameObject).StartsWith("Packages/", StringComparison.Ordinal);

        /// <summary>The host expands instances where they stand: there is nothing to ask.</summary>
        public static bool IsPartOfPrefabInstance(Object componentOrGameObject) => false;

        public static void RecordPrefabInstancePropertyModifications(Object targetObject) { }
    }
}
