using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection.Metadata;
using System.Xml.Linq;
using Host.UnityApi;

namespace Host.Check.Api
{
    /// <summary>
    /// Unity compiles the package as C# 9 against .NET Standard 2.1. Here its tests are compiled for a newer .NET (NUnit restores for
    /// nothing older), so what they name of .NET is looked up in .NET Standard's reference assembly.
    /// </summary>
    sealed class NetStandardRule : Rule
    {
        // Sources that Unity compiles, as the projects name them.
        static readonly string[] PackageFolders = { "$(PackageRoot)Runtime/", "$(PackageRoot)Editor/", "$(PackageRoot)Testing/",
            "$(PackageRoot)Tests/" };

        // Which the compiler brings in by itself where .NET has them, and does without where not.
        static readonly HashSet<string> Compilers = new() { "RefSafetyRulesAttribute", "NullableAttribute", "NullableContextAttribute",
            "NullablePublicOnlyAttribute", "DefaultInterpolatedStringHandler" };

        readonly IReadOnlyList<string> names;

        public NetStandardRule(IReadOnlyList<string> assemblies = null) => names = assemblies ?? PackageAssemblies.Package;

        public override string Name => "API: no more of .NET than netstandard2.1, no newer C# than 9";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            var members = new HashSet<string>();
            var types = new HashSet<string>();
            foreach (CompiledAssembly assembly in PackageAssemblies.Open(package, names, findings))
                using (assembly)
                    Examine(assembly, types, members, findings);
            int projects = ExamineProjects(package, findings);
            findings.Looked = $"{types.Count} types and {members.Count} members of .NET against netstandard 2.1, the language version " +
                $"of {projects} projects";
            return findings;
        }

        internal static void Examine(CompiledAssembly assembly, ISet<string> types, ISet<string> members, Findings findings)
        {
            bool isTest = assembly.Name.EndsWith(".Tests", StringComparison.Ordinal);
            foreach (string reference in assembly.References.Where(reference => !IsExpected(reference, isTest)))
                findings.Fault($"{assembly.Name}.dll references {reference}.dll, which is none of netstandard, Unity's and the " +
                    $"package's own{(isTest ? " and NUnit's" : "")}: Unity would not find it.");
            NetStandard standard = NetStandard.Loaded;
            var unknown = new HashSet<string>();
            foreach (ApiTypeName type in assembly.TypesUsed.Where(use => IsNet(use.Assembly)).Select(use => use.Type))
            {
                types.Add(type.Key);
                if (!standard.Has(type) && unknown.Add(type.Key) && !Compilers.Contains(type.Name))
                    findings.Fault($"{assembly.Name}.dll uses {type}: netstandard 2.1 has no such type.");
            }
            foreach ((_, CompiledMember member, MemberReferenceHandle reference) in assembly.MembersUsed.Where(use => IsNet(use.Assembly)
                && !unknown.Contains(use.Member.Owner.Key)))
            {
                members.Add(member.ToString());
                if (!standard.Has(member))
                    findings.Fault($"{assembly.Name}.dll uses {member}: netstandard 2.1 has no such member; first used in " +
                        $"{assembly.FirstUser(reference) ?? "an attribute"}.");
            }
        }

        static bool IsNet(string assembly) => assembly is "netstandard" or "mscorlib"
            || assembly.StartsWith("System", StringComparison.Ordinal) || assembly.StartsWith("Microsoft.", StringComparison.Ordinal);

        static bool IsExpected(string assembly, bool isTest) =>
            assembly == "netstandard" || UnityMembersRule.IsUnity(assembly) || assembly == "Rill"
            || assembly.StartsWith("Rill.", StringComparison.Ordinal) || isTest && (IsNet(assembly) || assembly == "nunit.framework");

        static int ExamineProjects(PackageTree package, Findings findings)
        {
            int projects = 0;
            foreach (string file in package.WithExtension(".csproj"))
            {
                XDocument project = XDocument.Parse(package.Read(file));
                if (!project.Descendants("Compile")
                    .Any(compile => PackageFolders.Any(folder => ((string)compile.Attribute("Include") ?? "")
                    .StartsWith(folder, StringComparison.Ordinal))))
                    continue;
                projects++;
                string[] versions = project.Descendants("LangVersion").Select(version => version.Value.Trim()).ToArray();
                if (versions.Length != 1 || versions[0] is not ("9" or "9.0"))
                    findings.Fault($"{file}: compiles the package's sources as C# " +
                        $"{(versions.Length == 0 ? "of the SDK's choice" : string.Join(", ", versions))}; Unity 2022.3 takes 9: " +
                        $"<LangVersion>9</LangVersion>.");
            }
            if (projects == 0)
                findings.Fault("no project compiles the package's sources (Compile items below $(PackageRoot)Runtime, Editor or Tests).");
            return projects;
        }
    }
}
