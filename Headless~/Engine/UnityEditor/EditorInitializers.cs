using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using UnityEngine.Headless;

namespace UnityEditor
{
    /// <summary>Runs [InitializeOnLoadMethod] methods, as the Editor does when it loads scripts: once for each assembly that uses this one.</summary>
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

        static void OnLoad(object sender, AssemblyLoadEventArgs loaded) => Run(loaded.LoadedAssembly);

        static void Run(Assembly assembly)
        {
            string own = typeof(EditorInitializers).Assembly.GetName().Name;
            if (assembly.IsDynamic || assembly.GetReferencedAssemblies().All(reference => reference.Name != own) || !known.Add(assembly))
                return;
            foreach (Type type in assembly.GetTypes())
                foreach (MethodInfo method in type.GetMethods(BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic
                    | BindingFlags.DeclaredOnly))
                    if (method.IsDefined(typeof(InitializeOnLoadMethodAttribute), false))
                        Messages.Invoke(null, method);
        }
    }
}
