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
    /// <summary>Reads and writes fields of the first target directly; ApplyModifiedProperties then says OnValidate.</summary>
    public class SerializedObject : IDisposable
    {
        readonly Object[] edited;
        internal bool Modified;

        public SerializedObject(Object obj) : this(new[] { obj }) { }
        public SerializedObject(Object[] objs)
        {
            if (objs == null || objs.Length == 0 || !objs[0])
                throw new ArgumentException("Object at index 0 is null");
            edited = objs;
        }

        public Object targetObject => edited[0];
        public Object[] targetObjects => edited;
        public bool isEditingMultipleObjects => edited.Length > 1;
        public bool hasModifiedProperties => Modified;
        public void Update() { }
        public bool UpdateIfRequiredOrScript() => false;
        public void Dispose() { }

        /// <summary>Null when there is no serialized field of that path.</summary>
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

        public bool ApplyModifiedProperties()
        {
            bool changed = Modified;
            Modified = false;
            if (changed)
                foreach (Object o in edited)
                    Messages.Send(o, Message.OnValidate);
            return changed;
        }

        public bool ApplyModifiedPropertiesWithoutUndo() => ApplyModifiedProperties();
    }

    public class SerializedProperty : IDisposable
    {
        readonly Func<object> get;
        readonly Action<object> set;
        readonly Type valueType;

        SerializedProperty(SerializedObject owner, string name, string path, Type type, Func<object> get, Action<object> set)
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
            return new SerializedProperty(owner, name, path, field.FieldType,
                () => field.GetValue(parent == null ? holder : parent.get()),
                value =>
                {
                    // A struct in between is a copy: written back to its own holder.
                    object box = parent == null ? holder : parent.get();
                    field.SetValue(box, value);
                    if (parent != null)
                        parent.set(box);
                    owner.Modified = true;
                });
        }

        public SerializedObject serializedObject { get; }
        public string name { get; }
        public string propertyPath { get; }
        public string displayName => string.Concat(name.TrimStart('m', '_').Select((c, i) => i == 0 ? char.ToUpperInvariant(c).ToString() : char.IsUpper(c) ? " " + c : c.ToString()));
        public string tooltip => "";
        public string type => valueType.Name;
        public bool isArray => SerializedFields.ElementType(valueType) != null || valueType == typeof(string);
        public bool editable => true;
        public bool hasMultipleDifferentValues => false;
        public bool isExpanded { get; set; }
        public int depth => propertyPath.Count(c => c == '.');

        public SerializedProperty Copy() => this;
        public void Dispose() { }
        public SerializedProperty FindPropertyRelative(string relativePropertyPath)
        {
            SerializedProperty at = this;
            foreach (string part in relativePropertyPath.Split('.'))
                at = at == null ? null : OfField(serializedObject, at, at.get(), part);
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

        T Get<T>() => get() is T value ? value : throw new InvalidOperationException($"type is not a supported {typeof(T).Name} value: '{propertyPath}' is a {valueType.Name}.");

        void Set<T>(T value)
        {
            if (!valueType.IsAssignableFrom(typeof(T)) && !(value is Object) && value != null)
                throw new InvalidOperationException($"type is not a supported {typeof(T).Name} value: '{propertyPath}' is a {valueType.Name}.");
            if (!Equals(get(), value))
                set(value);
        }

        void SetNumber(IConvertible value)
        {
            object converted = Convert.ChangeType(value, valueType.IsEnum ? Enum.GetUnderlyingType(valueType) : valueType);
            if (valueType.IsEnum)
                converted = Enum.ToObject(valueType, converted);
            if (!Equals(get(), converted))
                set(converted);
        }

        public bool boolValue { get => Get<bool>(); set => Set(value); }
        public int intValue { get => Convert.ToInt32(get()); set => SetNumber(value); }
        public uint uintValue { get => Convert.ToUInt32(get()); set => SetNumber(value); }
        public long longValue { get => Convert.ToInt64(get()); set => SetNumber(value); }
        public float floatValue { get => Convert.ToSingle(get()); set => SetNumber(value); }
        public double doubleValue { get => Convert.ToDouble(get()); set => SetNumber(value); }
        public int enumValueFlag { get => Convert.ToInt32(get()); set => SetNumber(value); }
        public int enumValueIndex { get => Array.IndexOf(Enum.GetValues(valueType), get()); set => set(Enum.GetValues(valueType).GetValue(value)); }
        public string[] enumNames => Enum.GetNames(valueType);
        public string[] enumDisplayNames => Enum.GetNames(valueType);
        public string stringValue { get => (string)get() ?? ""; set => Set(value); }
        public Object objectReferenceValue { get => (Object)get(); set => Set(value); }
        public object managedReferenceValue { get => get(); set => set(value); }
        public object boxedValue { get => get(); set => set(value); }
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
            get => (get() as IList)?.Count ?? 0;
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
            return new SerializedProperty(serializedObject, $"data[{index}]", $"{propertyPath}.Array.data[{index}]", SerializedFields.ElementType(valueType),
                () => ((IList)get())[index],
                value =>
                {
                    ((IList)get())[index] = value;
                    serializedObject.Modified = true;
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
            var items = (get() as IList)?.Cast<object>().ToList() ?? new List<object>();
            change(items);
            Type element = SerializedFields.ElementType(valueType);
            IList made = valueType.IsArray ? Array.CreateInstance(element, items.Count) : (IList)Activator.CreateInstance(valueType);
            for (int i = 0; i < items.Count; i++)
            {
                if (valueType.IsArray) made[i] = items[i];
                else made.Add(items[i]);
            }
            set(made);
        }
    }

    public enum SerializedPropertyType
    {
        Generic = -1, Integer = 0, Boolean = 1, Float = 2, String = 3, Color = 4, ObjectReference = 5, LayerMask = 6, Enum = 7, Vector2 = 8,
        Vector3 = 9, Vector4 = 10, Rect = 11, ArraySize = 12, Character = 13, AnimationCurve = 14, Bounds = 15, Gradient = 16, Quaternion = 17,
        ExposedReference = 18, FixedBufferSize = 19, Vector2Int = 20, Vector3Int = 21, RectInt = 22, BoundsInt = 23, ManagedReference = 24, Hash128 = 25,
    }
}
