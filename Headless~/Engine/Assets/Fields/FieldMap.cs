using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Serialization;
using Object = UnityEngine.Object;

namespace Host.Assets
{
    /// <summary>A field that Unity stores, and the keys under which a file may hold it.</summary>
    internal sealed class MappedField
    {
        public readonly FieldInfo Info;
        /// <summary>[SerializeReference]: the file holds a number instead of the value.</summary>
        public readonly bool ByReference;
        readonly string[] formerNames;

        public MappedField(FieldInfo info)
        {
            Info = info;
            ByReference = info.IsDefined(typeof(SerializeReference), false);
            formerNames = info.GetCustomAttributes<FormerlySerializedAsAttribute>().Select(a => a.oldName).ToArray();
        }

        public Type Type => Info.FieldType;
        public bool IsNamed(string key) => key == Info.Name || Array.IndexOf(formerNames, key) >= 0;

        /// <summary>The present name wins over former ones when a file holds both.</summary>
        public YamlNode In(YamlMapping fields)
        {
            var found = fields.Find(Info.Name);
            for (var i = 0; found == null && i < formerNames.Length; i++) found = fields.Find(formerNames[i]);
            return found;
        }
    }

    /// <summary>The fields of a type that a file may hold, base classes first.</summary>
    internal static class FieldMap
    {
        static readonly Dictionary<Type, MappedField[]> Known = new Dictionary<Type, MappedField[]>();

        public static MappedField[] Of(Type type)
        {
            if (!Known.TryGetValue(type, out var fields))
                Known[type] = fields = SerializedFields.Of(type).Where(f => !IsEngineState(f.DeclaringType)).Select(f => new MappedField(f))
                    .ToArray();
            return fields;
        }

        // MonoBehaviour, Behaviour and so on: theirs is set through their members.
        static bool IsEngineState(Type type) => IsEngine(type) && typeof(Object).IsAssignableFrom(type);

        public static bool IsEngine(Type type) => type.Assembly == typeof(Object).Assembly;

        /// <summary>The host's stand-ins for Unity's packages hold a part of what the originals store.</summary>
        public static bool StandsForPackage(Type type) => type.Assembly.GetName().Name.StartsWith("UnityEngine.", StringComparison.Ordinal);

        public static Type ElementOf(Type type) => SerializedFields.ElementType(type);

        /// <summary>A T[] or List&lt;T&gt; of these elements.</summary>
        public static object ListOf(Type type, IList elements)
        {
            if (type.IsArray)
            {
                var array = Array.CreateInstance(type.GetElementType(), elements.Count);
                for (var i = 0; i < elements.Count; i++) array.SetValue(elements[i], i);
                return array;
            }
            var list = (IList)Activator.CreateInstance(type);
            foreach (var item in elements) list.Add(item);
            return list;
        }
    }
}
