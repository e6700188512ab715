using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Text;
using Host.UnityApi;
using UnityEngine;

namespace Host.Scripts.Stubs
{
    /// <summary>The types that Unity's lists have and the host's assemblies lack, outermost ones with those within.</summary>
    internal sealed class StubSources
    {
        // Stubs of a player: nothing of the editor's, a test's or a package's with sources of its own.
        static readonly string[] Left = { "UnityEditor.", "Unity.Mathematics.", "UnityEngine.TestTools.", "UnityEditorInternal.", "Unity.Burst." };

        public readonly List<StubType> Types = new List<StubType>();

        public StubSources(IEnumerable<ApiLine> lines, IEnumerable<Assembly> host)
        {
            var known = new HashSet<string>(host.SelectMany(a => a.GetExportedTypes()).Select(t => t.FullName.Replace('+', '.')));
            var all = new Dictionary<string, StubType>();
            foreach (var line in lines)
            {
                if (!line.Type.StartsWith("Unity", StringComparison.Ordinal)
                    || Left.Any(start => line.Type.StartsWith(start, StringComparison.Ordinal))) continue;
                if (!all.TryGetValue(line.Type, out var type)) all.Add(line.Type, type = new StubType(line.Type));
                type.Add(line.Signature);
            }
            foreach (var type in all.Values)
            {
                var outer = type.FullName.Substring(0, Math.Max(0, StubType.OuterLength(type.FullName)));
                if (all.TryGetValue(outer, out var within)) within.Nested.Add(type);
                else if (outer.Length > 0 && !known.Contains(Reflected(type.FullName))) Types.Add(type);
            }
            Relate(all);
        }

        /// <summary>"A.B&lt;T, U&gt;" as reflection writes it, "A.B`2".</summary>
        static string Reflected(string name)
        {
            var text = new StringBuilder();
            int depth = 0, count = 0;
            foreach (var c in name)
            {
                if (c == '<' && depth++ == 0) count = 1;
                else if (c == ',' && depth == 1) count++;
                else if (c == '>' && --depth == 0) text.Append('`').Append(count);
                else if (depth == 0) text.Append(c);
            }
            return text.ToString();
        }

        // Which class a base's name means is left to the compiler; here it is enough whether a class of that name is a stub.
        void Relate(Dictionary<string, StubType> all)
        {
            var stubs = Types.SelectMany(t => t.WithNested()).ToList();
            var classes = stubs.Where(t => t.Kind == "class").ToLookup(t => t.ShortName);
            string BaseOf(StubType type) => type.Bases.Count == 0 ? "" : StubType.LastPart(type.Bases[0]).Split('<')[0];
            bool Makes(StubType type, int depth)
            {
                var parent = BaseOf(type);
                if (parent.EndsWith("Attribute", StringComparison.Ordinal)) return true;
                if (depth > 12 || parent == "" || parent == type.ShortName) return false;
                return classes[parent].Any() ? classes[parent].Any(c => Makes(c, depth + 1)) : HostMakes.Contains(parent);
            }
            foreach (var type in stubs.Where(t => t.Kind == "class"))
            {
                type.BaseIsStub = classes[BaseOf(type)].Any() && BaseOf(type) != type.ShortName;
                type.MakesOf = Makes(type, 0);
            }
        }

        // Base classes of the host whose descendants the engine makes by itself.
        static readonly HashSet<string> HostMakes = StubAssembly.Host.SelectMany(a => a.GetExportedTypes())
            .Where(t => typeof(Component).IsAssignableFrom(t) || typeof(ScriptableObject).IsAssignableFrom(t)
                || typeof(Attribute).IsAssignableFrom(t)).Select(t => t.Name)
            .Concat(new[] { "Exception", "EventArgs", "SystemException" }).ToHashSet();

        public static string NamespaceOf(StubType type) => type.FullName.Substring(0, StubType.OuterLength(type.FullName));
    }
}
