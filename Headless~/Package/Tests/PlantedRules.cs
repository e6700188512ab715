using System.Collections.Generic;
using Host.Check;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>Rules over planted assemblies.</summary>
    static class PlantedRules
    {
        public static Findings Examine(this PlantedAssemblies planted, Rule rule) => rule.Examine(new PackageTree(planted.Root, planted.Assemblies));

        /// <summary>The rule has this one fault to tell, with these words in it.</summary>
        public static void Catches(this PlantedAssemblies planted, Rule rule, params string[] words)
        {
            List<string> faults = planted.Examine(rule).Faults;
            Assert.That(faults, Has.Count.EqualTo(1), string.Join("\n", faults));
            foreach (string word in words)
                Assert.That(faults[0], Does.Contain(word));
        }
    }
}
