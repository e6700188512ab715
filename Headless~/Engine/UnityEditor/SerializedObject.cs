using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace UnityEditor
{
    /// <summary>A copy of the serialized fields of one or more objects of a type: written to it, they reach the objects with
    /// ApplyModifiedProperties.</summary>
    public class SerializedObject : IDisposable
    {
        readonly Object[] edited;
        // For each object: the fields that were requested since the last Update, and those of them that were written.
        readonly Dictionary<FieldInfo, object>[] copies;
        readonly HashSet<FieldInfo>[] written;

        internal readonly HashSet<string> Expanded = new HashSet<string>();

        public SerializedObject(Object obj) : this(new[] { obj }) { }

        public SerializedObject(Object[] objs)
        {
            if (objs == null || objs.Length == 0 || !objs[0])
                throw new ArgumentException("Object at index 0 is null");
            edited = objs;
            copies = objs.Select(o => new Dictionary<FieldInfo, object>()).ToArray();
            written = objs.Select(o => new HashSet<FieldInfo>()).ToArray();
        }

        public Object targetObject => edited[0];
        public Object[] targetObjects => edited;
        public bool isEditingMultipleObjects => edited.Length > 1;
        public bool hasModifiedProperties => written.Any(fields => fields.Count > 0);

        /// <summary>Takes the objects' values; what was written and not applied is lost.</summary>
        public void Update()
        {
            for (int i = 0; i < edited.Length; i++)
            {
                copies[i].Clear();
                written[i].Clear();
            }
        }

        public bool UpdateIfRequiredOrScript()
        {
            Update();
            return true;
        }

        public void Dispose() { }

        /// <summary>Returns a property; null without a serialized field of that path.</summary>
        public SerializedProperty FindProperty(string propertyPath)
        {
            string[] parts = propertyPath.Split('.');
            SerializedProperty at = SerializedProperty.OfField(this, null, edited[0], parts[0]);
            for (int i = 1; at != null && i < parts.Length; i++)
                at = parts[i] == "Array" && i + 1 < parts.Length && parts[i + 1].StartsWith("data[", StringComparison.Ordinal)
                    ? at.GetArrayElementAtIndex(int.Parse(parts[++i].Substring(5).TrimEnd(']')))
                    : at.FindPropertyRelative(parts[i]);
            return at;
        }

        public bool ApplyModifiedProperties() => Apply(true);
        public bool ApplyModifiedPropertiesWithoutUndo() => Apply(false);

        internal int Count => edited.Length;

        internal object Get(int index, FieldInfo field)
        {
            if (!copies[index].TryGetValue(field, out object value))
                copies[index].Add(field, value = SerializedCopy.Of(field, field.GetValue(edited[index])));
            return value;
        }

        internal void Set(int index, FieldInfo field, object value)
        {
            copies[index][field] = value;
            written[index].Add(field);
        }

        bool Apply(bool undo)
        {
            bool changed = hasModifiedProperties;
            for (int i = 0; i < edited.Length; i++)
            {
                if (written[i].Count == 0)
                    continue;
                if (undo)
                    Undo.RecordObject(edited[i], $"Modified {written[i].First().Name} in {edited[i].name}");
                foreach (FieldInfo field in written[i])
                    SerializedCopy.Store(field, edited[i], copies[i][field]);
                Messages.Send(edited[i], Message.OnValidate);
            }
            Update();
            return changed;
        }
    }

    public class SerializedProperty : IDisposable
    {
        // By the number of the object.
        readonly Func<int, object> get;
        readonly Action<int, object> set;
        readonly Type valueType;

        SerializedProperty(SerializedObject owner, string name, string path, Type type, Func<int, object> get, Action<int, object> set)
        {
            serializedObject = owner;
            this.name = name;
            propertyPath = path;
            valueType = type;
            this.get = get;
            this.set = set;
        }

        internal static SerializedProperty OfField(SerializedObject owner, SerializedProperty parent, object holder, string name)
        {
            if (holder == null)
                return null;
            FieldInfo field = Array.Find(SerializedFields.Of(holder.GetType()), f => f.Name == name);
            if (field == null)
                return null;
            string path = parent == null ? name : parent.propertyPath + "." + name;
            if (parent == null)
                return new SerializedProperty(owner, name, path, field.FieldType, i => owner.Get(i, field), (i, value) => owner.Set(i, field, value));
            return new SerializedProperty(owner, name, path, field.FieldType,
                i => field.GetValue(parent.get(i)),
                (i, value) =>
                {
                    // A struct in between is a copy: written back to its own holder.
                    object box = parent.get(i);
                    field.SetValue(box, value);
                    parent.set(i, box);
                });
        }

        object First => get(0);

        void SetAll(object value)
        {
            for (int i = 0; i < serializedObject.Count; i++)
                set(i, value);
        }

        public SerializedObject serializedObject { get; }
        public string name { get; }
        public string propertyPath { get; }
        public string displayName => ObjectNames.NicifyVariableName(name);
        public string tooltip => "";
        public string type => valueType.Name;
        public bool isArray => SerializedFields.ElementType(valueType) != null || valueType == typeof(string);
        public bool editable => true;
        public bool hasMultipleDifferentValues => Enumerable.Range(1, serializedObject.Count - 1).Any(i => !SerializedValues.Same(get(0), get(i)));

        public bool isExpanded
        {
            get => serializedObject.Expanded.Contains(propertyPath);
            set
            {
                if (value) serializedObject.Expanded.Add(propertyPath);
                else serializedObject.Expanded.Remove(propertyPath);
            }
        }

        public int depth => propertyPath.Count(c => c == '.');

        public SerializedProperty Copy() => this;
        public void Dispose() { }
        public SerializedProperty FindPropertyRelative(string relativePropertyPath)
        {
            SerializedProperty at = this;
            foreach (string part in relativePropertyPath.Split('.'))
                at = at == null ? null : OfField(serializedObject, at, at.First, part);
            return at;
        }

        public SerializedPropertyType propertyType
        {
            get
            {
                if (valueType == typeof(bool)) return SerializedPropertyType.Boolean;
                if (valueType == typeof(float) || valueType == typeof(double)) return SerializedPropertyType.Float;
                if (valueType == typeof(string)) return SerializedPropertyType.String;
                if (valueType.IsEnum) return SerializedPropertyType.Enum;
                if (valueType.IsPrimitive) return SerializedPropertyType.Integer;
                if (typeof(Object).IsAssignableFrom(valueType)) return SerializedPropertyType.ObjectReference;
                return Enum.TryParse(valueType.Name, out SerializedPropertyType named) ? named : SerializedPropertyType.Generic;
            }
        }

        T Get<T>() => First is T value ? value
            : throw new InvalidOperationException(
            $"type is not a supported {typeof(T).Name} value: '{propertyPath}' is a {valueType.Name}.");

        void Set<T>(T value)
        {
            if (!valueType.IsAssignableFrom(typeof(T)) && !(value is Object) && value != null)
                throw new InvalidOperationException($"type is not a supported {typeof(T).Name} value: '{propertyPath}' is a {valueType.Name}.");
            if (hasMultipleDifferentValues || !Equals(First, value))
                SetAll(value);
        }

        void SetNumber(IConvertible value)
        {
            object converted = Convert.ChangeType(value, valueType.IsEnum ? Enum.GetUnderlyingType(valueType) : valueType);
            if (valueType.IsEnum)
                converted = Enum.ToObject(valueType, converted);
            if (hasMultipleDifferentValues || !Equals(First, converted))
                SetAll(converted);
        }

        public bool boolValue { get => Get<bool>(); set => Set(value); }
        public int intValue { get => Convert.ToInt32(First); set => SetNumber(value); }
        public uint uintValue { get => Convert.ToUInt32(First); set => SetNumber(value); }
        public long longValue { get => Convert.ToInt64(First); set => SetNumber(value); }
        public float floatValue { get => Convert.ToSingle(First); set => SetNumber(value); }
        public double doubleValue { get => Convert.ToDouble(First); set => SetNumber(value); }
        public int enumValueFlag { get => Convert.ToInt32(First); set => SetNumber(value); }
        public int enumValueIndex { get => Array.IndexOf(Enum.GetValues(valueType), First);
            set => SetAll(Enum.GetValues(valueType).GetValue(value)); }
        public string[] enumNames => Enum.GetNames(valueType);
        public string[] enumDisplayNames => Enum.GetNames(valueType);
        public string stringValue { get => (string)First ?? ""; set => Set(value); }
        public Object objectReferenceValue { get => (Object)First; set => Set(value); }
        public object managedReferenceValue { get => First; set => SetAll(value); }
        public object boxedValue { get => First; set => SetAll(value); }
        public Color colorValue { get => Get<Color>(); set => Set(value); }
        public Vector2 vector2Value { get => Get<Vector2>(); set => Set(value); }
        public Vector3 vector3Value { get => Get<Vector3>(); set => Set(value); }
        public Vector4 vector4Value { get => Get<Vector4>(); set => Set(value); }
        public Vector2Int vector2IntValue { get => Get<Vector2Int>(); set => Set(value); }
        public Vector3Int vector3IntValue { get => Get<Vector3Int>(); set => Set(value); }
        public Quaternion quaternionValue { get => Get<Quaternion>(); set => Set(value); }
        public Rect rectValue { get => Get<Rect>(); set => Set(value); }
        public Bounds boundsValue { get => Get<Bounds>(); set => Set(value); }
        public AnimationCurve animationCurveValue { get => Get<AnimationCurve>(); set => Set(value); }
        public Gradient gradientValue { get => Get<Gradient>(); set => Set(value); }

        // ---- arrays and lists
        public int arraySize
        {
            get => (First as IList)?.Count ?? 0;
            set => Rebuild(items =>
            {
                while (items.Count > value) items.RemoveAt(items.Count - 1);
                while (items.Count < value) items.Add(items.Count > 0 ? items[items.Count - 1] : Default());
            });
        }

        public SerializedProperty GetArrayElementAtIndex(int index)
        {
            if (index < 0 || index >= arraySize)
                throw new IndexOutOfRangeException($"Retrieving array element that was out of bounds: {index} of {arraySize} in '{propertyPath}'.");
            return new SerializedProperty(serializedObject, $"data[{index}]", $"{propertyPath}.Array.data[{index}]",
                SerializedFields.ElementType(valueType),
                i => ((IList)get(i))[index],
                (i, value) =>
                {
                    var list = (IList)get(i);
                    list[index] = value;
                    set(i, list);
                });
        }

        public void InsertArrayElementAtIndex(int index) => Rebuild(items => items.Insert(index, index > 0 ? items[index - 1] : Default()));
        public void DeleteArrayElementAtIndex(int index) => Rebuild(items => items.RemoveAt(index));
        public void ClearArray() => arraySize = 0;

        object Default()
        {
            Type element = SerializedFields.ElementType(valueType);
            return element.IsValueType ? Activator.CreateInstance(element) : null;
        }

        void Rebuild(Action<List<object>> change)
        {
            for (int target = 0; target < serializedObject.Count; target++)
            {
                var items = (get(target) as IList)?.Cast<object>().ToList() ?? new List<object>();
                change(items);
                Type element = SerializedFields.ElementType(valueType);
                IList made = valueType.IsArray ? Array.CreateInstance(element, items.Count) : (IList)Activator.CreateInstance(valueType);
                for (int i = 0; i < items.Count; i++)
                {
                    if (valueType.IsArray) made[i] = items[i];
                    else made.Add(items[i]);
                }
                set(target, made);
            }
        }
    }

    /// <summary>Compares what serialized fields hold.</summary>
    internal static class SerializedValues
    {
        public static bool Same(object a, object b)
        {
            if (a is IList list && b is IList other)
                return list.Count == other.Count && Enumerable.Range(0, list.Count).All(i => Same(list[i], other[i]));
            if (Equals(a, b))
                return true;
            if (a == null || b == null || a.GetType() != b.GetType() || a is Object || !a.GetType().IsSerializable && !a.GetType().IsValueType)
                return false;
            FieldInfo[] fields = SerializedFields.Of(a.GetType());
            return fields.Length > 0 && fields.All(field => Same(field.GetValue(a), field.GetValue(b)));
        }
    }

    public enum SerializedPropertyType
    {
        Generic = -1, Integer = 0, Boolean = 1, Float = 2, String = 3, Color = 4, ObjectReference = 5, LayerMask = 6, Enum = 7, Vector2 = 8,
        Vector3 = 9, Vector4 = 10, Rect = 11, ArraySize = 12, Character = 13, AnimationCurve = 14, Bounds = 15, Gradient = 16, Quaternion = 17,
        ExposedReference = 18, FixedBufferSize = 19, Vector2Int = 20, Vector3Int = 21, RectInt = 22, BoundsInt = 23, ManagedReference = 24,
            Hash128 = 25,
    }
}
