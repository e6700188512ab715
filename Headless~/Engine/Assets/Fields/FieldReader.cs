using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Reflection;
using System.Runtime.CompilerServices;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Host.Assets
{
    /// <summary>Finds the object that a reference in a file means; null after it has reported why there is none.</summary>
    internal delegate Object ReferenceResolver(FileReference reference, Type fieldType, ReadScope scope);

    /// <summary>Puts a document's values into an object's serialized fields, as Unity does when it loads the object. One reader for one
    /// object.</summary>
    internal sealed class FieldReader
    {
        // Unity stops here too: a [Serializable] class that holds itself would have no end.
        const int MaxDepth = 10;

        readonly ReferenceResolver resolve;
        readonly Action<string> warn, fail;
        readonly Func<string, string, string, Type> findManagedType;
        readonly Dictionary<long, object> managed = new Dictionary<long, object>();
        YamlMapping managedSource;

        /// <param name="warn">Takes what Unity passes over in silence: keys without a field.</param>
        /// <param name="fail">Takes values that do not fit; it may throw.</param>
        /// <param name="findManagedType">Class, namespace and assembly of a [SerializeReference] value to its type.</param>
        public FieldReader(ReferenceResolver resolve, Action<string> warn, Action<string> fail, Func<string, string, string, Type> findManagedType)
        {
            this.resolve = resolve;
            this.warn = warn;
            this.fail = fail;
            this.findManagedType = findManagedType;
        }

        // Keys of every script's document that are not fields of it.
        static readonly HashSet<string> Bookkeeping = new HashSet<string>
        {
            "m_ObjectHideFlags", "m_CorrespondingSourceObject", "m_PrefabInstance", "m_PrefabAsset", "m_PrefabParentObject", "m_PrefabInternal",
            "m_GameObject", "m_Enabled", "m_EditorHideFlags", "m_GeneratorAsset", "m_Script", "m_Name", "m_EditorClassIdentifier",
                "references", "serializedVersion",
        };

        /// <summary>Reads a MonoBehaviour or ScriptableObject. A key that the file lacks keeps what the constructor left.</summary>
        public void Read(Object target, YamlMapping fields, ReadScope scope)
        {
            managedSource = fields["references"] as YamlMapping;
            ReadFields(target, target.GetType(), fields, scope);
            if (target is ISerializationCallbackReceiver receiver) receiver.OnAfterDeserialize();
        }

        void ReadFields(object target, Type type, YamlMapping source, ReadScope scope)
        {
            var fields = FieldMap.Of(type);
            foreach (var field in fields)
            {
                scope.Enter(field.Info.Name);
                var node = field.In(source);
                var current = field.Info.GetValue(target);
                if (node == null) { if (current == null) field.Info.SetValue(target, EmptyOf(field, scope.Depth)); }
                else if (field.ByReference) field.Info.SetValue(target, ReadManaged(field.Type, node, scope));
                else if (TryRead(field.Type, current, node, scope, out var value)) field.Info.SetValue(target, value);
                scope.Leave();
            }
            // Omissions of the host's engine in its own classes are not faults of the project.
            foreach (var entry in source.Entries)
                if (!Bookkeeping.Contains(entry.Key) && !fields.Any(f => f.IsNamed(entry.Key)) && !FieldMap.IsEngine(type)
                    && !FieldMap.StandsForPackage(type))
                    warn($"{entry.Value.Location}: {scope}: {type.Name} has no serialized field '{entry.Key}'; a renamed one needs " +
                        $"[FormerlySerializedAs(\"{entry.Key}\")], otherwise save the file again");
        }

        /// <summary>False after a message, when the value does not fit and the field keeps what it had.</summary>
        public bool TryRead(Type type, object current, YamlNode node, ReadScope scope, out object value)
        {
            value = current;
            if (node is YamlUnset) return true;
            if (typeof(Object).IsAssignableFrom(type))
            {
                if (!FileReference.Is(node) && !IsEmpty(node)) return Misfit(type, node, scope);
                var reference = FileReference.Of(node);
                value = reference.IsNone ? null : resolve(reference, type, scope);
                return true;
            }
            var element = FieldMap.ElementOf(type);
            if (element != null) return TryReadList(type, element, node, scope, out value);
            if (type == typeof(string) || type.IsPrimitive || type.IsEnum)
            {
                if (node is not YamlScalar scalar) return Misfit(type, node, scope);
                // Unity writes nothing for the empty string only; for a number it cannot happen by its own hand.
                if (scalar.IsEmpty && type != typeof(string)) return Misfit(type, node, scope);
                return TryReadScalar(type, scalar, scope, out value);
            }
            if (node is not YamlMapping mapping) return IsEmpty(node) || Misfit(type, node, scope);
            if (BuiltInValues.TryRead(type, mapping, out value)) return true;

            value = current ?? New(type);
            ReadGroup(ref value, type, mapping, scope);
            return true;
        }

        void ReadGroup(ref object value, Type type, YamlMapping mapping, ReadScope scope)
        {
            // Unity.Mathematics.quaternion: some versions write its four numbers without the field "value" between.
            var inner = mapping["value"] == null && mapping["w"] != null ? type.GetField("value") : null;
            if (inner != null)
            {
                object four = inner.GetValue(value);
                ReadFields(four, inner.FieldType, mapping, scope);
                inner.SetValue(value, four);
            }
            else ReadFields(value, type, mapping, scope);
            if (value is ISerializationCallbackReceiver receiver) receiver.OnAfterDeserialize();
        }

        bool Misfit(Type type, YamlNode node, ReadScope scope)
        {
            fail($"{node.Location}: {scope} is of type {type.Name}, but the file has {node.Kind}");
            return false;
        }

        static bool IsEmpty(YamlNode node) => node is YamlScalar { IsEmpty: true };

        bool TryReadScalar(Type type, YamlScalar scalar, ReadScope scope, out object value)
        {
            try
            {
                value = Scalar(type, scalar);
                return true;
            }
            catch (AssetException e)
            {
                fail($"{e.Message}, as {scope} ({type.Name}) needs it");
                value = null;
                return false;
            }
        }

        static object Scalar(Type type, YamlScalar scalar)
        {
            if (type == typeof(string)) return scalar.Value;
            if (type.IsEnum) return Enum.ToObject(type, scalar.ToLong());
            switch (Type.GetTypeCode(type))
            {
                case TypeCode.Boolean: return scalar.ToLong() != 0;
                case TypeCode.Single: return scalar.ToFloat();
                case TypeCode.Double: return scalar.ToDouble();
                case TypeCode.Int32: return scalar.ToInt();
                case TypeCode.UInt32: return unchecked((uint)scalar.ToInt());
                case TypeCode.Int64: return scalar.ToLong();
                case TypeCode.UInt64: return unchecked((ulong)scalar.ToLong());
                case TypeCode.Int16: return checked16(scalar, short.MinValue, ushort.MaxValue, v => unchecked((short)v));
                case TypeCode.UInt16: return checked16(scalar, short.MinValue, ushort.MaxValue, v => unchecked((ushort)v));
                case TypeCode.Char: return checked16(scalar, 0, char.MaxValue, v => (char)v);
                case TypeCode.SByte: return checked16(scalar, sbyte.MinValue, byte.MaxValue, v => unchecked((sbyte)v));
                case TypeCode.Byte: return checked16(scalar, sbyte.MinValue, byte.MaxValue, v => unchecked((byte)v));
                default: throw scalar.Location.Error($"the host reads no {type.Name}");
            }

            static object checked16(YamlScalar scalar, long low, long high, Func<long, object> cast)
            {
                var number = scalar.ToLong();
                return number >= low && number <= high ? cast(number)
                    : throw scalar.Location.Error($"{number} does not lie between {low} and {high}");
            }
        }

        bool TryReadList(Type type, Type element, YamlNode node, ReadScope scope, out object value)
        {
            var items = new List<object>();
            value = null;
            if (node is YamlSequence sequence)
            {
                for (var i = 0; i < sequence.Elements.Count; i++)
                {
                    scope.Enter(i);
                    var fresh = element.IsValueType ? Activator.CreateInstance(element) : null;
                    items.Add(TryRead(element, fresh, sequence.Elements[i], scope, out var item) && item != null ? item : fresh);
                    scope.Leave();
                }
            }
            else if ((node as YamlPackedList)?.Packed is YamlScalar packed || (packed = node as YamlScalar) != null && !packed.IsEmpty)
            {
                if (!(element.IsPrimitive || element.IsEnum) || !PackedNumbers.TryRead(element, packed.Value, items))
                    return Misfit(type, node, scope);
                if (node is YamlPackedList overridden) Override(element, items, overridden, scope);
            }
            else if (!IsEmpty(node) && node is not YamlMapping { Entries: { Count: 0 } }) return Misfit(type, node, scope);
            value = FieldMap.ListOf(type, items);
            return true;
        }

        void Override(Type element, List<object> items, YamlPackedList list, ReadScope scope)
        {
            foreach (var change in list.Changes)
            {
                var size = change.Key == YamlPackedList.Size ? change.Value.ToInt() : Math.Max(items.Count, change.Key + 1);
                if (size < items.Count) items.RemoveRange(size, items.Count - size);
                while (items.Count < size) items.Add(items.Count > 0 ? items[items.Count - 1] : Activator.CreateInstance(element));
                if (change.Key != YamlPackedList.Size && TryReadScalar(element, change.Value, scope, out var item)) items[change.Key] = item;
            }
        }

        // ---- [SerializeReference]: the field holds a number, the objects lie under "references"

        object ReadManaged(Type type, YamlNode node, ReadScope scope)
        {
            var element = FieldMap.ElementOf(type);
            if (element != null)
                return FieldMap.ListOf(type, ((node as YamlSequence)?.Elements ?? new List<YamlNode>())
                    .Select(item => ReadManaged(element, item, scope)).ToList());
            var id = node["rid"] is YamlScalar rid ? rid.ToLong() : -2;
            if (id < 0) return null;
            var found = ManagedObject(id, node, scope);
            if (found == null || type.IsInstanceOfType(found)) return found;
            fail($"{node.Location}: {scope} is of type {type.Name}, but the referenced object {id} is a {found.GetType().Name}");
            return null;
        }

        object ManagedObject(long id, YamlNode at, ReadScope scope)
        {
            if (managed.TryGetValue(id, out var known)) return known;
            var entry = managedSource?.Items("RefIds").FirstOrDefault(r => r["rid"] is YamlScalar rid && rid.ToLong() == id);
            if (entry == null)
            {
                fail($"{at.Location}: {scope}: no object {id} under 'references' of this document");
                return null;
            }
            var name = entry["type"];
            var type = findManagedType(name.Text("class"), name.Text("ns"), name.Text("asm"));
            if (type == null)
            {
                fail($"{entry.Location}: {scope}: the type {name.Text("ns")}.{name.Text("class")} of assembly {name.Text("asm")} does " +
                    $"not exist: a moved one needs [MovedFrom]");
                return null;
            }
            var value = managed[id] = New(type);
            if (entry["data"] is YamlMapping data) ReadGroup(ref value, type, data, scope);
            return managed[id] = value;
        }

        // ---- what Unity leaves in fields that a file lacks: never null, except for references

        object EmptyOf(MappedField field, int depth)
        {
            if (field.ByReference || typeof(Object).IsAssignableFrom(field.Type)) return null;
            if (field.Type == typeof(string)) return "";
            if (FieldMap.ElementOf(field.Type) != null) return FieldMap.ListOf(field.Type, Array.Empty<object>());
            if (depth > MaxDepth) return null;
            var value = New(field.Type);
            FillNulls(value, depth + 1);
            return value;
        }

        void FillNulls(object target, int depth)
        {
            if (BuiltInValues.Has(target.GetType())) return;
            foreach (var field in FieldMap.Of(target.GetType()))
                if (field.Info.GetValue(target) == null) field.Info.SetValue(target, EmptyOf(field, depth));
        }

        // Creates like Unity, which needs no constructor, but runs one without parameters if it exists.
        static object New(Type type) =>
            type.IsValueType || type.GetConstructor(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic, null,
            Type.EmptyTypes, null) != null
                ? Activator.CreateInstance(type, true)
                : RuntimeHelpers.GetUninitializedObject(type);
    }
}
