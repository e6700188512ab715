using System;
using System.Collections.Generic;
using System.Reflection;

namespace UnityEngine.Headless
{
    /// <summary>Which fields Unity stores, and what it can store in them. Used for copies here and by the asset loader.</summary>
    internal static class SerializedFields
    {
        const BindingFlags Own = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;
        static readonly Dictionary<Type, FieldInfo[]> stored = new Dictionary<Type, FieldInfo[]>();
        static readonly Dictionary<Type, FieldInfo[]> backedUp = new Dictionary<Type, FieldInfo[]>();

        /// <summary>Base classes' fields first. For the engine's own components: values and object references not marked NonSerialized.</summary>
        public static FieldInfo[] Of(Type type) => All(type, stored, IsStored);

        /// <summary>Fields that a reload of scripts carries over: private fields too, whether they have an attribute or not, unless it is
        /// NonSerialized (manual, "Script serialization", Hot reloading).</summary>
        public static FieldInfo[] BackedUp(Type type) => All(type, backedUp, IsBackedUp);

        static FieldInfo[] All(Type type, Dictionary<Type, FieldInfo[]> cache, Func<FieldInfo, bool> belongs)
        {
            if (cache.TryGetValue(type, out FieldInfo[] fields))
                return fields;
            var found = new List<FieldInfo>();
            for (Type t = type; t != null && t != typeof(object) && t != typeof(ValueType) && t != typeof(Object); t = t.BaseType)
            {
                int at = 0;
                foreach (FieldInfo field in t.GetFields(Own))
                    if (belongs(field))
                        found.Insert(at++, field);
            }
            cache.Add(type, fields = found.ToArray());
            return fields;
        }

        static bool IsStored(FieldInfo field) => IsBackedUp(field) && (field.IsPublic || IsMarked(field) || IsEngines(field));

        static bool IsBackedUp(FieldInfo field)
        {
            if (field.IsStatic || field.IsInitOnly || field.IsNotSerialized)
                return false;
            if (field.IsDefined(typeof(SerializeReference)))
                return true;
            // The engine keeps its state in private fields without attributes.
            if (IsEngines(field))
                return IsState(field.FieldType) || IsMarked(field) && CanStore(field.FieldType);
            return CanStore(field.FieldType);
        }

        /// <summary>Whether an attribute has a field stored that is not public.</summary>
        public static bool IsMarked(FieldInfo field) => field.IsDefined(typeof(SerializeField)) || field.IsDefined(typeof(SerializeReference));

        static bool IsEngines(FieldInfo field) => field.DeclaringType.Assembly == typeof(SerializedFields).Assembly;

        // Values and references to objects; what else an engine's component holds (lists of commands, caches) is its own.
        static bool IsState(Type type)
        {
            if (ElementType(type) is Type element)
                return IsState(element);
            return type.IsValueType || type == typeof(string) || type == typeof(AnimationCurve) || type == typeof(Gradient)
                || typeof(Object).IsAssignableFrom(type);
        }

        public static bool CanStore(Type type)
        {
            if (ElementType(type) is Type element)
                return ElementType(element) == null && CanStore(element);
            if (type.IsPrimitive || type.IsEnum || type == typeof(string))
                return type != typeof(IntPtr) && type != typeof(UIntPtr);
            if (typeof(Object).IsAssignableFrom(type))
                return true;
            if (type.IsArray || type.IsAbstract || type.IsInterface || typeof(Delegate).IsAssignableFrom(type) || type == typeof(decimal)
                || type.IsPointer)
                return false;
            return engineTypes.Contains(type) || type.IsSerializable && !IsFramework(type.Assembly)
                && !type.IsDefined(typeof(System.Runtime.CompilerServices.CompilerGeneratedAttribute));
        }

        // The engine's types that are stored without being marked [Serializable]: buffers, property blocks and the like are not.
        static readonly HashSet<Type> engineTypes = new HashSet<Type>
        {
            typeof(Vector2), typeof(Vector3), typeof(Vector4), typeof(Vector2Int), typeof(Vector3Int), typeof(Quaternion), typeof(Matrix4x4),
            typeof(Color), typeof(Color32), typeof(Rect), typeof(Bounds), typeof(LayerMask), typeof(AnimationCurve), typeof(Gradient),
            typeof(GUIStyle), typeof(GUIContent), typeof(RectOffset), typeof(BoneWeight), typeof(SceneManagement.Scene),
        };

        // List is the one collection that Unity stores, whatever else is marked [Serializable] there.
        static bool IsFramework(Assembly assembly)
        {
            string name = assembly.GetName().Name;
            return name == "mscorlib" || name == "netstandard" || name.StartsWith("System", StringComparison.Ordinal);
        }

        /// <summary>Element type of a one-dimensional array or a List; null for anything else.</summary>
        public static Type ElementType(Type type)
        {
            if (type.IsArray)
                return type.GetArrayRank() == 1 ? type.GetElementType() : null;
            return type.IsGenericType && type.GetGenericTypeDefinition() == typeof(List<>) ? type.GetGenericArguments()[0] : null;
        }
    }
}
