using System;
using System.Collections;
using System.Collections.Generic;
using UnityEngine.Headless;

namespace UnityEngine
{
    public partial class Transform
    {
        public Transform parent { get { ThrowIfDestroyed(); return ParentOf; } set => SetParent(value, true); }

        public Transform root
        {
            get
            {
                ThrowIfDestroyed();
                Transform t = this;
                while (t.ParentOf is object)
                    t = t.ParentOf;
                return t;
            }
        }

        public int childCount { get { ThrowIfDestroyed(); return Children.Count; } }
        public int hierarchyCapacity { get => hierarchyCount; set { } }

        public int hierarchyCount
        {
            get
            {
                var tree = new List<GameObject>();
                root.CollectTree(tree);
                return tree.Count;
            }
        }

        public Transform GetChild(int index)
        {
            ThrowIfDestroyed();
            if ((uint)index >= (uint)Children.Count)
                throw new UnityException("Transform child out of bounds");
            return Children[index];
        }

        public IEnumerator GetEnumerator()
        {
            for (int i = 0; i < childCount; i++)
                yield return GetChild(i);
        }

        public void SetParent(Transform p) => SetParent(p, true);

        public void SetParent(Transform parent, bool worldPositionStays)
        {
            ThrowIfDestroyed();
            Transform target = IsAlive(parent) ? parent : null;
            if (ReferenceEquals(target, ParentOf))
                return;
            if (target is object && target.IsChildOf(this))
            {
                Debug.LogError($"Cannot set the parent of '{NameOf}' to its own descendant '{target.NameOf}'.", this);
                return;
            }
            if (target is object && target.Owner.SceneOf == null && Owner.SceneOf != null)
            {
                Debug.LogError("Setting the parent of a transform which resides in a Prefab Asset is disabled to prevent data corruption "
                    + $"(GameObject: '{NameOf}').", this);
                return;
            }

            if (Destruction.IsInsidePrefabInstance(Owner))
            {
                Debug.LogError("Setting the parent of a transform which resides in a Prefab instance is not possible "
                    + $"(GameObject: '{NameOf}').", this);
                return;
            }

            Matrix4x4 worldBefore = localToWorldMatrix;
            Quaternion rotationBefore = rotation;
            bool wasActive = Owner.activeInHierarchy;
            Transform former = ParentOf;

            Detach();
            ParentOf = target;
            if (target is object)
            {
                target.Children.Add(this);
                SetScene(target.Owner.SceneOf);
            }
            else
                Owner.SceneOf?.Roots.Add(Owner);

            if (worldPositionStays)
            {
                Matrix4x4 local = target is null ? worldBefore : target.worldToLocalMatrix * worldBefore;
                m_LocalPosition = local.GetPosition();
                m_LocalRotation = target is null ? rotationBefore : target.ToLocal(rotationBefore);
                Matrix4x4 scale = Matrix4x4.Rotate(Quaternion.Inverse(m_LocalRotation)) * local;
                m_LocalScale = new Vector3(scale.m00, scale.m11, scale.m22);
            }
            Moved();

            if (Owner.Asleep)
                return;
            if (Owner.activeInHierarchy != wasActive)
                Lifecycle.RefreshTree(Owner);
            var tree = new List<GameObject>();
            CollectTree(tree);
            foreach (GameObject go in tree)
                Messages.Broadcast(go, "OnTransformParentChanged", null);
            if (former is object && !former.Owner.BeingDestroyed)
                Messages.Broadcast(former.Owner, "OnTransformChildrenChanged", null);
            if (target is object)
                Messages.Broadcast(target.Owner, "OnTransformChildrenChanged", null);
        }

        void SetScene(SceneData scene)
        {
            if (ReferenceEquals(Owner.SceneOf, scene))
                return;
            Owner.SceneOf = scene;
            Owner.IsAsset = scene == null;
            foreach (Transform child in Children)
                child.SetScene(scene);
        }

        /// <summary>Out of its parent's children or its scene's roots; then belongs to neither.</summary>
        internal void Detach()
        {
            if (ParentOf is object)
                ParentOf.Children.Remove(this);
            else
                Owner.SceneOf?.Roots.Remove(Owner);
            ParentOf = null;
        }

        internal void MoveToScene(SceneData scene)
        {
            Detach();
            SetScene(scene);
            scene.Roots.Add(Owner);
        }

        public void DetachChildren()
        {
            foreach (Transform child in Children.ToArray())
                child.SetParent(null, true);
        }

        public bool IsChildOf(Transform parent)
        {
            for (Transform t = this; t is object; t = t.ParentOf)
                if (ReferenceEquals(t, parent))
                    return true;
            return false;
        }

        /// <summary>A child by name, or by a path of names; inactive ones too.</summary>
        public Transform Find(string n)
        {
            ThrowIfDestroyed();
            if (n == null)
                throw new ArgumentNullException(nameof(n));
            Transform at = this;
            foreach (string part in n.Split('/'))
            {
                at = part == ".." ? at.ParentOf : part == "" || part == "." ? at : at.Children.Find(child => child.NameOf == part);
                if (at is null)
                    return null;
            }
            return at;
        }

        public int GetSiblingIndex()
            => ParentOf is object ? ParentOf.Children.IndexOf(this) : Owner.SceneOf?.Roots.IndexOf(Owner) ?? 0;

        public void SetSiblingIndex(int index)
        {
            if (ParentOf is object)
                Reinsert(ParentOf.Children, this, index);
            else if (Owner.SceneOf != null)
                Reinsert(Owner.SceneOf.Roots, Owner, index);
        }

        public void SetAsFirstSibling() => SetSiblingIndex(0);
        public void SetAsLastSibling() => SetSiblingIndex(int.MaxValue);

        static void Reinsert<T>(List<T> list, T item, int index)
        {
            list.Remove(item);
            list.Insert(Mathf.Clamp(index, 0, list.Count), item);
        }

        /// <summary>This and all below, parents first.</summary>
        internal void CollectTree(List<GameObject> tree)
        {
            tree.Add(Owner);
            foreach (Transform child in Children)
                child.CollectTree(tree);
        }
    }
}
