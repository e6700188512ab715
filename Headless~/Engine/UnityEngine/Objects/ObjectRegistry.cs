using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.SceneManagement;

namespace UnityEngine.Headless
{
    /// <summary>Every object that is alive, by instance id. Objects stay until destroyed, as Unity's do.</summary>
    internal static class ObjectRegistry
    {
        static readonly Dictionary<int, Object> alive = new Dictionary<int, Object>();
        static int lastId;

        // Negative ids, as Unity gives to objects made at run time.
        public static int Add(Object o)
        {
            lock (alive)
            {
                int id = --lastId;
                alive.Add(id, o);
                return id;
            }
        }

        public static void Remove(Object o)
        {
            lock (alive)
                alive.Remove(o.GetInstanceID());
        }

        public static Object Find(int id)
        {
            lock (alive)
                return alive.TryGetValue(id, out Object o) ? o : null;
        }

        /// <summary>Oldest first.</summary>
        public static List<Object> All(Type type)
        {
            lock (alive)
                return alive.Values.Where(o => type.IsInstanceOfType(o) && !o.Destroyed).OrderByDescending(o => o.GetInstanceID()).ToList();
        }
    }

    internal static class ObjectSearch
    {
        /// <summary>GameObjects and components in loaded scenes, in hierarchy order; other types among all that are alive.</summary>
        public static List<Object> InScenes(Type type, bool includeInactive)
        {
            var found = new List<Object>();
            if (!typeof(Component).IsAssignableFrom(type) && type != typeof(GameObject) && !type.IsInterface && type != typeof(Object))
            {
                found.AddRange(ObjectRegistry.All(type).Where(o => !o.IsAsset && (o.hideFlags & HideFlags.DontSave) != HideFlags.DontSave));
                return found;
            }
            foreach (SceneData scene in SceneManager.Loaded)
                foreach (GameObject root in scene.Roots)
                    Collect(root, type, includeInactive, found);
            return found;
        }

        static void Collect(GameObject go, Type type, bool includeInactive, List<Object> found)
        {
            if (!includeInactive && !go.activeInHierarchy)
                return;
            if ((go.hideFlags & HideFlags.DontSave) != HideFlags.DontSave)
            {
                if (type.IsInstanceOfType(go))
                    found.Add(go);
                foreach (Component component in go.Components)
                    if (type.IsInstanceOfType(component))
                        found.Add(component);
            }
            foreach (Transform child in go.transform.Children)
                Collect(child.gameObject, type, includeInactive, found);
        }
    }
}
