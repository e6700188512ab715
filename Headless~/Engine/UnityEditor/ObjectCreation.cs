using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor
{
    public sealed class GameObjectUtility
    {
        /// <summary>Puts the child below the parent at its pose, with its layer; does nothing without one.</summary>
        public static void SetParentAndAlign(GameObject child, GameObject parent)
        {
            if (parent == null)
                return;
            child.transform.SetParent(parent.transform, false);
            child.transform.localPosition = Vector3.zero;
            child.transform.localRotation = Quaternion.identity;
            child.transform.localScale = Vector3.one;
            SetLayer(child.transform, parent.layer);
        }

        public static void EnsureUniqueNameForSibling(GameObject self) => self.name = Unique(self.transform.parent, self.name, self);
        public static string GetUniqueNameForSibling(Transform parent, string name) => Unique(parent, name, null);

        static string Unique(Transform parent, string name, GameObject self)
        {
            IEnumerable<GameObject> siblings = parent ? parent.Cast<Transform>().Select(t => t.gameObject)
                : UnityEngine.SceneManagement.SceneManager.GetActiveScene().GetRootGameObjects();
            var taken = new HashSet<string>(siblings.Where(o => o != self).Select(o => o.name));
            string unique = name;
            for (int number = 1; taken.Contains(unique); number++)
                unique = $"{name} ({number})";
            return unique;
        }

        static void SetLayer(Transform tree, int layer)
        {
            tree.gameObject.layer = layer;
            foreach (Transform child in tree)
                SetLayer(child, layer);
        }
    }

    /// <summary>Object that a menu item was called on.</summary>
    public sealed class MenuCommand
    {
        public Object context;
        public int userData;

        public MenuCommand(Object inContext) : this(inContext, 0) { }

        public MenuCommand(Object inContext, int inUserData)
        {
            context = inContext;
            userData = inUserData;
        }
    }

    /// <summary>Kept for as long as the process runs.</summary>
    public class SessionState
    {
        static readonly Dictionary<string, bool> bools = new Dictionary<string, bool>();
        static readonly Dictionary<string, float> floats = new Dictionary<string, float>();
        static readonly Dictionary<string, string> strings = new Dictionary<string, string>();

        public static bool GetBool(string key, bool defaultValue) => bools.TryGetValue(key, out bool value) ? value : defaultValue;
        public static void SetBool(string key, bool value) => bools[key] = value;
        public static void EraseBool(string key) => bools.Remove(key);
        public static float GetFloat(string key, float defaultValue) => floats.TryGetValue(key, out float value) ? value : defaultValue;
        public static void SetFloat(string key, float value) => floats[key] = value;
        public static void EraseFloat(string key) => floats.Remove(key);
        public static string GetString(string key, string defaultValue) => strings.TryGetValue(key, out string value) ? value : defaultValue;
        public static void SetString(string key, string value) => strings[key] = value;
        public static void EraseString(string key) => strings.Remove(key);
    }
}

namespace UnityEditor.SceneManagement
{
    public static class StageUtility
    {
        public static void PlaceGameObjectInCurrentStage(GameObject gameObject)
        {
            PrefabStage stage = PrefabStageUtility.GetCurrentPrefabStage();
            if (stage)
                gameObject.transform.SetParent(stage.prefabContentsRoot.transform, true);
        }
    }

    public abstract class Stage : ScriptableObject { }

    public abstract class PreviewSceneStage : Stage { }

    /// <summary>An open prefab. The host opens none; a test may say that one is.</summary>
    public sealed class PrefabStage : PreviewSceneStage
    {
        internal static PrefabStage Current;

        public static event System.Action<GameObject> prefabSaving;

        /// <summary>Raises the event that the Editor raises before it saves an open prefab.</summary>
        internal static void RaiseSaving(GameObject root) => prefabSaving?.Invoke(root);

        public GameObject prefabContentsRoot { get; internal set; }
    }

    public sealed class PrefabStageUtility
    {
        public static PrefabStage GetCurrentPrefabStage() => PrefabStage.Current;
    }
}
