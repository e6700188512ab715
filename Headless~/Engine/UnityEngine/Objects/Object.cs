using System;
using System.Collections.Generic;
using UnityEngine.Headless;
using UnityEngine.SceneManagement;

namespace UnityEngine
{
    /// <summary>Base of everything that has an instance id and can be destroyed; a destroyed object equals null.</summary>
    public partial class Object
    {
        readonly int instanceId;
        string objectName = "";
        [NonSerialized] internal bool Destroyed;
        /// <summary>Belongs to a project's files: Destroy refuses it, scene changes leave it alone.</summary>
        [NonSerialized] internal bool IsAsset;

        public Object()
        {
            instanceId = ObjectRegistry.Add(this);
        }

        public HideFlags hideFlags { get; set; }

        public string name
        {
            get { ThrowIfDestroyed(); return NameOf; }
            set { ThrowIfDestroyed(); NameOf = value ?? ""; }
        }

        /// <summary>The instance of a prefab that this is a part of, in a scene; 0 for what is not, or was added to one.</summary>
        [NonSerialized] internal long PrefabInstance;

        /// <summary>Components answer with their GameObject's name.</summary>
        internal virtual string NameOf { get => objectName; set => objectName = value; }

        public int GetInstanceID() => instanceId;

        public override string ToString() => Destroyed ? "null" : $"{NameOf} ({GetType().FullName})";
        public override bool Equals(object other) => other is Object o ? Same(this, o) : other == null && Destroyed;
        public override int GetHashCode() => instanceId;
        public static bool operator ==(Object x, Object y) => Same(x, y);
        public static bool operator !=(Object x, Object y) => !Same(x, y);
        public static implicit operator bool(Object exists) => IsAlive(exists);

        static bool Same(Object x, Object y)
        {
            if (ReferenceEquals(x, y))
                return true;
            return !IsAlive(x) && !IsAlive(y);
        }

        internal static bool IsAlive(Object x) => x is object && !x.Destroyed;

        internal void ThrowIfDestroyed()
        {
            if (Destroyed)
                throw new MissingReferenceException($"The object of type '{GetType().Name}' has been destroyed but you are still " +
                    $"trying to access it.\nYour script should either check if it is null or you should not destroy the object.");
        }

        /// <summary>Called once when the object is destroyed: gives back what it holds outside of managed memory.</summary>
        internal virtual void ReleaseNative() { }

        /// <summary>A second object with the same content, for Instantiate; its name is set by the caller.</summary>
        internal virtual Object CloneNative()
            => throw new NotSupportedException($"Instantiate: the headless host cannot copy '{NameOf}', a {GetType().FullName}.");

        // ---- destruction
        public static void Destroy(Object obj) => Destroy(obj, 0);
        public static void Destroy(Object obj, float t) => Destruction.Request(obj, t);
        public static void DestroyImmediate(Object obj) => DestroyImmediate(obj, false);
        public static void DestroyImmediate(Object obj, bool allowDestroyingAssets) => Destruction.Now(obj, allowDestroyingAssets);
        public static void DontDestroyOnLoad(Object target) => SceneManager.MoveToDontDestroyOnLoad(target);

        // ---- copies
        public static Object Instantiate(Object original) => Instantiation.Clone(original, null, false);
        public static Object Instantiate(Object original, Scene scene) => Instantiation.CloneInto(original, scene);
        public static Object Instantiate(Object original, Transform parent) => Instantiation.Clone(original, parent, false);
        public static Object Instantiate(Object original, Transform parent, bool instantiateInWorldSpace)
            => Instantiation.Clone(original, parent, instantiateInWorldSpace);
        public static Object Instantiate(Object original, Vector3 position, Quaternion rotation)
            => Instantiation.CloneAt(original, position, rotation, null);
        public static Object Instantiate(Object original, Vector3 position, Quaternion rotation, Transform parent)
            => Instantiation.CloneAt(original, position, rotation, parent);
        public static T Instantiate<T>(T original) where T : Object => (T)Instantiate((Object)original);
        public static T Instantiate<T>(T original, Transform parent) where T : Object => (T)Instantiate((Object)original, parent);
        public static T Instantiate<T>(T original, Transform parent, bool worldPositionStays) where T : Object
            => (T)Instantiate((Object)original, parent, worldPositionStays);
        public static T Instantiate<T>(T original, Vector3 position, Quaternion rotation) where T : Object
            => (T)Instantiate((Object)original, position, rotation);
        public static T Instantiate<T>(T original, Vector3 position, Quaternion rotation, Transform parent) where T : Object
            => (T)Instantiate((Object)original, position, rotation, parent);

        // ---- search
        public static Object FindAnyObjectByType(Type type) => First(ObjectSearch.InScenes(type, false));
        public static Object FindAnyObjectByType(Type type, FindObjectsInactive findObjectsInactive)
            => First(ObjectSearch.InScenes(type, findObjectsInactive == FindObjectsInactive.Include));
        public static Object FindFirstObjectByType(Type type) => FindAnyObjectByType(type);
        public static Object FindFirstObjectByType(Type type, FindObjectsInactive findObjectsInactive)
            => FindAnyObjectByType(type, findObjectsInactive);
        public static Object[] FindObjectsByType(Type type, FindObjectsSortMode sortMode)
            => FindObjectsByType(type, FindObjectsInactive.Exclude, sortMode);

        public static Object[] FindObjectsByType(Type type, FindObjectsInactive findObjectsInactive, FindObjectsSortMode sortMode)
            => ObjectSearch.InScenes(type, findObjectsInactive == FindObjectsInactive.Include).ToArray();

        public static T FindAnyObjectByType<T>() where T : Object => (T)FindAnyObjectByType(typeof(T));
        public static T FindAnyObjectByType<T>(FindObjectsInactive findObjectsInactive) where T : Object
            => (T)FindAnyObjectByType(typeof(T), findObjectsInactive);
        public static T FindFirstObjectByType<T>() where T : Object => (T)FindAnyObjectByType(typeof(T));
        public static T FindFirstObjectByType<T>(FindObjectsInactive findObjectsInactive) where T : Object
            => (T)FindAnyObjectByType(typeof(T), findObjectsInactive);
        public static T[] FindObjectsByType<T>(FindObjectsSortMode sortMode) where T : Object
            => FindObjectsByType<T>(FindObjectsInactive.Exclude, sortMode);
        public static T[] FindObjectsByType<T>(FindObjectsInactive findObjectsInactive, FindObjectsSortMode sortMode) where T : Object
            => Array.ConvertAll(FindObjectsByType(typeof(T), findObjectsInactive, sortMode), o => (T)o);

        public static Object FindObjectOfType(Type type) => FindAnyObjectByType(type);
        public static Object FindObjectOfType(Type type, bool includeInactive) => First(ObjectSearch.InScenes(type, includeInactive));
        public static Object[] FindObjectsOfType(Type type) => FindObjectsOfType(type, false);
        public static Object[] FindObjectsOfType(Type type, bool includeInactive) => ObjectSearch.InScenes(type, includeInactive).ToArray();
        public static T FindObjectOfType<T>() where T : Object => (T)FindObjectOfType(typeof(T));
        public static T FindObjectOfType<T>(bool includeInactive) where T : Object => (T)FindObjectOfType(typeof(T), includeInactive);
        public static T[] FindObjectsOfType<T>() where T : Object => FindObjectsOfType<T>(false);
        public static T[] FindObjectsOfType<T>(bool includeInactive) where T : Object
            => Array.ConvertAll(FindObjectsOfType(typeof(T), includeInactive), o => (T)o);

        static Object First(List<Object> found) => found.Count > 0 ? found[0] : null;
    }

    [Flags]
    public enum HideFlags
    {
        None = 0,
        HideInHierarchy = 1,
        HideInInspector = 2,
        DontSaveInEditor = 4,
        NotEditable = 8,
        DontSaveInBuild = 16,
        DontUnloadUnusedAsset = 32,
        DontSave = DontSaveInEditor | DontSaveInBuild | DontUnloadUnusedAsset,
        HideAndDontSave = HideInHierarchy | DontSave | NotEditable,
    }

    public enum FindObjectsSortMode { None = 0, InstanceID = 1 }
    public enum FindObjectsInactive { Exclude = 0, Include = 1 }
}
