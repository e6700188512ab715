using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using UnityEngine.SceneManagement;

namespace UnityEngine.Headless
{
    /// <summary>For loaders: objects are made asleep, filled, and woken together.</summary>
    internal static class ObjectFactory
    {
        [ThreadStatic] static int constructing;

        /// <summary>Whether the engine, not a script, is running a constructor of a Unity object.</summary>
        public static bool Constructing => constructing > 0;

        /// <summary>A sleeping root object; an invalid scene makes a prefab asset, which never wakes.</summary>
        public static GameObject CreateGameObject(string name, Scene scene) => new GameObject(name, scene.Data, true);

        /// <summary>No messages, no required components; a Transform is there already.</summary>
        public static Component AddComponent(GameObject go, Type type)
        {
            if (typeof(Transform).IsAssignableFrom(type))
                return type == typeof(Transform) ? go.TransformOf : ReplaceTransform(go, type);
            return Construct(type, go);
        }

        // A RectTransform replaces the Transform that every object starts with.
        static Component ReplaceTransform(GameObject go, Type type)
        {
            Transform old = go.TransformOf;
            if (old.ParentOf is object || old.Children.Count > 0)
                throw new InvalidOperationException($"'{go.NameOf}' must get its {type.Name} before it is placed in a hierarchy.");
            go.Components.Remove(old);
            old.Destroyed = true;
            ObjectRegistry.Remove(old);
            Component made = Construct(type, go);
            go.TransformOf = (Transform)made;
            go.Components.Remove(made);
            go.Components.Insert(0, made);
            return made;
        }

        public static ScriptableObject CreateScriptableObject(Type type) => (ScriptableObject)New(type);

        internal static Component Construct(Type type, GameObject owner)
        {
            Component component = (Component)New(type);
            component.Owner = owner;
            component.IsAsset = owner.IsAsset;
            owner.Components.Add(component);
            return component;
        }

        static object New(Type type)
            => Constructed(() => Activator.CreateInstance(type, BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic, null, null,
                null));

        /// <summary>Runs the constructor on an object that is there.</summary>
        internal static void Construct(Object made)
            => Constructed(() => made.GetType().GetConstructor(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic, null,
                Type.EmptyTypes, null)?.Invoke(made, null));

        static object Constructed(Func<object> construct)
        {
            constructing++;
            try
            {
                return construct();
            }
            catch (TargetInvocationException e)
            {
                System.Runtime.ExceptionServices.ExceptionDispatchInfo.Capture(e.InnerException ?? e).Throw();
                throw;
            }
            finally
            {
                constructing--;
            }
        }

        /// <summary>Ends the sleep of whole trees: OnValidate for all as the Editor does, then Awake and OnEnable, object by object in
        /// execution order.</summary>
        public static void Wake(IEnumerable<GameObject> roots)
        {
            var tree = new List<GameObject>();
            foreach (GameObject root in roots)
                root.transform.CollectTree(tree);
            foreach (GameObject go in tree)
                go.Asleep = false;
            List<Component> components = tree.Where(go => go.SceneOf != null).SelectMany(go => go.Components).ToList();
            Lifecycle.Validate(components);
            Lifecycle.WakeAll(components);
        }

        /// <summary>A filled asset: OnValidate, Awake, OnEnable.</summary>
        public static void Wake(ScriptableObject asset)
        {
            Lifecycle.Validate(asset);
            Lifecycle.Wake(asset);
        }

        internal static void WakeCopy(GameObject root)
        {
            var tree = new List<GameObject>();
            root.transform.CollectTree(tree);
            foreach (GameObject go in tree)
                go.Asleep = false;
            Lifecycle.WakeAll(tree.SelectMany(go => go.Components).ToList());
        }
    }
}
