using System.Collections.Generic;
using System.Linq;
using System.Reflection;

namespace Host.Scripts.Assemblies
{
    /// <summary>Assemblies that scripts are compiled against beside the player's where a project's tests run, as in the Editor's Test
    /// Runner.</summary>
    internal sealed class TestAssemblies
    {
        public const string Runner = "UnityEngine.TestRunner", EditorRunner = "UnityEditor.TestRunner", Editor = "UnityEditor",
            NUnit = "nunit.framework";

        public readonly IReadOnlyList<Assembly> All;

        /// <param name="all">The host's UnityEditor and test runner, and NUnit.</param>
        public TestAssemblies(params Assembly[] all) => All = all.ToList();
    }
}
