using System;
using System.Collections;
using System.Globalization;
using System.Text;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Host.Assets
{
    /// <summary>Writes an object's serialized fields as Unity's text form has them; what <see cref="FieldReader"/> reads.</summary>
    internal sealed class FieldWriter
    {
        readonly StringBuilder text;
        readonly Func<Object, string> referenceTo;

        /// <param name="referenceTo">The inner of the braces: "fileID: 1, guid: ..., type: 2".</param>
        public FieldWriter(StringBuilder text, Func<Object, string> referenceTo)
        {
            this.text = text;
            this.referenceTo = referenceTo;
        }

        /// <exception cref="NotSupportedException">A field of a type that no asset has needed yet.</exception>
        public void Write(object target, string indent)
        {
            foreach (var field in FieldMap.Of(target.GetType())) Line(field.Info.Name, field.Type, field.Info.GetValue(target), indent);
        }

        void Line(string name, Type type, object value, string indent)
        {
            if (typeof(Object).IsAssignableFrom(type)) text.Append($"{indent}{name}: {{{referenceTo((Object)value)}}}\n");
            else if (Scalar(type, value) is string scalar) text.Append($"{indent}{name}: {scalar}\n");
            else if (FieldMap.ElementOf(type) is Type element) List(name, element, (IList)value, indent);
            else if (value is Bounds bounds)
                text.Append(
                $"{indent}{name}:\n{indent}  m_Center: {Vector(bounds.center)}\n{indent}  m_Extent: {Vector(bounds.extents)}\n");
            else if (type.IsDefined(typeof(SerializableAttribute), false) && !FieldMap.IsEngine(type))
            {
                text.Append($"{indent}{name}:\n");
                Write(value ?? Activator.CreateInstance(type), indent + "  ");
            }
            else throw new NotSupportedException($"Field '{name}' is of type {type.Name}, which the host does not write yet.");
        }

        void List(string name, Type element, IList items, string indent)
        {
            if (items == null || items.Count == 0)
            {
                text.Append($"{indent}{name}: []\n");
                return;
            }
            text.Append($"{indent}{name}:\n");
            foreach (var item in items)
                text.Append(
                    $"{indent}- {Scalar(element, item) ?? throw new NotSupportedException($"Field '{name}' is a list of {element.Name}, which the host does not write yet.")}\n");
        }

        /// <summary>On one line; null for what takes several.</summary>
        static string Scalar(Type type, object value)
        {
            if (type == typeof(string)) return Quoted((string)value ?? "");
            if (type == typeof(bool)) return (bool)value ? "1" : "0";
            if (type.IsEnum) return Convert.ToInt64(value).ToString(CultureInfo.InvariantCulture);
            if (type == typeof(float)) return Number((float)value);
            if (type == typeof(double)) return ((double)value).ToString("R", CultureInfo.InvariantCulture).ToLowerInvariant();
            if (type.IsPrimitive) return Convert.ToString(value, CultureInfo.InvariantCulture);
            return value switch
            {
                Vector2 v => $"{{x: {Number(v.x)}, y: {Number(v.y)}}}",
                Vector3 v => Vector(v),
                Vector4 v => $"{{x: {Number(v.x)}, y: {Number(v.y)}, z: {Number(v.z)}, w: {Number(v.w)}}}",
                Quaternion v => $"{{x: {Number(v.x)}, y: {Number(v.y)}, z: {Number(v.z)}, w: {Number(v.w)}}}",
                Vector3Int v => $"{{x: {v.x}, y: {v.y}, z: {v.z}}}",
                Color v => $"{{r: {Number(v.r)}, g: {Number(v.g)}, b: {Number(v.b)}, a: {Number(v.a)}}}",
                _ => null,
            };
        }

        static string Vector(Vector3 v) => $"{{x: {Number(v.x)}, y: {Number(v.y)}, z: {Number(v.z)}}}";

        /// <summary>Writes as many digits as come back to the same number.</summary>
        static string Number(float value) => value.ToString("R", CultureInfo.InvariantCulture).ToLowerInvariant();

        /// <summary>Plain where YAML takes it for a string as it stands, else in single quotes.</summary>
        public static string Quoted(string value)
        {
            var plain = true;
            for (var i = 0; i < value.Length && plain; i++)
                plain = char.IsLetterOrDigit(value[i]) || value[i] == '_' || value[i] == '/' || i > 0
                    && (value[i] == '.' || value[i] == '-' || value[i] == ' ' && i < value.Length - 1);
            return plain ? value : "'" + value.Replace("'", "''") + "'";
        }
    }
}
