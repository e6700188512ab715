using System;
using System.Collections.Generic;
using System.Reflection;
using System.Runtime.Serialization;
using UnityEngine.Headless;

namespace UnityEngine
{
    /// <summary>The fields that Unity serializes, as JSON.</summary>
    public class JsonUtility
    {
        public static string ToJson(object obj) => ToJson(obj, false);

        public static string ToJson(object obj, bool prettyPrint)
        {
            if (obj == null)
                return "";
            if (obj is Object && !(obj is MonoBehaviour) && !(obj is ScriptableObject))
                throw new ArgumentException("JsonUtility.ToJson does not support engine types.");
            (obj as ISerializationCallbackReceiver)?.OnBeforeSerialize();
            return new JsonWriter(prettyPrint).Write(obj);
        }

        public static T FromJson<T>(string json) => (T)FromJson(json, typeof(T));

        public static object FromJson(string json, Type type)
        {
            if (type == null)
                throw new ArgumentNullException(nameof(type));
            if (string.IsNullOrEmpty(json))
                return null;
            if (type.IsAbstract || typeof(Object).IsAssignableFrom(type))
                throw new ArgumentException($"Cannot deserialize JSON to new instances of type '{type.Name}.'");
            object made = Make(type);
            Fill(json, ref made);
            return made;
        }

        public static void FromJsonOverwrite(string json, object objectToOverwrite)
        {
            if (string.IsNullOrEmpty(json))
                return;
            if (objectToOverwrite == null)
                throw new ArgumentNullException(nameof(objectToOverwrite));
            Fill(json, ref objectToOverwrite);
        }

        static void Fill(string json, ref object target)
        {
            if (!(JsonReader.Read(json) is Dictionary<string, object> fields))
                throw new ArgumentException("JSON must represent an object type.");
            JsonFields.Read(ref target, fields);
            (target as ISerializationCallbackReceiver)?.OnAfterDeserialize();
        }

        internal static object Make(Type type)
            => type.IsValueType || type.GetConstructor(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic, null,
                Type.EmptyTypes, null) != null
                ? Activator.CreateInstance(type, true)
                : FormatterServices.GetUninitializedObject(type);
    }
}
