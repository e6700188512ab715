using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace UnityEditor
{
    /// <summary>
    /// Values, poses and creations can be undone, and values and poses redone; a group ends where the caller ends it, since no
    /// events end one here. What was destroyed does not come back: to redo a creation throws.
    /// </summary>
    public partial class Undo
    {
        sealed class Group
        {
            public string Name = "";
            public readonly List<Step> Steps = new List<Step>();
        }

        abstract class Step
        {
            /// <summary>Whether undoing it would change anything.</summary>
            public abstract bool Counts { get; }
            public abstract void Revert();
            /// <summary>Step that brings the present state back after a revert.</summary>
            public abstract Step Opposite();
        }

        public delegate void UndoRedoCallback();

        /// <summary>After an undo or a redo that had something to do.</summary>
        public static UndoRedoCallback undoRedoPerformed;

        static readonly List<Group> groups = new List<Group> { new Group() };
        static readonly List<Group> undone = new List<Group>();     // newest last

        static Group Current => groups[groups.Count - 1];

        public static int GetCurrentGroup() => groups.Count - 1;
        public static string GetCurrentGroupName() => Current.Name;
        public static void SetCurrentGroupName(string name) => Current.Name = name;

        public static void IncrementCurrentGroup()
        {
            groups.Add(new Group());
        }

        public static void CollapseUndoOperations(int groupIndex)
        {
            while (groups.Count - 1 > groupIndex && groupIndex >= 0)
            {
                groups[groups.Count - 2].Steps.AddRange(Current.Steps);
                groups.RemoveAt(groups.Count - 1);
            }
        }

        public static void ClearAll()
        {
            groups.Clear();
            undone.Clear();
            groups.Add(new Group());
        }

        /// <summary>Undoes the newest group that changed something.</summary>
        public static void PerformUndo()
        {
            while (groups.Count > 1 && !Current.Steps.Any(step => step.Counts))
                groups.RemoveAt(groups.Count - 1);
            Group last = Current;
            groups.RemoveAt(groups.Count - 1);
            if (groups.Count == 0)
                groups.Add(new Group());
            if (!last.Steps.Any(step => step.Counts))
                return;
            undone.Add(Revert(last));
            undoRedoPerformed?.Invoke();
        }

        /// <summary>Does again what was undone last; nothing where something was recorded since.</summary>
        public static void PerformRedo()
        {
            if (undone.Count == 0)
                return;
            Group last = undone[undone.Count - 1];
            undone.RemoveAt(undone.Count - 1);
            groups.Add(Revert(last));
            undoRedoPerformed?.Invoke();
        }

        // The newest step first; the group that takes it back.
        static Group Revert(Group group)
        {
            var opposite = new Group { Name = group.Name };
            for (int i = group.Steps.Count - 1; i >= 0; i--)
            {
                opposite.Steps.Add(group.Steps[i].Opposite());
                group.Steps[i].Revert();
            }
            return opposite;
        }

        public static void RecordObject(Object objectToUndo, string name)
        {
            if (objectToUndo == null)
                throw new ArgumentNullException(nameof(objectToUndo));
            Add(objectToUndo is Transform transform ? (Step)new Placed(transform) : new Values(objectToUndo), name);
        }

        public static void RecordObjects(Object[] objectsToUndo, string name)
        {
            foreach (Object o in objectsToUndo)
                RecordObject(o, name);
        }

        public static void RegisterCompleteObjectUndo(Object objectToUndo, string name) => RecordObject(objectToUndo, name);
        public static void RegisterCompleteObjectUndo(Object[] objectsToUndo, string name) => RecordObjects(objectsToUndo, name);

        public static void RegisterCreatedObjectUndo(Object objectToUndo, string name)
        {
            if (objectToUndo == null)
                throw new ArgumentNullException(nameof(objectToUndo));
            Add(new Created(objectToUndo), name);
        }

        public static T AddComponent<T>(GameObject gameObject) where T : Component => (T)AddComponent(gameObject, typeof(T));

        public static Component AddComponent(GameObject gameObject, Type type)
        {
            Component added = gameObject.AddComponent(type);
            Add(new Created(added), $"Add {type.Name}");
            return added;
        }

        public static void DestroyObjectImmediate(Object objectToUndo) => Object.DestroyImmediate(objectToUndo, true);
        public static void SetTransformParent(Transform transform, Transform newParent, string name)
            => SetTransformParent(transform, newParent, true, name);

        public static void SetTransformParent(Transform transform, Transform newParent, bool worldPositionStays, string name)
        {
            Add(new Placed(transform), name);
            transform.SetParent(newParent, worldPositionStays);
        }

        public static void SetSiblingIndex(Transform transform, int siblingIndex, string name) => transform.SetSiblingIndex(siblingIndex);

        static void Add(Step step, string name)
        {
            if (Current.Steps.Count == 0 && Current.Name.Length == 0)
                Current.Name = name;
            Current.Steps.Add(step);
            undone.Clear();
        }

        sealed class Created : Step
        {
            readonly Object made;

            public Created(Object made) => this.made = made;
            public override bool Counts => made;
            public override void Revert()
            {
                if (made)
                    Object.DestroyImmediate(made);
            }
            public override Step Opposite() => new Gone(made ? made.name : "");
        }

        sealed class Gone : Step
        {
            readonly string name;

            public Gone(string name) => this.name = name;
            public override bool Counts => true;
            public override void Revert() => throw new NotSupportedException(
                $"Undo destroyed '{name}', and the host does not bring back what was destroyed.");
            public override Step Opposite() => this;
        }

        sealed class Placed : Step
        {
            readonly Transform transform, parent;
            readonly Vector3 position, scale;
            readonly Quaternion rotation;

            public Placed(Transform transform)
            {
                this.transform = transform;
                parent = transform.parent;
                position = transform.localPosition;
                rotation = transform.localRotation;
                scale = transform.localScale;
            }

            public override Step Opposite() => transform ? (Step)new Placed(transform) : this;

            public override bool Counts => transform
                && (transform.parent != parent || transform.localPosition != position || transform.localRotation != rotation
                || transform.localScale != scale);

            public override void Revert()
            {
                if (!transform)
                    return;
                transform.SetParent(parent, false);
                transform.localPosition = position;
                transform.localRotation = rotation;
                transform.localScale = scale;
            }
        }

        sealed class Values : Step
        {
            readonly Object target;
            readonly (FieldInfo field, object value)[] before;

            public Values(Object target)
            {
                this.target = target;
                before = SerializedFields.Of(target.GetType()).Select(field => (field, SerializedCopy.Of(field, field.GetValue(target)))).ToArray();
            }

            public override Step Opposite() => target ? new Values(target) : this;

            public override bool Counts => target && before.Any(kept => !SerializedValues.Same(kept.value, kept.field.GetValue(target)));

            public override void Revert()
            {
                if (!target)
                    return;
                foreach ((FieldInfo field, object value) in before)
                    SerializedCopy.Store(field, target, value);
                (target as ISerializationCallbackReceiver)?.OnAfterDeserialize();
                Messages.Send(target, Message.OnValidate);
            }
        }
    }
}
