using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Reflection.Metadata;
using Host.UnityApi;

namespace Host.Check.Api
{
    /// <summary>
    /// No member of a class that derives from one of Unity's, private ones and nested types included, has the name of a member that it
    /// inherits: Unity's compiler warns of that in the user's console (CS0108). The host's stand-ins lack most of those that are obsolete.
    /// </summary>
    sealed class HiddenMembersRule : Rule
    {
        readonly IReadOnlyList<string> names;

        public HiddenMembersRule(IReadOnlyList<string> assemblies = null) => names = assemblies ?? PackageAssemblies.Package;

        public override string Name => "API: no member hides one that Unity's classes have";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            int classes = 0, members = 0;
            using var types = new PackageTypes(package, names, findings);
            foreach (PackageType type in types.All)
            {
                List<(ApiCatalog Unity, List<ApiType> Classes)> inherited = Inherited(types.ForeignBase(type));
                if (inherited.Count == 0)
                    continue;
                classes++;
                foreach (Declared member in Declared.Of(type))
                {
                    members++;
                    foreach (IGrouping<string, string> same in inherited
                        .Select(version => (version.Unity.Version, hidden: Hidden(version.Unity, version.Classes, member)))
                        .Where(found => found.hidden != null).GroupBy(found => found.hidden, found => found.Version))
                        findings.Fault($"{type.Assembly.Name}.dll: {type}.{member.Name} hides {same.Key} of Unity {string.Join(", ", same)}, " +
                            $"which users see as a warning of the compiler: rename it");
                }
            }
            findings.Looked = $"{members} members of {classes} classes against {string.Join(", ", UnityCatalogs.All.Select(unity => unity.Version))}";
            return findings;
        }

        static List<(ApiCatalog, List<ApiType>)> Inherited(ApiTypeName parent) => parent == null ? new()
            : UnityCatalogs.All.Where(unity => unity.Find(parent.Key) != null)
                .Select(unity => (unity, unity.Lineage(unity.Find(parent.Key)).Select(inherited => inherited.Type)
                    .Where(type => type.Kind == ApiKind.Class).ToList())).ToList();

        // A method hides those of the same parameters, and whatever else has its name; all else hides by name alone.
        static string Hidden(ApiCatalog unity, List<ApiType> classes, Declared member)
        {
            foreach (ApiType type in classes)
            {
                if (unity.Find($"{type.Key}.{member.Name}") is { } nested)
                    return nested.Name;
                ApiMember hidden = type.Named(member.Name).FirstOrDefault(listed => listed.Kind != ApiKind.Method || member.Method == null
                    || ApiComparison.SameParameters(listed, member.Method));
                if (hidden != null)
                    return $"{type.Name}.{hidden.Name} ({hidden.Line.Signature}{(hidden.Obsolete ? ", obsolete" : "")})";
            }
            return null;
        }

        /// <summary>A member that a source declares, and that overrides nothing.</summary>
        /// <param name="Method">Null: it is not a method.</param>
        sealed record Declared(string Name, CompiledMember Method)
        {
            public static IEnumerable<Declared> Of(PackageType type)
            {
                MetadataReader metadata = type.Assembly.Metadata;
                IEnumerable<Declared> fields = type.Definition.GetFields().Select(metadata.GetFieldDefinition).Select(field => Named(type,
                    field.Name));
                IEnumerable<Declared> nested = type.Definition.GetNestedTypes().Select(metadata.GetTypeDefinition).Select(inner => Named(type,
                    inner.Name));
                IEnumerable<Declared> properties = type.Definition.GetProperties().Select(metadata.GetPropertyDefinition)
                    .Where(property => !Overrides(metadata, property.GetAccessors().Getter) && !Overrides(metadata, property.GetAccessors().Setter))
                    .Select(property => Named(type, property.Name));
                IEnumerable<Declared> events = type.Definition.GetEvents().Select(metadata.GetEventDefinition)
                    .Where(@event => !Overrides(metadata, @event.GetAccessors().Adder)).Select(@event => Named(type, @event.Name));
                IEnumerable<Declared> methods = type.Definition.GetMethods()
                    .Where(handle => (metadata.GetMethodDefinition(handle).Attributes & MethodAttributes.SpecialName) == 0
                        && !Overrides(metadata, handle))
                    .Select(handle => type.Assembly.Member(type.Name, metadata.GetMethodDefinition(handle)))
                    .Select(method => new Declared(method.Name, method));
                // Members that the compiler makes have a name in angles, explicit interface implementations one with a dot.
                return fields.Concat(nested).Concat(properties).Concat(events).Concat(methods)
                    .Where(member => member.Name[0] != '<' && !member.Name.Contains('.', StringComparison.Ordinal));
            }

            static Declared Named(PackageType type, StringHandle name) => new(type.Text(name), null);

            static bool Overrides(MetadataReader metadata, MethodDefinitionHandle handle) => !handle.IsNil
                && (metadata.GetMethodDefinition(handle).Attributes & (MethodAttributes.Virtual | MethodAttributes.NewSlot)) == MethodAttributes.Virtual;
        }
    }
}
