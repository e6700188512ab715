using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Reflection.Metadata;
using Host.UnityApi;

namespace Host.Check.Api
{
    /// <summary>A public or protected type that an assembly defines, with its members.</summary>
    sealed class OfferedType
    {
        const FieldAttributes FieldAccess = FieldAttributes.FieldAccessMask;
        const MethodAttributes MethodAccess = MethodAttributes.MemberAccessMask;

        readonly CompiledAssembly assembly;
        readonly MetadataReader metadata;
        readonly TypeDefinition definition;

        public readonly ApiTypeName Name;
        public readonly ApiKind Kind;
        public readonly bool Obsolete;
        /// <summary>The base class, unless every type of the kind has it; then interfaces, inherited ones included.</summary>
        public readonly List<ApiTypeName> Bases = new();

        OfferedType(CompiledAssembly assembly, TypeDefinitionHandle handle)
        {
            this.assembly = assembly;
            metadata = assembly.Metadata;
            definition = metadata.GetTypeDefinition(handle);
            Name = CompiledTypeNames.Of(metadata, handle);
            string parent = definition.BaseType.IsNil ? "" : CompiledTypeNames.Of(metadata, definition.BaseType).Key;
            Kind = (definition.Attributes & TypeAttributes.Interface) != 0 ? ApiKind.Interface : parent switch
            {
                "System.Enum" => ApiKind.Enum,
                "System.ValueType" => ApiKind.Struct,
                "System.MulticastDelegate" => ApiKind.Delegate,
                _ => ApiKind.Class,
            };
            Obsolete = Has(definition.GetCustomAttributes(), "System.ObsoleteAttribute");
            if (Kind == ApiKind.Class && parent != "System.Object")
                Bases.Add(CompiledTypeNames.Of(metadata, definition.BaseType));
            foreach (InterfaceImplementationHandle implementation in definition.GetInterfaceImplementations())
            {
                ApiTypeName implemented = CompiledTypeNames.Of(metadata, metadata.GetInterfaceImplementation(implementation).Interface);
                if (IsVisible(implemented))
                    Bases.Add(implemented);
            }
        }

        public static IEnumerable<OfferedType> Of(CompiledAssembly assembly) =>
            assembly.Metadata.TypeDefinitions.Where(handle => IsVisible(assembly.Metadata, handle))
            .Select(handle => new OfferedType(assembly, handle));

        public IEnumerable<OfferedMember> Members => Kind == ApiKind.Delegate ? Methods().Where(method => method.Member.Name == "Invoke")
            : Fields().Concat(Methods()).Concat(Properties()).Concat(Events());

        IEnumerable<OfferedMember> Fields()
        {
            foreach (FieldDefinition field in definition.GetFields().Select(metadata.GetFieldDefinition))
            {
                FieldAttributes access = field.Attributes & FieldAccess;
                if (access is FieldAttributes.Public or FieldAttributes.Family or FieldAttributes.FamORAssem)
                    yield return new OfferedMember
                    {
                        Member = new CompiledMember(Name, metadata.GetString(field.Name), true,
                            (field.Attributes & FieldAttributes.Static) != 0, 0, field.DecodeSignature(CompiledTypeNames.Instance, null),
                            new ApiTypeName[0]),
                        Protected = access != FieldAttributes.Public,
                        Constant = (field.Attributes & FieldAttributes.Literal) != 0,
                        ReadOnly = (field.Attributes & FieldAttributes.InitOnly) != 0,
                        Obsolete = Has(field.GetCustomAttributes(), "System.ObsoleteAttribute"),
                    };
            }
        }

        IEnumerable<OfferedMember> Methods()
        {
            HashSet<MethodDefinitionHandle> accessors = definition.GetProperties()
                .Select(p => metadata.GetPropertyDefinition(p).GetAccessors()).SelectMany(a => new[] { a.Getter, a.Setter })
                .Concat(definition.GetEvents().Select(e => metadata.GetEventDefinition(e).GetAccessors())
                    .SelectMany(a => new[] { a.Adder, a.Remover })).ToHashSet();
            foreach (MethodDefinitionHandle handle in definition.GetMethods().Where(handle => !accessors.Contains(handle)))
                if (Method(handle, Enumerable.Empty<CustomAttributeHandle>()) is { } method)
                {
                    method.Parameters = ParametersOf(metadata.GetMethodDefinition(handle), method.Member);
                    yield return method;
                }
        }

        // Accessors one by one: a setter can be private.
        IEnumerable<OfferedMember> Properties()
        {
            foreach (PropertyDefinition property in definition.GetProperties().Select(metadata.GetPropertyDefinition))
                foreach (MethodDefinitionHandle accessor in new[] { property.GetAccessors().Getter, property.GetAccessors().Setter })
                    if (!accessor.IsNil && Method(accessor, property.GetCustomAttributes()) is { } method)
                        yield return method;
        }

        IEnumerable<OfferedMember> Events()
        {
            foreach (EventDefinition @event in definition.GetEvents().Select(metadata.GetEventDefinition))
                if (Method(@event.GetAccessors().Adder, @event.GetCustomAttributes()) is { } method)
                    yield return method;
        }

        /// <summary>Null: no one outside sees it.</summary>
        OfferedMember Method(MethodDefinitionHandle handle, IEnumerable<CustomAttributeHandle> attributes)
        {
            MethodDefinition method = metadata.GetMethodDefinition(handle);
            MethodAttributes access = method.Attributes & MethodAccess;
            if (access is not (MethodAttributes.Public or MethodAttributes.Family or MethodAttributes.FamORAssem)
                || metadata.GetString(method.Name) == ".cctor" || OverridesForeign(method))
                return null;
            return new OfferedMember
            {
                Member = assembly.Member(Name, method),
                Protected = access != MethodAttributes.Public,
                Virtual = (method.Attributes & (MethodAttributes.Virtual | MethodAttributes.NewSlot | MethodAttributes.Final))
                    == (MethodAttributes.Virtual | MethodAttributes.NewSlot),
                Obsolete = Has(method.GetCustomAttributes(), "System.ObsoleteAttribute") || Has(attributes, "System.ObsoleteAttribute"),
            };
        }

        // An override of what a class of .NET's or NUnit's declares offers nothing that this class did not.
        bool OverridesForeign(MethodDefinition method)
        {
            if ((method.Attributes & (MethodAttributes.Virtual | MethodAttributes.NewSlot)) != MethodAttributes.Virtual)
                return false;
            string slot = assembly.Member(Name, method).ToString();
            EntityHandle parent = definition.BaseType;
            while (parent.Kind == HandleKind.TypeDefinition)
            {
                TypeDefinition type = metadata.GetTypeDefinition((TypeDefinitionHandle)parent);
                if (type.GetMethods().Select(metadata.GetMethodDefinition)
                    .Any(inherited => (inherited.Attributes & MethodAttributes.NewSlot) != 0
                    && assembly.Member(Name, inherited).ToString() == slot))
                    return false;
                parent = type.BaseType;
            }
            return !UnityMembersRule.IsUnity(assembly.AssemblyOf(parent));
        }

        IReadOnlyList<ApiParameter> ParametersOf(MethodDefinition method, CompiledMember member)
        {
            var parameters = member.Parameters.Select(type => new ApiParameter("", type, type.Form == ApiTypeForm.Reference ? ApiPass.Ref
                : ApiPass.ByValue, false, false, null)).ToList();
            foreach (Parameter parameter in method.GetParameters().Select(metadata.GetParameter).Where(parameter => parameter.SequenceNumber > 0))
            {
                int i = parameter.SequenceNumber - 1;
                ApiPass pass = parameters[i].Pass;
                if (pass == ApiPass.Ref && (parameter.Attributes & ParameterAttributes.Out) != 0)
                    pass = ApiPass.Out;
                else if (pass == ApiPass.Ref && (parameter.Attributes & ParameterAttributes.In) != 0)
                    pass = ApiPass.In;
                parameters[i] = parameters[i] with
                {
                    Name = metadata.GetString(parameter.Name),
                    Pass = pass,
                    Params = Has(parameter.GetCustomAttributes(), "System.ParamArrayAttribute"),
                    Default = (parameter.Attributes & ParameterAttributes.Optional) != 0 ? "=" : null,
                };
            }
            if (parameters.Count > 0 && Has(method.GetCustomAttributes(), "System.Runtime.CompilerServices.ExtensionAttribute"))
                parameters[0] = parameters[0] with { This = true };
            return parameters;
        }

        bool Has(IEnumerable<CustomAttributeHandle> attributes, string name)
            => attributes.Select(metadata.GetCustomAttribute).Any(attribute => attribute.Constructor.Kind switch
        {
            HandleKind.MemberReference => CompiledTypeNames.Of(metadata,
                metadata.GetMemberReference((MemberReferenceHandle)attribute.Constructor).Parent).Key == name,
            _ => CompiledTypeNames.Of(metadata, metadata.GetMethodDefinition((MethodDefinitionHandle)attribute.Constructor)
                .GetDeclaringType()).Key == name,
        });

        // Interfaces of the assembly's own that no one outside sees offer nothing.
        bool IsVisible(ApiTypeName type)
        {
            foreach (TypeDefinitionHandle handle in metadata.TypeDefinitions)
                if (CompiledTypeNames.Of(metadata, handle).Key == type.Key)
                    return IsVisible(metadata, handle);
            return true;
        }

        static bool IsVisible(MetadataReader metadata, TypeDefinitionHandle handle)
        {
            TypeDefinition type = metadata.GetTypeDefinition(handle);
            TypeAttributes access = type.Attributes & TypeAttributes.VisibilityMask;
            return access == TypeAttributes.Public
                || access is TypeAttributes.NestedPublic or TypeAttributes.NestedFamily or TypeAttributes.NestedFamORAssem
                && IsVisible(metadata, type.GetDeclaringType());
        }
    }
}
