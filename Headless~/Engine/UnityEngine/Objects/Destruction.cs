using System;
using System.Collections.Generic;
using System.Reflection;

namespace UnityEngine.Headless
{
    /// <summary>Destroy and DestroyImmediate: who may go, in which order, and what is told.</summary>
    internal static class Destruction
    {
        struct Pending { public Object Object; public double Due; }

        static readonly List<Pending> pending = new List<Pending>();

        /// <summary>Marks for the end of this frame's updates, t seconds from now.</summary>
        public static void Request(Object o, float t)
        {
            if (!Object.IsAlive(o) || !Allowed(o, false))
                return;
            if (EditMode.IsOn)
            {
                Debug.LogError("Destroy may not be called from edit mode! Use DestroyImmediate instead.\n" +
                    "Destroying an object in edit mode destroys it permanently.", o);
                return;
            }
            pending.Add(new Pending { Object = o, Due = t > 0 ? Time.timeAsDouble + t : double.NegativeInfinity });
        }

        public static void RunPending()
        {
            // A handler may ask for more: those with no delay go in this same pass.
            for (int i = 0; i < pending.Count; i++)
            {
                if (pending[i].Due > Time.timeAsDouble)
                    continue;
                Object o = pending[i].Object;
                pending.RemoveAt(i--);
                if (Object.IsAlive(o))
                    Destroy(o);
            }
        }

        public static void ForgetPending() => pending.Clear();

        public static void Now(Object o, bool assetsToo)
        {
            if (o is GameObject part && Object.IsAlive(part) && IsInsidePrefabInstance(part))
                throw new InvalidOperationException("Destroying a GameObject inside a Prefab instance is not allowed.");
            if (Object.IsAlive(o) && Allowed(o, assetsToo))
                Destroy(o);
        }

        /// <summary>Whether a prefab has the GameObject below another, so that edit mode keeps it there. Play mode knows no prefabs.</summary>
        internal static bool IsInsidePrefabInstance(GameObject part) => EditMode.IsOn && part.SceneOf != null && part.PrefabInstance != 0
            && part.TransformOf.ParentOf is Transform parent && parent.Owner.PrefabInstance == part.PrefabInstance;

        static bool Allowed(Object o, bool assetsToo)
        {
            if (o.IsAsset && !assetsToo)
            {
                Debug.LogError($"Destroying assets is not permitted to avoid data loss.\nIf you really want to remove an asset use " +
                    $"DestroyImmediate (theObject, true); ('{o.NameOf}', a {o.GetType().Name})", o);
                return false;
            }
            if (o is Transform transform)
            {
                Debug.LogError($"Can't destroy {o.GetType().Name} component of '{transform.NameOf}'. If you want to destroy the game " +
                    $"object, please call 'Destroy' on the game object instead. Destroying the {o.GetType().Name} component is not allowed.", o);
                return false;
            }
            if (o is Component component && DependentOf(component) is Component dependent)
            {
                Debug.LogError($"Can't remove {o.GetType().Name} ({o.GetType().Name}) because {dependent.GetType().Name} " +
                    $"({dependent.GetType().Name}) depends on it", o);
                return false;
            }
            return true;
        }

        static Component DependentOf(Component needed)
        {
            foreach (Component other in needed.Owner.Components)
            {
                if (ReferenceEquals(other, needed) || pending.Exists(p => ReferenceEquals(p.Object, other)))
                    continue;
                foreach (RequireComponent require in other.GetType().GetCustomAttributes<RequireComponent>(true))
                    foreach (Type type in require.Types)
                        if (type.IsInstanceOfType(needed) && needed.Owner.Components.FindAll(c => type.IsInstanceOfType(c)).Count == 1)
                            return other;
            }
            return null;
        }

        static void Destroy(Object o)
        {
            switch (o)
            {
                case GameObject go:
                    DestroyTree(go);
                    break;
                case Component component:
                    Lifecycle.Deactivate(component);
                    Lifecycle.RaiseDestroyed(component);
                    component.Owner.Components.Remove(component);
                    Finish(component);
                    break;
                case ScriptableObject asset:
                    Lifecycle.RaiseDestroyed(asset);
                    Finish(asset);
                    break;
                default:
                    Finish(o);
                    break;
            }
        }

        // All of the tree is disabled first, then told that it is destroyed, then gone.
        static void DestroyTree(GameObject root)
        {
            if (root.BeingDestroyed)
                return;
            var tree = new List<GameObject>();
            root.transform.CollectTree(tree);
            foreach (GameObject go in tree)
                go.BeingDestroyed = true;
            foreach (GameObject go in tree)
                foreach (Component component in go.Components.ToArray())
                    Lifecycle.Deactivate(component);
            foreach (GameObject go in tree)
                foreach (Component component in go.Components.ToArray())
                    Lifecycle.RaiseDestroyed(component);

            root.transform.Detach();
            for (int i = tree.Count - 1; i >= 0; i--)
            {
                foreach (Component component in tree[i].Components.ToArray())
                    Finish(component);
                Finish(tree[i]);
            }
        }

        static void Finish(Object o)
        {
            if (o.Destroyed)
                return;
            o.ReleaseNative();
            o.Destroyed = true;
            ObjectRegistry.Remove(o);
        }
    }
}
