using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Runtime.CompilerServices;
using UnityEngine.Headless;

namespace UnityEditor
{
    /// <summary>Runs [InitializeOnLoad] classes and [InitializeOnLoadMethod] methods, as the Editor does when it loads scripts: once for each
    /// assembly that uses this one, and again after a reload.</summary>
    internal static class EditorInitializers
    {
        static readonly HashSet<Assembly> known = new HashSet<Assembly>();

        /// <summary>For what is loaded, and for what will be.</summary>
        public static void Run()
        {
            PlayerLoop.UpdateEditor = EditorTick.Call;
            AppDomain.CurrentDomain.AssemblyLoad -= OnLoad;
            AppDomain.CurrentDomain.AssemblyLoad += OnLoad;
            foreach (Assembly assembly in AppDomain.CurrentDomain.GetAssemblies())
                Run(assembly);
        }

        /// <summary>Runs those of the scripts that a reload has loaded again.</summary>
        public static void RunAgain(ScriptStatics statics)
            => Run(known.Where(ScriptAssemblies.IsOfScripts).SelectMany(assembly => assembly.GetTypes()).ToList(), statics.Initialize);

        /// <summary>Whether a class has its initializer run here.</summary>
        public static bool RunsOnLoad(Type type) => type.IsDefined(typeof(InitializeOnLoadAttribute), false);

        static void OnLoad(object sender, AssemblyLoadEventArgs loaded) => Run(loaded.LoadedAssembly);

        static void Run(Assembly assembly)
        {
            string own = typeof(EditorInitializers).Assembly.GetName().Name;
            if (assembly.IsDynamic || assembly.GetReferencedAssemblies().All(reference => reference.Name != own) || !known.Add(assembly))
                return;
            Run(assembly.GetTypes(), type => RuntimeHelpers.RunClassConstructor(type.TypeHandle));
        }

        static void Run(IReadOnlyList<Type> types, Action<Type> initialize)
        {
            foreach (Type type in types.Where(RunsOnLoad))
                initialize(type);
            foreach (Type type in types)
                foreach (MethodInfo method in type.GetMethods(BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic
                    | BindingFlags.DeclaredOnly))
                    if (method.IsDefined(typeof(InitializeOnLoadMethodAttribute), false))
                        Messages.Invoke(null, method);
        }
    }
}
