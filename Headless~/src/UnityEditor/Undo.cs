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
    /// Values and creations can be undone; a group ends where the caller says so, since no events end one here. There is no redo,
    /// and what was destroyed does not come back.
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
        }

        static readonly List<Group> groups = new List<Group> { new Group() };

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
            groups.Add(new Group());
        }

        /// <summary>Undoes the newest group that changed something.</summary>
        public static void PerformUndo()
        {
            while (groups.Count > 1 && !Current.Steps.Any(step => step.Counts))
                groups.RemoveAt(groups.Count - 1);
            Group undone = Current;
            groups.RemoveAt(groups.Count - 1);
            if (groups.Count == 0)
                groups.Add(new Group());
            for (int i = undone.Steps.Count - 1; i >= 0; i--)
                undone.Steps[i].Revert();
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
        public static void SetTransformParent(Transform transform, Transform newParent, string name) => SetTransformParent(transform, newParent, true, name);

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

            public override bool Counts => transform && (transform.parent != parent || transform.localPosition != position || transform.localRotation != rotation || transform.localScale != scale);

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

            public override bool Counts => target && before.Any(kept => !SerializedValues.Same(kept.value, kept.field.GetValue(target)));

            public override void Revert()
            {
                if (!target)
                    return;
                foreach ((FieldInfo field, object value) in before)
                    field.SetValue(target, value);
                Messages.Send(target, Message.OnValidate);
            }
        }
    }
}
