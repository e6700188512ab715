using System;
using System.Linq;
using System.Reflection;

namespace UnityEngine.Headless
{
    /// <summary>Runs [RuntimeInitializeOnLoadMethod] methods of every loaded assembly that uses this one.</summary>
    internal static class Initializers
    {
        public static void Run(RuntimeInitializeLoadType type)
        {
            Assembly engine = typeof(Initializers).Assembly;
            foreach (Assembly assembly in AppDomain.CurrentDomain.GetAssemblies())
            {
                if (assembly.IsDynamic || assembly != engine && assembly.GetReferencedAssemblies().All(r => r.Name != engine.GetName().Name))
                    continue;
                foreach (Type owner in assembly.GetTypes())
                    foreach (MethodInfo method in owner.GetMethods(BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic
                        | BindingFlags.DeclaredOnly))
                        foreach (RuntimeInitializeOnLoadMethodAttribute mark in method.GetCustomAttributes<RuntimeInitializeOnLoadMethodAttribute>())
                            if (mark.loadType == type)
                                Messages.Invoke(null, method);
            }
        }
    }
}
