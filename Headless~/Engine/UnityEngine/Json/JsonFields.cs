using System;
using System.Collections;
using System.Collections.Generic;
using System.Globalization;
using System.Reflection;

namespace UnityEngine.Headless
{
    /// <summary>Parsed JSON into serialized fields. A key that is not there leaves its field alone, a value of another kind too.</summary>
    internal static class JsonFields
    {
        /// <summary>The engine's own structs are written by their public names: Rect has m_XMin within, and x without.</summary>
        public static string NameOf(FieldInfo field)
        {
            if (field.DeclaringType == typeof(Rect))
                return field.Name.Replace("m_XMin", "x").Replace("m_YMin", "y").Replace("m_Width", "width").Replace("m_Height", "height");
            return field.Name;
        }

        public static void Read(ref object target, Dictionary<string, object> fields)
        {
            foreach (FieldInfo field in SerializedFields.Of(target.GetType()))
                if (fields.TryGetValue(NameOf(field), out object value) && TryValue(value, field.FieldType, field.GetValue(target), out object made))
                    field.SetValue(target, made);
        }

        static bool TryValue(object value, Type type, object current, out object made)
        {
            made = null;
            if (typeof(Object).IsAssignableFrom(type))
            {
                if (!(value is Dictionary<string, object> reference) || !reference.TryGetValue("instanceID", out object id))
                    return value == null;
                made = ObjectRegistry.Find((int)Convert.ToDouble(id, CultureInfo.InvariantCulture));
                return made == null || type.IsInstanceOfType(made);
            }
            if (type == typeof(string))
            {
                made = value as string;
                return made != null;
            }
            if (type == typeof(bool))
            {
                made = value;
                return value is bool;
            }
            if (type.IsPrimitive || type.IsEnum)
            {
                if (!(value is double number))
                    return false;
                if (type.IsEnum)
                    made = Enum.ToObject(type, (long)number);
                else if (type == typeof(char))
                    made = (char)(int)number;
                else
                    made = Convert.ChangeType(number, type, CultureInfo.InvariantCulture);
                return true;
            }
            if (SerializedFields.ElementType(type) is Type element)
            {
                if (!(value is List<object> items))
                    return false;
                made = ListOf(type, element, items);
                return true;
            }
            if (!(value is Dictionary<string, object> group))
                return false;
            made = current ?? JsonUtility.Make(type);
            Read(ref made, group);
            return true;
        }

        static object ListOf(Type type, Type element, List<object> items)
        {
            IList list = type.IsArray ? Array.CreateInstance(element, items.Count) : (IList)Activator.CreateInstance(type);
            for (int i = 0; i < items.Count; i++)
            {
                object blank = element.IsValueType ? Activator.CreateInstance(element) : null;
                object item = TryValue(items[i], element, blank, out object made) ? made : blank;
                if (type.IsArray) list[i] = item;
                else list.Add(item);
            }
            return list;
        }
    }
}
