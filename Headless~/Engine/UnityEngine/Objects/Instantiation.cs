using System;
using System.Collections.Generic;
using UnityEngine.SceneManagement;

namespace UnityEngine.Headless
{
    /// <summary>Object.Instantiate: a tree of objects is copied asleep, its inner references redirected, then woken.</summary>
    internal static class Instantiation
    {
        public static Object Clone(Object original, Transform parent, bool worldPositionStays)
            => Copy(original, parent, null, root =>
            {
                if (parent)
                    root.SetParent(parent, worldPositionStays);
            });

        public static Object CloneAt(Object original, Vector3 position, Quaternion rotation, Transform parent)
            => Copy(original, parent, null, root =>
            {
                if (parent)
                    root.SetParent(parent, false);
                root.SetPositionAndRotation(position, rotation);
            });

        public static Object CloneInto(Object original, Scene scene) => Copy(original, null, scene.Data, _ => { });

        static Object Copy(Object original, Transform parent, SceneData scene, Action<Transform> setParent)
        {
            if (!Object.IsAlive(original))
                throw new ArgumentException("The Object you want to instantiate is null.");
            if (!(original is GameObject) && !(original is Component))
            {
                Object made = original.CloneNative();
                made.NameOf = original.NameOf + "(Clone)";
                made.IsAsset = false;
                return made;
            }

            GameObject source = original as GameObject ?? ((Component)original).Owner;
            // A parent without a scene is a prefab being edited; the copy then belongs to it.
            scene = parent ? parent.Owner.SceneOf : scene ?? SceneManager.Active;
            var copies = new Dictionary<Object, Object>();
            GameObject root = CopyTree(source, scene, copies);
            foreach (KeyValuePair<Object, Object> pair in copies)
                if (pair.Key is Component from)
                {
                    SerializedCopy.Into(from, pair.Value, copies);
                    ((Component)pair.Value).OnCopied(from);
                }
            root.NameOf = source.NameOf + "(Clone)";
            setParent(root.TransformOf);
            ObjectFactory.WakeCopy(root);
            return copies[original];
        }

        static GameObject CopyTree(GameObject source, SceneData scene, Dictionary<Object, Object> copies)
        {
            GameObject made = new GameObject(source.NameOf, scene, true);
            made.SetActiveSilently(source.activeSelf);
            made.layer = source.layer;
            made.tag = source.tag;
            made.isStatic = source.isStatic;
            made.hideFlags = source.hideFlags;
            copies.Add(source, made);
            foreach (Component component in source.Components)
                copies.Add(component, ObjectFactory.AddComponent(made, component.GetType()));
            foreach (Transform child in source.TransformOf.Children)
                CopyTree(child.Owner, scene, copies).TransformOf.SetParent(made.TransformOf, false);
            return made;
        }
    }
}
