using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using NUnit.Framework.Interfaces;
using UnityEngine.TestTools;

namespace UnityEngine.Headless
{
    /// <summary>Finds and runs the IPrebuildSetup and IPostBuildCleanup classes that tests name or are, each once.</summary>
    internal static class BuildSetups
    {
        public static void Setup(ITest tests)
            => Run<IPrebuildSetup>(tests, member => member.GetCustomAttribute<PrebuildSetupAttribute>()?.TargetClass,
            setup => setup.Setup());

        public static void Cleanup(ITest tests)
            => Run<IPostBuildCleanup>(tests, member => member.GetCustomAttribute<PostBuildCleanupAttribute>()?.TargetClass,
            cleanup => cleanup.Cleanup());

        static void Run<T>(ITest tests, Func<MemberInfo, string> target, Action<T> run)
        {
            var types = new HashSet<Type>();
            foreach (ITest leaf in Leaves(tests))
            {
                Type fixture = leaf.TypeInfo.Type;
                if (typeof(T).IsAssignableFrom(fixture))
                    types.Add(fixture);
                foreach (string name in new[] { target(leaf.Method.MethodInfo), target(fixture) }.Where(name => name != null))
                    types.Add(Type.GetType(name) ?? fixture.Assembly.GetType(name)
                        ?? throw new TypeLoadException($"{leaf.FullName}: no class {name} to set up with."));
            }
            foreach (Type type in types)
                run((T)Activator.CreateInstance(type));
        }

        static IEnumerable<ITest> Leaves(ITest test) => test.IsSuite ? test.Tests.SelectMany(Leaves) : new[] { test };
    }
}
