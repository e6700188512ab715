using System;
using UnityEditor;

namespace Rill.Editor
{
    /// <summary>Conditions under which a field has a meaning. Objects that differ in the choice show what any of them may need.</summary>
    static class When
    {
        /// <summary>An enum has one of these values.</summary>
        public static Func<SerializedObject, bool> Is<T>(string path, params T[] values) where T : Enum
        {
            return Of(path, property => Array.IndexOf(values, (T)Enum.ToObject(typeof(T), property.intValue)) >= 0);
        }

        /// <summary>An enum has none of these values.</summary>
        public static Func<SerializedObject, bool> IsNot<T>(string path, params T[] values) where T : Enum
        {
            return Of(path, property => Array.IndexOf(values, (T)Enum.ToObject(typeof(T), property.intValue)) < 0);
        }

        /// <summary>A number is above 0.</summary>
        public static Func<SerializedObject, bool> IsPositive(string path) => Of(path, property => property.floatValue > 0f);

        /// <summary>An object is not set.</summary>
        public static Func<SerializedObject, bool> IsNull(string path) => Of(path, property => property.objectReferenceValue == null);

        static Func<SerializedObject, bool> Of(string path, Func<SerializedProperty, bool> condition)
        {
            return inspected =>
            {
                SerializedProperty property = inspected.FindProperty(path);
                return property.hasMultipleDifferentValues || condition(property);
            };
        }
    }
}
