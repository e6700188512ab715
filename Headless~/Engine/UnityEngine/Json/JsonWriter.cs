using System;
using System.Collections;
using System.Globalization;
using System.Reflection;
using System.Text;

namespace UnityEngine.Headless
{
    /// <summary>Serialized fields to text in Unity's form: enumerations as numbers, whole floats with ".0", null strings empty.</summary>
    internal sealed class JsonWriter
    {
        readonly StringBuilder text = new StringBuilder();
        readonly bool pretty;
        int depth;

        public JsonWriter(bool pretty) { this.pretty = pretty; }

        public string Write(object value)
        {
            Group(value);
            return text.ToString();
        }

        void Group(object value)
        {
            FieldInfo[] fields = SerializedFields.Of(value.GetType());
            text.Append('{');
            depth++;
            for (int i = 0; i < fields.Length; i++)
            {
                if (i > 0)
                    text.Append(',');
                Line();
                Text(JsonFields.NameOf(fields[i]));
                text.Append(pretty ? ": " : ":");
                Value(fields[i].GetValue(value), fields[i].FieldType);
            }
            depth--;
            if (fields.Length > 0)
                Line();
            text.Append('}');
        }

        void Line()
        {
            if (pretty)
                text.Append('\n').Append(' ', 4 * depth);
        }

        void Value(object value, Type type)
        {
            if (typeof(Object).IsAssignableFrom(type))
                text.Append("{\"instanceID\":").Append(value is Object o && Object.IsAlive(o) ? o.GetInstanceID() : 0).Append('}');
            else if (type == typeof(string))
                Text((string)value ?? "");
            else if (type == typeof(bool))
                text.Append((bool)value ? "true" : "false");
            else if (type == typeof(float))
                Number((float)value);
            else if (type == typeof(double))
                Number((double)value);
            else if (type.IsEnum)
                text.Append(Convert.ToInt64(value).ToString(CultureInfo.InvariantCulture));
            else if (type == typeof(char))
                text.Append((int)(char)value);
            else if (type.IsPrimitive)
                text.Append(((IFormattable)value).ToString(null, CultureInfo.InvariantCulture));
            else if (SerializedFields.ElementType(type) is Type element)
                List((IList)value, element);
            else if (type == typeof(AnimationCurve) || type == typeof(Gradient))
                throw new NotSupportedException($"JsonUtility: the headless host writes no {type.Name}");
            else
                Group(value ?? JsonUtility.Make(type));
        }

        void List(IList list, Type element)
        {
            text.Append('[');
            depth++;
            for (int i = 0; list != null && i < list.Count; i++)
            {
                if (i > 0)
                    text.Append(',');
                Line();
                Value(list[i], element);
            }
            depth--;
            if (list != null && list.Count > 0)
                Line();
            text.Append(']');
        }

        void Number(double value)
        {
            string digits = value.ToString("R", CultureInfo.InvariantCulture);
            text.Append(digits);
            if (digits.IndexOfAny(new[] { '.', 'E', 'N', 'I' }) < 0)
                text.Append(".0");
        }

        void Text(string value)
        {
            text.Append('"');
            foreach (char c in value)
                switch (c)
                {
                    case '"': text.Append("\\\""); break;
                    case '\\': text.Append("\\\\"); break;
                    case '\n': text.Append("\\n"); break;
                    case '\r': text.Append("\\r"); break;
                    case '\t': text.Append("\\t"); break;
                    default:
                        if (c < ' ') text.Append("\\u").Append(((int)c).ToString("x4"));
                        else text.Append(c);
                        break;
                }
            text.Append('"');
        }
    }
}
