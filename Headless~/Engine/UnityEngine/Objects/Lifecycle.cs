using System;
using System.Collections.Generic;
using System.Linq;

namespace UnityEngine.Headless
{
    /// <summary>Awake, OnEnable, OnDisable, OnDestroy: who hears what, when. Start and the updates belong to PlayerLoop.</summary>
    internal static class Lifecycle
    {
        /// <summary>A component that was just added: Awake and OnEnable at once when its object is active.</summary>
        public static void Wake(Component component)
        {
            if (component.Owner.Asleep || !component.Owner.activeInHierarchy || component is MonoBehaviour script && !EditMode.Runs(script))
                return;
            RaiseAwake(component);
            Refresh(component);
        }

        public static void WakeAll(List<Component> components)
        {
            foreach (Component component in InOrder(components))
                if (!component.Destroyed && !component.Owner.BeingDestroyed)
                    Wake(component);
        }

        /// <summary>Stable: equal orders keep the hierarchy's order. The engine's own components come first.</summary>
        static List<Component> InOrder(List<Component> components)
            => components.OrderBy(c => c is MonoBehaviour ? 1 : 0).ThenBy(c => ExecutionOrder.Of(c.GetType())).ToList();

        /// <summary>After the object or one above it was switched on or off, or moved under another parent.</summary>
        public static void RefreshTree(GameObject root)
        {
            if (root.Asleep)
                return;
            var tree = new List<GameObject>();
            root.TransformOf.CollectTree(tree);
            List<Component> components = tree.SelectMany(go => go.Components).ToList();
            if (root.activeInHierarchy)
                WakeAll(components);
            else
                foreach (Component component in components)
                    if (!component.Destroyed && !component.Owner.activeInHierarchy)
                    {
                        Deactivate(component);
                        if (component is MonoBehaviour script)
                            script.StopAllCoroutines();
                    }
        }

        /// <summary>Brings OnEnable/OnDisable in line with the enabled flag and the hierarchy.</summary>
        public static void Refresh(Component component)
        {
            if (component.Owner is null || component.Owner.Asleep || component.Destroyed)
                return;
            bool active = component.WantsActive && component.Owner.activeInHierarchy && !component.Owner.BeingDestroyed;
            if (component is MonoBehaviour script && (!script.Awoken || !EditMode.Runs(script)))
                active = false;     // still in front of Awake: what it set takes effect after
            if (active == component.Activated)
                return;
            if (!active)
            {
                Deactivate(component);
                return;
            }
            component.Activated = true;
            if (component is MonoBehaviour mono)
            {
                PlayerLoop.Enlist(mono);
                mono.SaidEnabled = true;
                Messages.Send(mono, Message.OnEnable);
            }
            else
                Guarded(component.OnActivated, component);
        }

        public static void Deactivate(Component component)
        {
            if (!component.Activated)
                return;
            component.Activated = false;
            if (component is MonoBehaviour script)
            {
                PlayerLoop.Dismiss(script);
                if (EditMode.Runs(script))
                    Messages.Send(script, Message.OnDisable);
            }
            else
                Guarded(component.OnDeactivated, component);
        }

        static void RaiseAwake(Component component)
        {
            if (!(component is MonoBehaviour script) || script.Awoken)
                return;
            script.Awoken = true;
            Messages.Send(script, Message.Awake);
        }

        public static void RaiseDestroyed(Component component)
        {
            // A script that never woke is not told either.
            if (component is MonoBehaviour script && script.Awoken && !script.Destroyed)
            {
                script.Awoken = false;
                if (EditMode.Runs(script))
                    Messages.Send(script, Message.OnDestroy);
            }
        }

        // Runs as Unity's XR Core Utilities describe runInEditMode (MonoBehaviourExtensions.StartRunInEditMode).
        public static void BeginInEditMode(MonoBehaviour script)
        {
            if (script.Owner.Asleep || !script.Owner.activeInHierarchy)
                return;
            if (script.Activated)
                Deactivate(script);
            else if (script.enabled)
                Messages.Send(script, Message.OnDisable);
            Wake(script);
        }

        public static void Validate(List<Component> components)
        {
            foreach (Component component in components)
                if (component is MonoBehaviour script && !script.Destroyed)
                    Messages.Send(script, Message.OnValidate);
        }

        // ---- scriptable objects
        public static void Validate(ScriptableObject asset) => Messages.Send(asset, Message.OnValidate);

        public static void Wake(ScriptableObject asset)
        {
            if (asset.Awoken)
                return;
            asset.Awoken = true;
            Messages.Send(asset, Message.Awake);
            Activate(asset);
        }

        public static void Activate(ScriptableObject asset)
        {
            asset.Enabled = true;
            Messages.Send(asset, Message.OnEnable);
        }

        public static void Deactivate(ScriptableObject asset)
        {
            if (asset.Enabled)
                Messages.Send(asset, Message.OnDisable);
            asset.Enabled = false;
        }

        public static void RaiseDestroyed(ScriptableObject asset)
        {
            Deactivate(asset);
            if (asset.Awoken)
                Messages.Send(asset, Message.OnDestroy);
            asset.Awoken = false;
        }

        static void Guarded(Action action, Object context)
        {
            try
            {
                action();
            }
            catch (Exception e)
            {
                Debug.LogException(e, context);
            }
        }
    }
}
