using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace UnityEditor
{
    public class EditorApplication
    {
        public delegate void CallbackFunction();

        public static CallbackFunction update;
        public static CallbackFunction delayCall;
        public static event Action<PlayModeStateChange> playModeStateChanged;
        public static event Action quitting;
        public static event Action hierarchyChanged;
        public static event Action projectChanged;

        public static bool isPlaying { get => Application.isPlaying; set { if (!value) Application.Quit(); } }
        public static bool isPaused { get; set; }
        public static bool isPlayingOrWillChangePlaymode => Application.isPlaying;
        public static bool isCompiling => false;
        public static bool isUpdating => false;
        public static double timeSinceStartup => Time.realtimeSinceStartupAsDouble;
        internal static void RaisePlayMode(PlayModeStateChange change) => playModeStateChanged?.Invoke(change);
        internal static void RaiseHierarchyChanged() => hierarchyChanged?.Invoke();
        public static void ExitPlaymode() => Application.Quit();
        public static void Exit(int returnValue) => Application.Quit(returnValue);
        /// <summary>In edit mode, at the next update; in play mode it runs in any case.</summary>
        public static void QueuePlayerLoopUpdate() => EditMode.IsLoopQueued = EditMode.IsOn;
        public static void RepaintHierarchyWindow() { }
        public static void RepaintProjectWindow() { }
    }

    public enum PlayModeStateChange { EnteredEditMode = 0, ExitingEditMode = 1, EnteredPlayMode = 2, ExitingPlayMode = 3 }

    public sealed class EditorUtility
    {
        static readonly HashSet<int> dirty = new HashSet<int>();

        static readonly Dictionary<int, int> edits = new Dictionary<int, int>();

        public static void SetDirty(Object target)
        {
            dirty.Add(target.GetInstanceID());
            edits[target.GetInstanceID()] = GetDirtyCount(target) + 1;
        }

        /// <summary>How often it was marked as changed.</summary>
        public static int GetDirtyCount(Object target) => edits.TryGetValue(target.GetInstanceID(), out int count) ? count : 0;
        public static void ClearDirty(Object target) => dirty.Remove(target.GetInstanceID());
        public static bool IsDirty(Object target) => dirty.Contains(target.GetInstanceID());
        public static bool IsPersistent(Object target) => Object.IsAlive(target) && target.IsAsset;
        public static void CopySerialized(Object source, Object dest) => SerializedCopy.Into(source, dest, null);
        public static void DisplayProgressBar(string title, string info, float progress) { }
        public static bool DisplayCancelableProgressBar(string title, string info, float progress) => false;
        public static void ClearProgressBar() { }
        /// <summary>No desktop is there to open a file: it is logged.</summary>
        public static void OpenWithDefaultApp(string fileName) => Debug.Log($"EditorUtility.OpenWithDefaultApp: {fileName}");

        /// <summary>Nobody is there to answer: what the dialog says goes to the log, and the answer is cancel.</summary>
        public static bool DisplayDialog(string title, string message, string ok) => DisplayDialog(title, message, ok, "");

        public static bool DisplayDialog(string title, string message, string ok, string cancel)
        {
            Debug.LogWarning($"{title}: {message}");
            return cancel.Length == 0;
        }

        public static string SaveFilePanelInProject(string title, string defaultName, string extension, string message) => "";
        public static string SaveFilePanel(string title, string directory, string defaultName, string extension) => "";
        public static string OpenFilePanel(string title, string directory, string extension) => "";
        public static string FormatBytes(long bytes) => bytes < 1024 ? $"{bytes} B" : bytes < 1048576 ? $"{bytes / 1024.0:F1} KB"
            : $"{bytes / 1048576.0:F1} MB";
    }

    public sealed class Selection
    {
        static Object[] selected = Array.Empty<Object>();

        public static Action selectionChanged;

        public static Object[] objects
        {
            get => selected.Where(o => o).ToArray();
            set
            {
                selected = value ?? Array.Empty<Object>();
                selectionChanged?.Invoke();
            }
        }

        public static Object activeObject { get => objects.FirstOrDefault(); set => objects = value ? new[] { value } : null; }
        public static GameObject activeGameObject { get => activeObject as GameObject; set => activeObject = value; }
        public static Transform activeTransform { get => activeGameObject ? activeGameObject.transform : null; set => activeObject = value
            ? value.gameObject : null; }
        public static GameObject[] gameObjects => objects.OfType<GameObject>().ToArray();
        public static int count => objects.Length;
        public static bool Contains(Object obj) => Array.IndexOf(objects, obj) >= 0;
    }

    /// <summary>None is open here, unless a test opens one. It draws nothing.</summary>
    public class SceneView
    {
        internal SceneView() { }
        public static SceneView lastActiveSceneView { get; internal set; }
        public Vector3 pivot { get; set; }

        /// <summary>Bounds that it was last told to show.</summary>
        internal Bounds Framed { get; private set; }

        public bool Frame(Bounds bounds, bool instant = true)
        {
            Framed = bounds;
            pivot = bounds.center;
            return true;
        }

        public static void RepaintAll() { }
    }
}
