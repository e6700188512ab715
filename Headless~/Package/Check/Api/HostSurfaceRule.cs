using System;
using System.Collections.Generic;
using System.Linq;
using Host.UnityApi;

namespace Host.Check.Api
{
    /// <summary>
    /// Code that compiles against the host compiles against Unity: every public and protected member of the host's assemblies is
    /// in the lists of the version that the host says it is, as the lists have it. What is missing here stops a project from compiling
    /// and so cannot mislead; what is too much would.
    /// </summary>
    sealed class HostSurfaceRule : Rule
    {
        readonly IReadOnlyList<string> names;
        readonly string version;

        public HostSurfaceRule(IReadOnlyList<string> assemblies = null, string version = null)
        {
            names = assemblies ?? PackageAssemblies.StandIns;
            this.version = version ?? string.Join(".", UnityEngine.Application.unityVersion.Split('.').Take(2));
        }

        public override string Name => "API: the host offers nothing that Unity lacks";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            ApiCatalog unity = UnityCatalogs.All.FirstOrDefault(catalog => catalog.Version == version);
            if (unity == null)
            {
                findings.Fault($"The host says it is Unity {version}, which has no list; there are " +
                    $"{string.Join(", ", UnityCatalogs.All.Select(catalog => catalog.Version))}.");
                return findings;
            }
            int types = 0, members = 0;
            foreach (CompiledAssembly assembly in PackageAssemblies.Open(package, names, findings))
                using (assembly)
                    Examine(assembly, unity, ref types, ref members, findings);
            findings.Looked = $"{types} types and {members} members of the host against Unity {version}";
            return findings;
        }

        /// <summary>Lists what of one assembly is too much for a version.</summary>
        internal static void Examine(CompiledAssembly assembly, ApiCatalog unity, ref int types, ref int members, Findings findings)
        {
            foreach (OfferedType type in OfferedType.Of(assembly))
            {
                types++;
                ApiType listed = unity.Find(type.Name.Key);
                string complaint = listed == null ? "has no such type" : Complaint(unity, listed, type);
                if (complaint != null)
                    findings.Fault($"{assembly.Name}.dll offers {type.Name}: Unity {unity.Version} {complaint}");
                if (listed == null)
                    continue;
                foreach (OfferedMember member in type.Members)
                {
                    members++;
                    if (Complaint(unity, listed, member) is { } problem)
                        findings.Fault($"{assembly.Name}.dll offers {member}: Unity {unity.Version} {problem}");
                }
            }
        }

        static string Complaint(ApiCatalog unity, ApiType listed, OfferedType type)
        {
            if (listed.Kind != type.Kind)
                return $"has it as {listed.Kind.ToString().ToLowerInvariant()}, not as {type.Kind.ToString().ToLowerInvariant()}";
            if (listed.WithinObsolete && !type.Obsolete)
                return "has it as obsolete: mark it [Obsolete] here as well";
            List<ApiTypeName> bases = unity.Lineage(listed)
                .SelectMany(inherited => inherited.Type.Bases.Select(parent => ApiCatalog.Substitute(parent, inherited.Arguments)))
                .ToList();
            List<ApiTypeName> extra = type.Bases.Where(parent => !bases.Any(known => ApiComparison.Same(known, parent))
                && !ImpliedInterfaces.Contains(bases, parent)).ToList();
            return extra.Count == 0 ? null : $"has it without {string.Join(", ", extra)}";
        }

        static string Complaint(ApiCatalog unity, ApiType listed, OfferedMember offered)
        {
            // Fields of an enum are its values; the one that is not says how they are stored.
            if (listed.Kind == ApiKind.Enum && offered.Member.Name == "value__")
                return ApiComparison.Same(listed.Declaration.Type, offered.Member.Returns) ? null : $"stores it as {listed.Declaration.Type}";
            ApiMember found = ApiLookup.Find(unity, listed, offered.Member);
            if (found == null)
            {
                IEnumerable<string> later = UnityCatalogs.All.Where(other => other.Find(listed.Key) is { } type
                    && ApiLookup.Find(other, type, offered.Member) != null).Select(other => other.Version);
                return later.Any() ? $"has no such member, {string.Join(" and ", later)} have" : ApiLookup.Complaint(unity, offered.Member);
            }
            if (found.Obsolete && !listed.WithinObsolete && !offered.Obsolete)
                return "has it as obsolete: mark it [Obsolete] here as well";
            if (found.IsType)
                return null;            // implied by the declaration
            if (found.Protected && !offered.Protected)
                return "has it protected";
            if (found.Constant != offered.Constant && found.Kind == ApiKind.Field)
                return found.Constant ? "has it const" : "does not have it const";
            if (found.ReadOnly && found.Kind == ApiKind.Field && !offered.ReadOnly)
                return "has it readonly";
            if (offered.Virtual && !found.Virtual && !found.Abstract && !found.Override && listed.Kind != ApiKind.Interface)
                return "does not have it virtual";
            return offered.Parameters == null ? null : Complaint(found, offered.Parameters);
        }

        static string Complaint(ApiMember found, IReadOnlyList<ApiParameter> parameters)
        {
            for (int i = 0; i < parameters.Count; i++)
            {
                ApiParameter ours = parameters[i], theirs = found.Parameters[i];
                if (found.Kind is not (ApiKind.Operator or ApiKind.Conversion) && ours.Name != theirs.Name)
                    return $"calls its parameter {ours.Name} {theirs.Name}: {found.Line.Signature}";
                if (ours.Pass != theirs.Pass)
                    return $"passes {ours.Name} otherwise ({theirs.Pass}, not {ours.Pass}): {found.Line.Signature}";
                if (ours.Params && !theirs.Params)
                    return $"has {ours.Name} without params: {found.Line.Signature}";
                if (ours.This && !theirs.This)
                    return $"has it as no extension method: {found.Line.Signature}";
                if (ours.Default != null && theirs.Default == null)
                    return $"does not have {ours.Name} optional: {found.Line.Signature}";
            }
            return null;
        }
    }
}
