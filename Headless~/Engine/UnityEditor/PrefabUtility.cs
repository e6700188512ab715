using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Headless;
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

        /// <summary>Whether it is part of a package that the project does not own.</summary>
        public static bool IsPartOfImmutablePrefab(Object componentOrGameObject)
            => AssetDatabase.GetAssetPath(componentOrGameObject).StartsWith("Packages/", StringComparison.Ordinal);

        /// <summary>In edit mode: play mode knows no prefabs. What was added to an instance is not a part of it.</summary>
        public static bool IsPartOfPrefabInstance(Object componentOrGameObject)
            => EditMode.IsOn && componentOrGameObject != null && componentOrGameObject.PrefabInstance != 0;

        /// <summary>Whether it was put below a part of an instance, which has no such child in its prefab.</summary>
        public static bool IsAddedGameObjectOverride(GameObject gameObject)
            => !IsPartOfPrefabInstance(gameObject) && gameObject.transform.parent is Transform parent && parent != null
            && IsPartOfPrefabInstance(parent);

        /// <summary>A copy of a prefab that remains an instance of it.</summary>
        public static Object InstantiatePrefab(Object assetComponentOrGameObject)
        {
            Object made = Object.Instantiate(assetComponentOrGameObject);
            made.name = assetComponentOrGameObject.name;
            Connect(made is Component component ? component.gameObject : (GameObject)made);
            return made;
        }

        /// <summary>Makes all of a tree one instance.</summary>
        internal static void Connect(GameObject root)
        {
            foreach (Transform part in root.GetComponentsInChildren<Transform>(true))
            {
                part.gameObject.PrefabInstance = root.GetInstanceID();
                foreach (Component component in part.GetComponents<Component>())
                    component.PrefabInstance = root.GetInstanceID();
            }
        }

        public static void RecordPrefabInstancePropertyModifications(Object targetObject) { }
    }
}
