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
        // The engine's parts and the host's see its internals.
        static readonly HashSet<string> hosts = typeof(ScriptAssemblies).Assembly.GetCustomAttributes<InternalsVisibleToAttribute>()
            .Select(friend => friend.AssemblyName).ToHashSet();

        /// <summary>Those that are loaded, in the order in which they were.</summary>
        public static IEnumerable<Assembly> Loaded => AppDomain.CurrentDomain.GetAssemblies().Where(IsOfScripts);

        public static bool IsOfScripts(Assembly assembly)
            => !assembly.IsDynamic && !IsEngines(assembly) && !hosts.Contains(assembly.GetName().Name)
            && assembly.GetReferencedAssemblies().Any(IsEngines);

        /// <summary>Whether an assembly stands for one of Unity's own.</summary>
        public static bool IsEngines(Assembly assembly) => IsEngines(assembly.GetName());

        static bool IsEngines(AssemblyName assembly)
            => assembly.Name.StartsWith("Unity.", StringComparison.Ordinal) || assembly.Name.StartsWith("UnityEngine", StringComparison.Ordinal)
            || assembly.Name.StartsWith("UnityEditor", StringComparison.Ordinal);
    }
}
