using System;
using System.Collections.Generic;
using System.Reflection;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>All graphics buffers that a solver and its stages hold, found by reflection, so that none can be forgotten: by their path
    /// from the solver.</summary>
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
            return found;
        }

        static void Add(object owner, string path, Dictionary<string, GraphicsBuffer> found, HashSet<object> seen, Queue<(object, string)> next)
        {
            foreach (FieldInfo field in owner.GetType().GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic))
            {
                object value = field.GetValue(owner);
                string name = path + Name(field);
                if (value is Array array)
                    for (int i = 0; i < array.Length; i++)
                        AddValue(array.GetValue(i), name, found, seen, next);
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
