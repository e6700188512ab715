using System;
using System.Collections;
using System.Collections.Generic;
using System.Reflection;

namespace UnityEngine.Headless
{
    /// <summary>Copies serialized state from one object to another of the same type, as writing it out and reading it in would.</summary>
    internal static class SerializedCopy
    {
        /// <param name="copies">Originals inside the copied tree and their copies; references to them are redirected. May be null.</param>
        public static void Into(Object from, Object to, Dictionary<Object, Object> copies)
        {
            var context = new Context { Copies = copies };
            (from as ISerializationCallbackReceiver)?.OnBeforeSerialize();
            context.CopyFields(from, to);
            (to as ISerializationCallbackReceiver)?.OnAfterDeserialize();
        }

        /// <summary>A copy of a field's value as storing and reading it again would give.</summary>
        public static object Of(FieldInfo field, object value) => new Context().CopyField(field, value);

        /// <summary>Writes a value that <see cref="Of"/> made into a field. An inline class that is there stays, as in Unity, and keeps what is
        /// not serialized.</summary>
        public static void Store(FieldInfo field, object target, object value)
            => field.SetValue(target, new Context().CopyField(field, value, field.GetValue(target)));

        /// <summary>A field's value as a reload of scripts backs it up: what it cannot serialize of it is lost, and so is null.</summary>
        public static object BackUp(FieldInfo field, object value)
            => new Context { Reloads = true, Deserializes = false }.CopyField(field, value);

        /// <summary>Writes what <see cref="BackUp"/> made into a field of an object that was constructed again.</summary>
        public static void Restore(FieldInfo field, object target, object value)
            => field.SetValue(target, new Context { Reloads = true, Serializes = false }.CopyField(field, value, field.GetValue(target)));

        sealed class Context
        {
            public Dictionary<Object, Object> Copies;
            /// <summary>Takes private fields too, and no others of a struct.</summary>
            public bool Reloads;
            /// <summary>Which callbacks are told.</summary>
            public bool Serializes = true, Deserializes = true;
            readonly Dictionary<object, object> references = new Dictionary<object, object>(new ByIdentity());

            public void CopyFields(object from, object to)
            {
                foreach (FieldInfo field in Reloads ? SerializedFields.BackedUp(from.GetType()) : SerializedFields.Of(from.GetType()))
                    field.SetValue(to, CopyField(field, field.GetValue(from), field.GetValue(to)));
            }

            /// <param name="there">The field's value where the copy goes; null where it has none.</param>
            public object CopyField(FieldInfo field, object value, object there = null)
                => field.IsDefined(typeof(SerializeReference)) ? CopyReference(value) : CopyValue(value, field.FieldType, there);

            object CopyValue(object value, Type type, object there = null)
            {
                if (typeof(Object).IsAssignableFrom(type))
                    return Reloads && !Object.IsAlive((Object)value) ? null : Redirect((Object)value);
                if (type.IsPrimitive || type.IsEnum)
                    return value;
                if (type == typeof(string))
                    return value ?? "";
                if (SerializedFields.ElementType(type) is Type element)
                    return CopyList((IList)value, type, element);
                if (value is AnimationCurve curve)
                {
                    var copy = new AnimationCurve();
                    copy.CopyFrom(curve);
                    return copy;
                }
                if (value is Gradient gradient)
                    return gradient.Copy();
                if (type.IsValueType && (Reloads ? ScriptAssemblies.IsEngines(type.Assembly) : !ContainsReferences(type)))
                    return value;
                // Inline classes are never null once stored.
                if (value == null)
                    return Make(type);
                if (!SerializedFields.CanStore(value.GetType()))
                    return value;
                object made = type.IsValueType ? Reloads ? there ?? Activator.CreateInstance(type) : value
                    : there != null && there.GetType() == value.GetType() && !ReferenceEquals(there, value) ? there : Make(value.GetType());
                if (Serializes)
                    (value as ISerializationCallbackReceiver)?.OnBeforeSerialize();
                CopyFields(value, made);
                if (Deserializes)
                    (made as ISerializationCallbackReceiver)?.OnAfterDeserialize();
                return made;
            }

            object CopyList(IList list, Type type, Type element)
            {
                int count = list?.Count ?? 0;
                IList copy = type.IsArray ? Array.CreateInstance(element, count) : (IList)Activator.CreateInstance(type);
                for (int i = 0; i < count; i++)
                {
                    object item = CopyValue(list[i], element);
                    if (type.IsArray) copy[i] = item;
                    else copy.Add(item);
                }
                return copy;
            }

            // [SerializeReference]: null stays null, and one object referred to twice stays one.
            object CopyReference(object value)
            {
                if (value == null || value is string || value.GetType().IsPrimitive)
                    return value;
                if (value is Object o)
                    return Redirect(o);
                if (references.TryGetValue(value, out object known))
                    return known;
                if (value is IList list && SerializedFields.ElementType(value.GetType()) is Type element)
                {
                    IList copy = value is Array ? Array.CreateInstance(element, list.Count) : (IList)Activator.CreateInstance(value.GetType());
                    for (int i = 0; i < list.Count; i++)
                    {
                        if (value is Array) copy[i] = CopyReference(list[i]);
                        else copy.Add(CopyReference(list[i]));
                    }
                    return copy;
                }
                object made = Make(value.GetType());
                references.Add(value, made);
                CopyFields(value, made);
                return made;
            }

            Object Redirect(Object original)
                => original is object && Copies != null && Copies.TryGetValue(original, out Object copy) ? copy : original;

            static object Make(Type type)
            {
                if (type.IsValueType || type.GetConstructor(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic, null,
                    Type.EmptyTypes, null) != null)
                    return Activator.CreateInstance(type, true);
                return System.Runtime.Serialization.FormatterServices.GetUninitializedObject(type);
            }
        }

        static bool ContainsReferences(Type type)
        {
            foreach (FieldInfo field in type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic))
                if (!field.FieldType.IsPrimitive && !field.FieldType.IsEnum && !field.FieldType.IsPointer
                    && (!field.FieldType.IsValueType || ContainsReferences(field.FieldType)))
                    return true;
            return false;
        }

        sealed class ByIdentity : IEqualityComparer<object>
        {
            bool IEqualityComparer<object>.Equals(object a, object b) => ReferenceEquals(a, b);
            int IEqualityComparer<object>.GetHashCode(object o) => System.Runtime.CompilerServices.RuntimeHelpers.GetHashCode(o);
        }
    }
}
