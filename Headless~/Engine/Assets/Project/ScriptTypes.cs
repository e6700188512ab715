using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Host.Assets
{
    /// <summary>From a script file to the class that Unity would take for it: the one named as the file.</summary>
    internal sealed class ScriptTypes
    {
        static readonly Regex Namespace = new Regex(@"^\s*namespace\s+([\w.]+)", RegexOptions.Multiline | RegexOptions.Compiled);

        readonly ILookup<string, Type> byName;
        readonly Dictionary<string, Assembly> assemblies = new Dictionary<string, Assembly>();

        public ScriptTypes(IEnumerable<Assembly> assemblies)
        {
            foreach (var assembly in assemblies) this.assemblies[assembly.GetName().Name] = assembly;
            byName = this.assemblies.Values.SelectMany(LoadableTypes)
                .Where(t => !t.IsAbstract && !t.IsGenericTypeDefinition && !t.IsNested
                    && (typeof(MonoBehaviour).IsAssignableFrom(t) || typeof(ScriptableObject).IsAssignableFrom(t)))
                .ToLookup(t => t.Name);
        }

        /// <summary>Null with the reason in problem.</summary>
        public Type Find(AssetEntry script, out string problem)
        {
            problem = null;
            var candidates = byName[script.Name].ToArray();
            if (candidates.Length > 1)
            {
                // One name in several namespaces or assemblies: the file itself says which namespace it means.
                var spaces = Namespace.Matches(File.ReadAllText(script.File)).Select(m => m.Groups[1].Value).DefaultIfEmpty("").ToHashSet();
                candidates = candidates.Where(t => spaces.Contains(t.Namespace ?? "")).ToArray();
            }
            if (candidates.Length == 1) return candidates[0];
            problem = candidates.Length == 0
                ? $"{script.Path} has no MonoBehaviour or ScriptableObject named {script.Name} in the loaded assemblies " +
                $"({string.Join(", ", assemblies.Keys.OrderBy(n => n))}): class and file must have the same name, and the file must " +
                $"have compiled"
                : $"{script.Path} could be any of {string.Join(", ", candidates.Select(t => t.AssemblyQualifiedName))}: rename all but one";
            return null;
        }

        /// <summary>A [SerializeReference] value's class; nested classes are written "Outer/Inner".</summary>
        public Type FindManaged(string name, string space, string assembly) =>
            assemblies.TryGetValue(assembly, out var found) ? found.GetType((space.Length > 0 ? space + "." : "") + name.Replace('/', '+')) : null;

        static IEnumerable<Type> LoadableTypes(Assembly assembly)
        {
            try
            {
                return assembly.GetTypes();
            }
            catch (ReflectionTypeLoadException e)
            {
                // A foreign project's assembly may miss a dependency; its other types are still good.
                return e.Types.Where(t => t != null);
            }
        }
    }
}
