using System;
using System.Collections.Generic;
using System.Reflection;
using UnityEngine.Headless;
using UnityEngine.SceneManagement;

namespace UnityEngine
{
    public sealed partial class GameObject : Object
    {
        [NonSerialized] internal readonly List<Component> Components = new List<Component>();
        [NonSerialized] internal Transform TransformOf;
        /// <summary>Null for prefab assets, which never wake.</summary>
        [NonSerialized] internal SceneData SceneOf;
        /// <summary>Under construction by a loader or Instantiate: no messages yet.</summary>
        [NonSerialized] internal bool Asleep;
        [NonSerialized] internal bool BeingDestroyed;
        bool m_IsActive = true;
        int m_Layer;
        string m_TagString = "Untagged";

        public GameObject() : this("New Game Object") { }

        public GameObject(string name) : this(name, SceneManager.Active, false) { }

        public GameObject(string name, params Type[] components) : this(name)
        {
            foreach (Type type in components)
                AddComponent(type);
        }

        internal GameObject(string name, SceneData scene, bool asleep)
        {
            NameOf = name ?? "";
            Asleep = asleep;
            SceneOf = scene;
            IsAsset = scene == null;
            TransformOf = (Transform)ObjectFactory.Construct(typeof(Transform), this);
            scene?.Roots.Add(this);
        }

        public Transform transform { get { ThrowIfDestroyed(); return TransformOf; } }
        public GameObject gameObject { get { ThrowIfDestroyed(); return this; } }
        public Scene scene { get { ThrowIfDestroyed(); return new Scene(SceneOf); } }
        public int layer
        {
            get => m_Layer;
            set => m_Layer = value >= 0 && value <= 31 ? value
                : throw new UnityException("A game object can only be in one layer. The layer needs to be in the range [0...31]");
        }
        public bool isStatic { get; set; }
        public ulong sceneCullingMask => ulong.MaxValue;

        public string tag { get => m_TagString; set => m_TagString = string.IsNullOrEmpty(value) ? "Untagged" : value; }
        public bool CompareTag(string tag) => m_TagString == tag;

        public bool activeSelf { get { ThrowIfDestroyed(); return m_IsActive; } }

        public bool activeInHierarchy
        {
            get
            {
                ThrowIfDestroyed();
                if (SceneOf == null)
                    return false;
                for (Transform t = TransformOf; t is object; t = t.ParentOf)
                    if (!t.Owner.m_IsActive)
                        return false;
                return true;
            }
        }

        public void SetActive(bool value)
        {
            ThrowIfDestroyed();
            if (m_IsActive == value)
                return;
            m_IsActive = value;
            Lifecycle.RefreshTree(this);
        }

        /// <summary>For loaders: no messages.</summary>
        internal void SetActiveSilently(bool value) => m_IsActive = value;

        // ---- components
        public T AddComponent<T>() where T : Component => (T)AddComponent(typeof(T));

        public Component AddComponent(Type componentType)
        {
            ThrowIfDestroyed();
            if (componentType == null || !typeof(Component).IsAssignableFrom(componentType))
                throw new ArgumentException($"AddComponent: {componentType?.FullName ?? "null"} is not a Component.");
            if (componentType.IsAbstract || componentType.ContainsGenericParameters || componentType == typeof(Component)
                || componentType == typeof(Behaviour) || componentType == typeof(MonoBehaviour))
            {
                Debug.LogError($"Can't add component because class '{componentType.Name}' is abstract or an engine base class!", this);
                return null;
            }
            if (typeof(Transform).IsAssignableFrom(componentType))
            {
                Debug.LogError(
                    $"Can't add component '{componentType.Name}' to {NameOf} because such a component is already added to the game object!",
                    this);
                return null;
            }
            foreach (Component other in Components)
                if (componentType.GetCustomAttribute<DisallowMultipleComponent>(true) != null
                    && (componentType.IsInstanceOfType(other) || other.GetType().IsAssignableFrom(componentType)
                    && other.GetType().GetCustomAttribute<DisallowMultipleComponent>(true) != null))
                {
                    Debug.LogError($"Can't add component '{componentType.Name}' to {NameOf} because such a component is already added " +
                        $"to the game object!", this);
                    return null;
                }

            foreach (RequireComponent require in componentType.GetCustomAttributes<RequireComponent>(true))
                foreach (Type needed in require.Types)
                    if (!needed.IsAbstract && !Has(needed))
                        AddComponent(needed);

            Component component = ObjectFactory.Construct(componentType, this);
            Lifecycle.Wake(component);
            return component;
        }

        bool Has(Type type) => Components.Exists(type.IsInstanceOfType);

        public Component GetComponent(Type type)
        {
            ThrowIfDestroyed();
            foreach (Component component in Components)
                if (type.IsInstanceOfType(component))
                    return component;
            return null;
        }

        public Component GetComponent(string type)
        {
            ThrowIfDestroyed();
            return Components.Find(c => c.GetType().Name == type || c.GetType().FullName == type);
        }

        public T GetComponent<T>() => (T)(object)GetComponent(typeof(T));

        public bool TryGetComponent(Type type, out Component component) => (component = GetComponent(type)) is object;

        public bool TryGetComponent<T>(out T component)
        {
            object found = GetComponent(typeof(T));
            component = (T)found;
            return found != null;
        }

        public int GetComponentCount() => Components.Count;
        public int GetComponentIndex(Component component) => Components.IndexOf(component);
        public Component GetComponentAtIndex(int index) => Components[index];
        public T GetComponentAtIndex<T>(int index) where T : Component => (T)Components[index];

        public Component[] GetComponents(Type type) => Gather<Component>(type, Reach.Self, true).ToArray();
        public T[] GetComponents<T>() => Gather<T>(typeof(T), Reach.Self, true).ToArray();
        public void GetComponents(Type type, List<Component> results) => Replace(results, Gather<Component>(type, Reach.Self, true));
        public void GetComponents<T>(List<T> results) => Replace(results, Gather<T>(typeof(T), Reach.Self, true));

        public Component GetComponentInChildren(Type type) => GetComponentInChildren(type, false);
        public Component GetComponentInChildren(Type type, bool includeInactive) => First(Gather<Component>(type, Reach.Children, includeInactive));
        public T GetComponentInChildren<T>() => GetComponentInChildren<T>(false);
        public T GetComponentInChildren<T>(bool includeInactive) => First(Gather<T>(typeof(T), Reach.Children, includeInactive));
        public Component[] GetComponentsInChildren(Type type) => GetComponentsInChildren(type, false);
        public Component[] GetComponentsInChildren(Type type, bool includeInactive)
            => Gather<Component>(type, Reach.Children, includeInactive).ToArray();
        public T[] GetComponentsInChildren<T>() => GetComponentsInChildren<T>(false);
        public T[] GetComponentsInChildren<T>(bool includeInactive) => Gather<T>(typeof(T), Reach.Children, includeInactive).ToArray();
        public void GetComponentsInChildren<T>(List<T> results) => GetComponentsInChildren(false, results);
        public void GetComponentsInChildren<T>(bool includeInactive, List<T> results)
            => Replace(results, Gather<T>(typeof(T), Reach.Children, includeInactive));

        public Component GetComponentInParent(Type type) => GetComponentInParent(type, false);
        public Component GetComponentInParent(Type type, bool includeInactive) => First(Gather<Component>(type, Reach.Parents, includeInactive));
        public T GetComponentInParent<T>() => GetComponentInParent<T>(false);
        public T GetComponentInParent<T>(bool includeInactive) => First(Gather<T>(typeof(T), Reach.Parents, includeInactive));
        public Component[] GetComponentsInParent(Type type) => GetComponentsInParent(type, false);
        public Component[] GetComponentsInParent(Type type, bool includeInactive)
            => Gather<Component>(type, Reach.Parents, includeInactive).ToArray();
        public T[] GetComponentsInParent<T>() => GetComponentsInParent<T>(false);
        public T[] GetComponentsInParent<T>(bool includeInactive) => Gather<T>(typeof(T), Reach.Parents, includeInactive).ToArray();
        public void GetComponentsInParent<T>(bool includeInactive, List<T> results)
            => Replace(results, Gather<T>(typeof(T), Reach.Parents, includeInactive));

        enum Reach { Self, Children, Parents }

        List<T> Gather<T>(Type type, Reach reach, bool includeInactive)
        {
            ThrowIfDestroyed();
            var found = new List<T>();
            if (reach == Reach.Parents)
            {
                for (Transform t = TransformOf; t is object; t = t.ParentOf)
                    if (includeInactive || t.Owner.activeInHierarchy)
                        t.Owner.AppendOwn(type, found);
            }
            else
                AppendTree(type, reach, includeInactive, found);
            return found;
        }

        void AppendTree<T>(Type type, Reach reach, bool includeInactive, List<T> found)
        {
            if (!includeInactive && !activeInHierarchy)
                return;
            AppendOwn(type, found);
            if (reach == Reach.Children)
                foreach (Transform child in TransformOf.Children)
                    child.Owner.AppendTree(type, reach, includeInactive, found);
        }

        void AppendOwn<T>(Type type, List<T> found)
        {
            foreach (Component component in Components)
                if (type.IsInstanceOfType(component))
                    found.Add((T)(object)component);
        }

        static T First<T>(List<T> found) => found.Count > 0 ? found[0] : default;

        static void Replace<T>(List<T> results, List<T> found)
        {
            results.Clear();
            results.AddRange(found);
        }

        // ---- messages
        public void SendMessage(string methodName) => SendMessage(methodName, null, SendMessageOptions.RequireReceiver);
        public void SendMessage(string methodName, SendMessageOptions options) => SendMessage(methodName, null, options);
        public void SendMessage(string methodName, object value) => SendMessage(methodName, value, SendMessageOptions.RequireReceiver);
        public void SendMessage(string methodName, object value, SendMessageOptions options)
            => Report(methodName, options, Messages.Broadcast(this, methodName, value));

        public void SendMessageUpwards(string methodName) => SendMessageUpwards(methodName, null, SendMessageOptions.RequireReceiver);
        public void SendMessageUpwards(string methodName, SendMessageOptions options) => SendMessageUpwards(methodName, null, options);
        public void SendMessageUpwards(string methodName, object value) => SendMessageUpwards(methodName, value, SendMessageOptions.RequireReceiver);

        public void SendMessageUpwards(string methodName, object value, SendMessageOptions options)
        {
            bool received = false;
            for (Transform t = transform; t is object; t = t.ParentOf)
                received |= Messages.Broadcast(t.Owner, methodName, value);
            Report(methodName, options, received);
        }

        public void BroadcastMessage(string methodName) => BroadcastMessage(methodName, null, SendMessageOptions.RequireReceiver);
        public void BroadcastMessage(string methodName, SendMessageOptions options) => BroadcastMessage(methodName, null, options);
        public void BroadcastMessage(string methodName, object parameter)
            => BroadcastMessage(methodName, parameter, SendMessageOptions.RequireReceiver);

        public void BroadcastMessage(string methodName, object parameter, SendMessageOptions options)
        {
            var tree = new List<GameObject>();
            transform.CollectTree(tree);
            bool received = false;
            foreach (GameObject go in tree)
                if (!go.Destroyed)
                    received |= Messages.Broadcast(go, methodName, parameter);
            Report(methodName, options, received);
        }

        void Report(string methodName, SendMessageOptions options, bool received)
        {
            if (!received && options == SendMessageOptions.RequireReceiver)
                Debug.LogError($"SendMessage {methodName} has no receiver!", this);
        }

        // ---- search
        /// <summary>Active objects only; a name with slashes is a path from a root, or anywhere without a leading slash.</summary>
        public static GameObject Find(string name)
        {
            bool rooted = name.StartsWith("/", StringComparison.Ordinal);
            string[] parts = name.Trim('/').Split('/');
            foreach (Object o in ObjectSearch.InScenes(typeof(GameObject), false))
            {
                Transform t = ((GameObject)o).TransformOf;
                int i = parts.Length - 1;
                while (i >= 0 && t is object && t.NameOf == parts[i])
                {
                    t = t.ParentOf;
                    i--;
                }
                if (i < 0 && (!rooted || t is null))
                    return (GameObject)o;
            }
            return null;
        }

        public static GameObject FindWithTag(string tag) => FindGameObjectWithTag(tag);
        public static GameObject FindGameObjectWithTag(string tag) => Array.Find(FindGameObjectsWithTag(tag), _ => true);

        public static GameObject[] FindGameObjectsWithTag(string tag)
        {
            List<Object> found = ObjectSearch.InScenes(typeof(GameObject), false);
            return found.FindAll(o => ((GameObject)o).CompareTag(tag)).ConvertAll(o => (GameObject)o).ToArray();
        }

        /// <summary>Set by the part that knows meshes and materials.</summary>
        internal static Func<PrimitiveType, GameObject> PrimitiveFactory;

        public static GameObject CreatePrimitive(PrimitiveType type)
            => PrimitiveFactory != null ? PrimitiveFactory(type)
                : throw new NotSupportedException($"GameObject.CreatePrimitive({type}): no graphics are attached to this host.");
    }

    public enum PrimitiveType { Sphere = 0, Capsule = 1, Cylinder = 2, Cube = 3, Plane = 4, Quad = 5 }
}
