using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Runtime.CompilerServices;

namespace UnityEngine.Headless
{
    /// <summary>Which assemblies are of scripts: they use the engine and are neither a part of it nor of the host.</summary>
    internal static class ScriptAssemblies
    {
        static readonly Assembly engine = typeof(ScriptAssemblies).Assembly;
        // The engine's parts and the host's see its internals.
        static readonly HashSet<string> hosts =
            engine.GetCustomAttributes<InternalsVisibleToAttribute>().Select(friend => friend.AssemblyName).ToHashSet();

        /// <summary>Those that are loaded, in the order in which they were.</summary>
        public static IEnumerable<Assembly> Loaded => AppDomain.CurrentDomain.GetAssemblies().Where(IsOfScripts);

        public static bool IsOfScripts(Assembly assembly)
            => !assembly.IsDynamic && !IsEngines(assembly) && !hosts.Contains(assembly.GetName().Name)
            && assembly.GetReferencedAssemblies().Any(reference => reference.Name == engine.GetName().Name);

        /// <summary>Whether an assembly stands for one of Unity's own.</summary>
        public static bool IsEngines(Assembly assembly)
        {
            string name = assembly.GetName().Name;
            return name.StartsWith("Unity.", StringComparison.Ordinal) || name.StartsWith("UnityEngine", StringComparison.Ordinal)
                || name.StartsWith("UnityEditor", StringComparison.Ordinal);
        }
    }
}
