using System;
using System.Reflection;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>The [Tooltip] of a serialized field, which a label of one's own does not carry by itself.</summary>
    static class FieldTooltip
    {
        const BindingFlags Own = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

        /// <param name="type">Type of the object.</param>
        /// <param name="path">As SerializedObject.FindProperty takes it; not into lists.</param>
        /// <returns>"" where there is none.</returns>
        public static string Of(Type type, string path)
        {
            FieldInfo field = null;
            foreach (string name in path.Split('.'))
            {
                field = Find(type, name);
                if (field == null)
                    return "";
                type = field.FieldType;
            }
            return field.GetCustomAttribute<TooltipAttribute>()?.tooltip ?? "";
        }

        static FieldInfo Find(Type type, string name)
        {
            for (; type != null; type = type.BaseType)
                if (type.GetField(name, Own) is FieldInfo field)
                    return field;
            return null;
        }
    }
}
