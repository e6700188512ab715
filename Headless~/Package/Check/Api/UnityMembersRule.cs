using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection.Metadata;
using Host.UnityApi;

namespace Host.Check.Api
{
    /// <summary>Whatever the package's assemblies name in Unity's is there in every supported version, with that signature, and not
    /// obsolete.</summary>
    sealed class UnityMembersRule : Rule
    {
        const string Mathematics = "com.unity.mathematics";

        // A name that Unity 6 keeps beside a new one, which older versions lack.
        static readonly HashSet<string> Renamed = new HashSet<string>
        {
            "UnityEngine.Rigidbody.set_velocity(UnityEngine.Vector3)",      // linearVelocity: BodyPlacement.SetVelocity
        };

        readonly IReadOnlyList<string> names;
        readonly Func<IReadOnlyList<ApiCatalog>> lists;

        public UnityMembersRule(IReadOnlyList<string> assemblies = null, Func<IReadOnlyList<ApiCatalog>> lists = null)
        {
            names = assemblies ?? PackageAssemblies.Package;
            this.lists = lists ?? (() => UnityCatalogs.Supported);
        }

        public override string Name => "API: every Unity member exists in every version";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            IReadOnlyList<ApiCatalog> versions = lists();
            foreach (string line in UnityCatalogs.Unreadable(versions))
                findings.Fault($"API lists: {line}: teach Headless~/Engine/UnityApi/SignatureParser.cs this form.");

            if (package.Has("package.json") && PackageManifest.Read(package, findings)?.Dependencies.Find(d => d.Key == Mathematics).Value
                is string lowest && lowest != UnityApiLists.OldestMathematics)
                findings.Fault($"package.json lets projects have {Mathematics} {lowest}, and what is compared is " +
                    $"{UnityApiLists.OldestMathematics}: make " +
                    $"Headless~/Engine/data/unity-api/mathematics-after-{UnityApiLists.OldestMathematics}.txt over");

            var types = new HashSet<string>();
            var members = new HashSet<string>();
            foreach (CompiledAssembly assembly in PackageAssemblies.Open(package, names, findings))
                using (assembly)
                    Examine(assembly, versions, types, members, findings, (what, complaint) => Renamed.Contains(what)
                        && complaint == "has it as obsolete");
            findings.Looked = $"{types.Count} types and {members.Count} members of Unity against " +
                $"{string.Join(", ", versions.Select(unity => $"{unity.Version} ({unity.Types.Count} types, {unity.MemberCount} members)"))}";
            return findings;
        }

        /// <summary>Compares what one assembly names with these versions.</summary>
        /// <param name="isKnown">Faults that are meant so: what is named, and the complaint. Null: none.</param>
        internal static void Examine(CompiledAssembly assembly, IReadOnlyList<ApiCatalog> versions, ISet<string> types,
            ISet<string> members, Findings findings, Func<string, string, bool> isKnown = null)
        {
            foreach (ApiTypeName type in assembly.TypesUsed.Where(use => IsUnity(use.Assembly)).Select(use => use.Type))
            {
                types.Add(type.Key);
                Report(findings, assembly, type.ToString(), versions, unity => ApiLookup.Complaint(unity, type), isKnown);
            }
            foreach ((_, CompiledMember member, MemberReferenceHandle reference) in assembly.MembersUsed.Where(use => IsUnity(use.Assembly)))
            {
                members.Add(member.ToString());
                Report(findings, assembly, member.ToString(), versions, unity => ApiLookup.Complaint(unity, member), isKnown, reference);
            }
            foreach (CompiledMember member in assembly.AttributeArguments(IsUnity, versions[^1]))
            {
                members.Add(member.ToString());
                Report(findings, assembly, member.ToString(), versions, unity => ApiLookup.Complaint(unity, member), isKnown);
            }
            foreach (Inheritance inheritance in Inheritance.Of(assembly))
                inheritance.Examine(versions, members, (what, complaint) => Report(findings, assembly, what, versions, complaint, isKnown));
        }

        public static bool IsUnity(string assembly) => assembly.StartsWith("UnityEngine", StringComparison.Ordinal)
            || assembly.StartsWith("UnityEditor", StringComparison.Ordinal) || assembly.StartsWith("Unity.", StringComparison.Ordinal);

        static string User(CompiledAssembly assembly, MemberReferenceHandle reference)
            => !reference.IsNil && assembly.FirstUser(reference) is { } user ? $"; first used in {user}" : "";

        // One line for all versions that say the same.
        static void Report(Findings findings, CompiledAssembly assembly, string what, IReadOnlyList<ApiCatalog> versions,
            Func<ApiCatalog, string> complain, Func<string, string, bool> isKnown, MemberReferenceHandle reference = default)
        {
            foreach (IGrouping<string, string> same in versions.Where(unity => unity.IsFor(what))
                .Select(unity => (unity.Version, complaint: complain(unity)))
                .Where(v => v.complaint != null && !(isKnown != null && isKnown(what, v.complaint)))
                .GroupBy(v => v.complaint, v => v.Version))
                findings.Fault($"{assembly.Name}.dll: {what}: Unity {string.Join(", ", same)} {same.Key}{User(assembly, reference)}");
        }
    }
}
