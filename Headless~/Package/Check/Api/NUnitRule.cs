using System.Collections.Generic;
using System.Linq;
using Host.UnityApi;

namespace Host.Check.Api
{
    /// <summary>Unity's Test Framework carries NUnit 3.5; here the tests are compiled against 3.6, the oldest to be had.</summary>
    sealed class NUnitRule : Rule
    {
        // Additions of 3.6, by NUnit's change log: multiple asserts, warnings, the mark of assemblies without tests.
        static readonly HashSet<string> NewTypes = new() { "NUnit.Framework.Warn", "NUnit.Framework.MultipleAssertException",
            "NUnit.Framework.NonTestAssemblyAttribute" };
        static readonly HashSet<string> NewMembers = new() { "NUnit.Framework.Assert.Multiple", "NUnit.Framework.Assert.Warn" };

        readonly IReadOnlyList<string> names;

        public NUnitRule(IReadOnlyList<string> assemblies = null)
            => names = assemblies ?? PackageAssemblies.Package.Where(name => name.EndsWith(".Tests")).ToList();

        public override string Name => "API: the tests use nothing of NUnit beyond 3.5";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            var members = new HashSet<string>();
            foreach (CompiledAssembly assembly in PackageAssemblies.Open(package, names, findings))
                using (assembly)
                {
                    foreach (ApiTypeName type in assembly.TypesUsed.Where(use => IsNUnit(use.Assembly) && NewTypes.Contains(use.Type.Key))
                        .Select(use => use.Type))
                        findings.Fault($"{assembly.Name}.dll uses {type}: NUnit 3.5 has no such type, 3.6 brought it.");
                    foreach (CompiledMember member in assembly.MembersUsed.Where(use => IsNUnit(use.Assembly)).Select(use => use.Member))
                    {
                        members.Add(member.ToString());
                        if (NewMembers.Contains($"{member.Owner.Key}.{member.Name}"))
                            findings.Fault($"{assembly.Name}.dll uses {member}: NUnit 3.5 has no such member, 3.6 brought it.");
                    }
                }
            findings.Looked = $"{members.Count} members of NUnit against the {NewTypes.Count + NewMembers.Count} that came with 3.6";
            return findings;
        }

        static bool IsNUnit(string assembly) => assembly == "nunit.framework";
    }
}
