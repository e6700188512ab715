using System;
using System.Collections.Generic;
using UnityEngine.Headless;

namespace UnityEngine
{
    public class Component : Object
    {
        /// <summary>Readable even after destruction, unlike <see cref="gameObject"/>.</summary>
        [NonSerialized] internal GameObject Owner;
        /// <summary>Between <see cref="OnActivated"/> and <see cref="OnDeactivated"/>.</summary>
        [NonSerialized] internal bool Activated;

        public GameObject gameObject { get { ThrowIfDestroyed(); return Owner; } }
        public Transform transform { get { ThrowIfDestroyed(); return Owner.TransformOf; } }
        public string tag { get => gameObject.tag; set => gameObject.tag = value; }
        public bool CompareTag(string tag) => gameObject.CompareTag(tag);
        public int GetComponentIndex() => gameObject.GetComponentIndex(this);

        internal override string NameOf
        {
            get => Owner is object ? Owner.NameOf : "";
            set { if (Owner is object) Owner.NameOf = value; }
        }

        /// <summary>For the engine's own components, as OnEnable and OnDisable are for scripts.</summary>
        internal virtual void OnActivated() { }
        internal virtual void OnDeactivated() { }
        /// <summary>Whether the component itself wants to be active; Behaviours ask their enabled flag.</summary>
        internal virtual bool WantsActive => true;
        /// <summary>After Instantiate has copied the fields.</summary>
        internal virtual void OnCopied(Component source) { }

        public Component GetComponent(Type type) => gameObject.GetComponent(type);
        public Component GetComponent(string type) => gameObject.GetComponent(type);
        public T GetComponent<T>() => gameObject.GetComponent<T>();
        public bool TryGetComponent(Type type, out Component component) => gameObject.TryGetComponent(type, out component);
        public bool TryGetComponent<T>(out T component) => gameObject.TryGetComponent(out component);
        public Component[] GetComponents(Type type) => gameObject.GetComponents(type);
        public T[] GetComponents<T>() => gameObject.GetComponents<T>();
        public void GetComponents(Type type, List<Component> results) => gameObject.GetComponents(type, results);
        public void GetComponents<T>(List<T> results) => gameObject.GetComponents(results);

        public Component GetComponentInChildren(Type t) => gameObject.GetComponentInChildren(t);
        public Component GetComponentInChildren(Type t, bool includeInactive) => gameObject.GetComponentInChildren(t, includeInactive);
        public T GetComponentInChildren<T>() => gameObject.GetComponentInChildren<T>();
        public T GetComponentInChildren<T>(bool includeInactive) => gameObject.GetComponentInChildren<T>(includeInactive);
        public Component[] GetComponentsInChildren(Type t) => gameObject.GetComponentsInChildren(t);
        public Component[] GetComponentsInChildren(Type t, bool includeInactive) => gameObject.GetComponentsInChildren(t, includeInactive);
        public T[] GetComponentsInChildren<T>() => gameObject.GetComponentsInChildren<T>();
        public T[] GetComponentsInChildren<T>(bool includeInactive) => gameObject.GetComponentsInChildren<T>(includeInactive);
        public void GetComponentsInChildren<T>(List<T> results) => gameObject.GetComponentsInChildren(results);
        public void GetComponentsInChildren<T>(bool includeInactive, List<T> result) => gameObject.GetComponentsInChildren(includeInactive, result);

        public Component GetComponentInParent(Type t) => gameObject.GetComponentInParent(t);
        public Component GetComponentInParent(Type t, bool includeInactive) => gameObject.GetComponentInParent(t, includeInactive);
        public T GetComponentInParent<T>() => gameObject.GetComponentInParent<T>();
        public T GetComponentInParent<T>(bool includeInactive) => gameObject.GetComponentInParent<T>(includeInactive);
        public Component[] GetComponentsInParent(Type t) => gameObject.GetComponentsInParent(t);
        public Component[] GetComponentsInParent(Type t, bool includeInactive) => gameObject.GetComponentsInParent(t, includeInactive);
        public T[] GetComponentsInParent<T>() => gameObject.GetComponentsInParent<T>();
        public T[] GetComponentsInParent<T>(bool includeInactive) => gameObject.GetComponentsInParent<T>(includeInactive);
        public void GetComponentsInParent<T>(bool includeInactive, List<T> results) => gameObject.GetComponentsInParent(includeInactive, results);

        public void SendMessage(string methodName) => gameObject.SendMessage(methodName);
        public void SendMessage(string methodName, SendMessageOptions options) => gameObject.SendMessage(methodName, options);
        public void SendMessage(string methodName, object value) => gameObject.SendMessage(methodName, value);
        public void SendMessage(string methodName, object value, SendMessageOptions options) => gameObject.SendMessage(methodName, value, options);
        public void SendMessageUpwards(string methodName) => gameObject.SendMessageUpwards(methodName);
        public void SendMessageUpwards(string methodName, SendMessageOptions options) => gameObject.SendMessageUpwards(methodName, options);
        public void SendMessageUpwards(string methodName, object value) => gameObject.SendMessageUpwards(methodName, value);
        public void SendMessageUpwards(string methodName, object value, SendMessageOptions options)
            => gameObject.SendMessageUpwards(methodName, value, options);
        public void BroadcastMessage(string methodName) => gameObject.BroadcastMessage(methodName);
        public void BroadcastMessage(string methodName, SendMessageOptions options) => gameObject.BroadcastMessage(methodName, options);
        public void BroadcastMessage(string methodName, object parameter) => gameObject.BroadcastMessage(methodName, parameter);
        public void BroadcastMessage(string methodName, object parameter, SendMessageOptions options)
            => gameObject.BroadcastMessage(methodName, parameter, options);
    }

    public class Behaviour : Component
    {
        bool m_Enabled = true;

        public bool enabled
        {
            get { ThrowIfDestroyed(); return m_Enabled; }
            set
            {
                ThrowIfDestroyed();
                if (m_Enabled == value)
                    return;
                m_Enabled = value;
                Lifecycle.Refresh(this);
            }
        }

        public bool isActiveAndEnabled => !Destroyed && m_Enabled && Owner is object && Owner.activeInHierarchy;
        internal override bool WantsActive => m_Enabled;
        /// <summary>For loaders: no messages.</summary>
        internal void SetEnabledSilently(bool value) => m_Enabled = value;
    }

    public enum SendMessageOptions { RequireReceiver = 0, DontRequireReceiver = 1 }
}
