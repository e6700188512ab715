using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Reflection.Metadata;
using Host.UnityApi;

namespace Host.Check.Api
{
    /// <summary>A type of the package that derives from a type of Unity's or implements its interfaces: what it overrides must be there to
    /// override, what is abstract must be overridden.</summary>
    sealed class Inheritance
    {
        readonly CompiledAssembly assembly;
        readonly ApiTypeName type;
        readonly bool isAbstract;
        // Methods of the type, then of its bases in the same assembly.
        readonly List<MethodDefinition> methods = new();
        readonly int own;
        readonly ApiTypeName unityBase;
        readonly List<ApiTypeName> interfaces = new();

        Inheritance(CompiledAssembly assembly, TypeDefinitionHandle handle)
        {
            this.assembly = assembly;
            type = CompiledTypeNames.Of(assembly.Metadata, handle);
            TypeDefinition definition = assembly.Metadata.GetTypeDefinition(handle);
            isAbstract = (definition.Attributes & TypeAttributes.Abstract) != 0;
            own = definition.GetMethods().Count;
            while (true)
            {
                methods.AddRange(definition.GetMethods().Select(assembly.Metadata.GetMethodDefinition));
                foreach (InterfaceImplementationHandle implementation in definition.GetInterfaceImplementations())
                {
                    EntityHandle implemented = assembly.Metadata.GetInterfaceImplementation(implementation).Interface;
                    if (IsUnity(implemented))
                        interfaces.Add(CompiledTypeNames.Of(assembly.Metadata, implemented));
                }
                EntityHandle parent = definition.BaseType;
                if (!parent.IsNil && parent.Kind == HandleKind.TypeDefinition)
                    definition = assembly.Metadata.GetTypeDefinition((TypeDefinitionHandle)parent);
                else
                {
                    unityBase = !parent.IsNil && IsUnity(parent) ? CompiledTypeNames.Of(assembly.Metadata, parent) : null;
                    return;
                }
            }
        }

        bool IsUnity(EntityHandle other) => assembly.AssemblyOf(other) is { } name && UnityMembersRule.IsUnity(name);

        public static IEnumerable<Inheritance> Of(CompiledAssembly assembly) =>
            assembly.Metadata.TypeDefinitions.Select(handle => new Inheritance(assembly, handle))
            .Where(inheritance => inheritance.unityBase != null || inheritance.interfaces.Count > 0);

        /// <param name="members">Gets what was looked up.</param>
        public void Examine(IReadOnlyList<ApiCatalog> versions, ISet<string> members, Action<string, Func<ApiCatalog, string>> report)
        {
            if (unityBase != null)
                foreach (MethodDefinition method in methods.Take(own).Where(Overrides))
                {
                    CompiledMember member = assembly.Member(unityBase, method);
                    if (IsObjects(member) || methods.Skip(own).Any(inherited => !Overrides(inherited) && SameSlot(inherited, method)))
                        continue;
                    members.Add("override " + member);
                    report($"override {member} in {type}", unity => OverrideComplaint(unity, member));
                }
            if (unityBase != null && !isAbstract)
                report(type.ToString(), unity => MissingComplaint(unity, unityBase, listed => listed.Abstract));
            foreach (ApiTypeName implemented in interfaces)
                report(type.ToString(), unity => MissingComplaint(unity, implemented, _ => true));
        }

        static bool Overrides(MethodDefinition method)
            => (method.Attributes & (MethodAttributes.Virtual | MethodAttributes.NewSlot)) == MethodAttributes.Virtual;

        static bool IsObjects(CompiledMember member) => member.Name is "ToString" or "GetHashCode" or "Finalize" && member.Parameters.Count == 0
            || member.Name == "Equals" && member.Parameters.Count == 1 && member.Parameters[0].Key == "System.Object";

        bool SameSlot(MethodDefinition a, MethodDefinition b) => (a.Attributes & MethodAttributes.Virtual) != 0
            && assembly.Member(type, a).ToString() == assembly.Member(type, b).ToString();

        static string OverrideComplaint(ApiCatalog unity, CompiledMember member)
        {
            IReadOnlyList<ApiTypeName> arguments = member.Owner.Arguments;
            if (ApiLookup.Complaint(unity, member, arguments) is { } complaint)
                return complaint;
            if (unity.Find(member.Owner.Key) is not { } listed)
                return null;            // the reference to the type is a fault already
            ApiMember found = ApiLookup.Find(unity, listed, member, arguments);
            return found.Virtual || found.Abstract || found.Override ? null : $"has it, but not as virtual: {found.Line.Signature}";
        }

        // Abstract members and those of interfaces that neither the type nor any of its bases has.
        string MissingComplaint(ApiCatalog unity, ApiTypeName parent, Func<ApiMember, bool> required)
        {
            if (unity.Find(parent.Key) is not { } listedParent)
                return null;            // the reference to the type is a fault already
            var missing = new List<string>();
            List<(ApiType Type, IReadOnlyList<ApiTypeName> Arguments)> lineage = unity.Lineage(listedParent).ToList();
            foreach ((ApiType owner, IReadOnlyList<ApiTypeName> arguments) in lineage)
                foreach (ApiMember listed in owner.Members.Where(required))
                {
                    if (owner.Kind == ApiKind.Interface != (listedParent.Kind == ApiKind.Interface))
                        continue;
                    ApiMember wanted = ApiComparison.Inherited(ApiComparison.Inherited(listed, arguments), parent.Arguments);
                    bool overridden = lineage.Any(other => other.Type != owner && other.Type.Named(listed.Name).Any(member => member.Override));
                    if (!overridden && !Implements(wanted) && !(unityBase != null && InheritedFromUnity(unity, listed)))
                        missing.Add($"{owner.Name}: {listed.Line.Signature}");
                }
            return missing.Count == 0 ? null : $"wants what it does not implement: {string.Join("; ", missing)}";
        }

        bool InheritedFromUnity(ApiCatalog unity, ApiMember wanted) =>
            unity.Find(unityBase.Key) is { } found && unity.Lineage(found).Any(inherited => inherited.Type.Kind != ApiKind.Interface
            && inherited.Type.Named(wanted.Name).Any(member => !member.Abstract && member.Parameters.Count == wanted.Parameters.Count));

        bool Implements(ApiMember wanted) => methods.Any(method =>
        {
            CompiledMember member = assembly.Member(type, method);
            // An explicit implementation is named for its interface: "UnityEngine.IThing.Do".
            string name = member.Name.Substring(member.Name.LastIndexOf('.', Math.Max(member.Name.Length - 1, 0)) + 1);
            return ApiComparison.Fits(wanted, name.Length == 0 || member.Name[0] == '.' ? member : member with { Name = name });
        });
    }
}
