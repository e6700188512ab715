using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Reflection.Metadata;
using Host.UnityApi;

namespace Host.Check.Api
{
    /// <summary>The API of .NET Standard 2.1, off its reference assembly: what Unity's compiler sees of .NET.</summary>
    sealed class NetStandard
    {
        sealed class Type
        {
            public readonly HashSet<string> Members = new();
            public readonly List<ApiTypeName> Bases = new();
        }

        static readonly Lazy<NetStandard> loaded = new(() => new NetStandard());

        readonly Dictionary<string, Type> types = new(StringComparer.Ordinal);

        public static NetStandard Loaded => loaded.Value;

        NetStandard()
        {
            using var assembly = new CompiledAssembly(typeof(NetStandard).Assembly.GetManifestResourceStream("netstandard.dll"));
            MetadataReader metadata = assembly.Metadata;
            foreach (TypeDefinitionHandle handle in metadata.TypeDefinitions)
            {
                TypeDefinition definition = metadata.GetTypeDefinition(handle);
                ApiTypeName name = CompiledTypeNames.Of(metadata, handle);
                var type = new Type();
                types[name.Key] = type;
                if (!definition.BaseType.IsNil)
                    type.Bases.Add(CompiledTypeNames.Of(metadata, definition.BaseType));
                type.Bases.AddRange(definition.GetInterfaceImplementations()
                    .Select(i => CompiledTypeNames.Of(metadata, metadata.GetInterfaceImplementation(i).Interface)));
                foreach (MethodDefinition method in definition.GetMethods().Select(metadata.GetMethodDefinition))
                    if ((method.Attributes
                        & MethodAttributes.MemberAccessMask) is MethodAttributes.Public or MethodAttributes.Family or MethodAttributes.FamORAssem)
                        type.Members.Add(Key(assembly.Member(name, method)));
                foreach (FieldDefinition field in definition.GetFields().Select(metadata.GetFieldDefinition))
                    if ((field.Attributes
                        & FieldAttributes.FieldAccessMask) is FieldAttributes.Public or FieldAttributes.Family or FieldAttributes.FamORAssem)
                        type.Members.Add(Key(new CompiledMember(name, metadata.GetString(field.Name), true, null, 0,
                            field.DecodeSignature(CompiledTypeNames.Instance, null), Array.Empty<ApiTypeName>())));
            }
        }

        public bool Has(ApiTypeName type) => types.ContainsKey(type.Key);

        /// <summary>On the type or on one that it inherits from: newer frameworks move members between them.</summary>
        public bool Has(CompiledMember member) => types.TryGetValue(member.Owner.Key, out Type type)
            && (type.Members.Contains(Key(member)) || member.Name != ".ctor" && type.Bases.Any(parent => Has(member with { Owner = parent })));

        static string Key(CompiledMember member) =>
            $"{(member.IsField ? "field" : member.IsStatic == true ? "static" : "")} " +
            $"{member.Name}`{member.Arity}({string.Join(", ", member.Parameters)}) {member.Returns}";
    }
}
