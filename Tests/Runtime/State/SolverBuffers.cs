using System;
using System.Collections.Generic;
using System.Reflection;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>All graphics buffers that a solver and its stages hold, found by reflection, so that none can be forgotten: by their name in a
    /// <see cref="BufferSet"/>, or by their path from the solver or a stage.</summary>
    static class SolverBuffers
    {
        public static Dictionary<string, GraphicsBuffer> Of(PbfSolver solver)
        {
            var found = new Dictionary<string, GraphicsBuffer>();
            var seen = new HashSet<object> { solver };
            var next = new Queue<(object owner, string path)>();
            next.Enqueue((solver, ""));
            while (next.Count > 0)      // by the shortest path
            {
                (object owner, string path) = next.Dequeue();
                Add(owner, path, found, seen, next);
            }
            var named = new HashSet<GraphicsBuffer>();
            foreach (KeyValuePair<string, GraphicsBuffer> buffer in found)
                if (buffer.Key.StartsWith(Prefix))
                    named.Add(buffer.Value);
            foreach (string path in new List<string>(found.Keys))
                if (!path.StartsWith(Prefix) && named.Contains(found[path]))
                    found.Remove(path);
            return found;
        }

        const string Prefix = "Rill.";      // of the names in sets

        static void AddSet(BufferSet set, Dictionary<string, GraphicsBuffer> found)
        {
            foreach (object item in (System.Collections.IEnumerable)FieldOf(set, "items"))
                if (FieldOf(item, "buffer") is GraphicsBuffer buffer)
                    found[(string)FieldOf(item, "name")] = buffer;
        }

        static object FieldOf(object owner, string name)
            => owner.GetType().GetField(name, BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic).GetValue(owner);

        static IEnumerable<FieldInfo> Fields(Type type)
        {
            const BindingFlags Own = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;
            for (; type != null && type != typeof(object); type = type.BaseType)
                foreach (FieldInfo field in type.GetFields(Own))
                    yield return field;
        }

        static void Add(object owner, string path, Dictionary<string, GraphicsBuffer> found, HashSet<object> seen, Queue<(object, string)> next)
        {
            if (owner is BufferSet set)
            {
                AddSet(set, found);
                return;
            }
            foreach (FieldInfo field in Fields(owner.GetType()))
            {
                object value = field.GetValue(owner);
                string name = path + Name(field);
                if (value is Array array)
                    for (int i = 0; i < array.Length; i++)
                        AddValue(array.GetValue(i), array.GetValue(i) is Stage stage ? stage.GetType().Name : name, found, seen, next);
                else
                    AddValue(value, name, found, seen, next);
            }
        }

        static void AddValue(object value, string name, Dictionary<string, GraphicsBuffer> found, HashSet<object> seen, Queue<(object, string)> next)
        {
            if (value is GraphicsBuffer buffer)
                found[name] = buffer;
            else if (value != null && value.GetType().IsClass && value.GetType().Assembly == typeof(PbfSolver).Assembly
                && !(value is UnityEngine.Object) && !(value is Delegate) && seen.Add(value))
                next.Enqueue((value, name + "."));
        }

        // A property's field is named for the property.
        static string Name(FieldInfo field) => field.Name.StartsWith("<") ? field.Name.Substring(1, field.Name.IndexOf('>') - 1) : field.Name;
    }
}
