using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection.Emit;
using System.Reflection.Metadata;
using System.Reflection.Metadata.Ecma335;
using System.Reflection.PortableExecutable;
using Host.UnityApi;
using UnityEngine.Headless;

namespace Host.Check.Api
{
    /// <summary>A method that code calls, or takes as a delegate.</summary>
    /// <param name="Arguments">Of a generic method.</param>
    /// <param name="Constrained">The type whose method is called where the code names that of a base: of int for object.ToString. Null: that.</param>
    /// <param name="IsPointer">The code makes a delegate of it.</param>
    /// <param name="Constant">A small number that the code pushes just before: the last argument. Null: something else.</param>
    sealed record CompiledCall(EntityHandle Handle, CompiledMember Method, IReadOnlyList<ApiTypeName> Arguments, ApiTypeName Constrained,
        int? Constant, bool IsPointer = false);

    /// <summary>A compiled assembly and what it takes from others.</summary>
    sealed class CompiledAssembly : IDisposable
    {
        readonly PEReader file;

        public readonly MetadataReader Metadata;
        public readonly string Name;

        public CompiledAssembly(string path) : this(File.OpenRead(path)) { }

        public CompiledAssembly(Stream image)
        {
            file = new PEReader(image);
            Metadata = file.GetMetadataReader();
            Name = Metadata.GetString(Metadata.GetAssemblyDefinition().Name);
        }

        public void Dispose() => file.Dispose();

        public IEnumerable<string> References
            => Metadata.AssemblyReferences.Select(handle => Metadata.GetString(Metadata.GetAssemblyReference(handle).Name));

        /// <summary>Every type of another assembly that this one names, with that assembly.</summary>
        public IEnumerable<(string Assembly, ApiTypeName Type)> TypesUsed =>
            Metadata.TypeReferences.Select(handle => (AssemblyOf(handle), CompiledTypeNames.Of(Metadata, handle))).Where(use => use.Item1 != null);

        /// <summary>Every member of another assembly's type that this one names, and where it does.</summary>
        public IEnumerable<(string Assembly, CompiledMember Member, MemberReferenceHandle Reference)> MembersUsed
        {
            get
            {
                foreach (MemberReferenceHandle handle in Metadata.MemberReferences)
                {
                    MemberReference reference = Metadata.GetMemberReference(handle);
                    if (reference.Parent.Kind is not (HandleKind.TypeReference or HandleKind.TypeSpecification))
                        continue;
                    ApiTypeName owner = CompiledTypeNames.Of(Metadata, reference.Parent);
                    // Arrays have methods of their own, which the runtime makes.
                    if (owner.Form == ApiTypeForm.Named && AssemblyOf(reference.Parent) is { } assembly)
                        yield return (assembly, Member(owner, reference), handle);
                }
            }
        }

        /// <summary>The first method whose code names a member: "FluidSimulation.Update". Null: none does, it is named by an attribute.</summary>
        public string FirstUser(MemberReferenceHandle member)
        {
            List<byte[]> tokens = Enumerable.Range(1, Metadata.GetTableRowCount(TableIndex.MethodSpec))
                .Select(MetadataTokens.MethodSpecificationHandle)
                .Where(handle => Metadata.GetMethodSpecification(handle).Method == member).Select(handle => (EntityHandle)handle).Append(member)
                .Select(handle => BitConverter.GetBytes(MetadataTokens.GetToken(handle))).ToList();
            foreach (MethodDefinition method in Metadata.MethodDefinitions.Select(Metadata.GetMethodDefinition)
                .Where(method => method.RelativeVirtualAddress != 0))
            {
                byte[] code = file.GetMethodBody(method.RelativeVirtualAddress).GetILBytes();
                if (tokens.Any(token => code.AsSpan().IndexOf(token) >= 0))
                    return $"{CompiledTypeNames.Of(Metadata, method.GetDeclaringType())}.{Metadata.GetString(method.Name)}";
            }
            return null;
        }

        /// <summary>Instructions of a method; none for a method without code.</summary>
        public IEnumerable<(OpCode Op, int Operand)> Instructions(MethodDefinition method) => method.RelativeVirtualAddress == 0
            ? Enumerable.Empty<(OpCode, int)>() : Il.Instructions(file.GetMethodBody(method.RelativeVirtualAddress).GetILBytes());

        /// <summary>The methods that a method's code names, those of arrays left out.</summary>
        public IEnumerable<CompiledCall> Calls(MethodDefinition method)
        {
            ApiTypeName constrained = null;
            int? constant = null;
            foreach ((OpCode op, int operand) in Instructions(method))
            {
                if (op.OperandType == OperandType.InlineMethod
                    && Call((EntityHandle)MetadataTokens.Handle(operand), constrained, constant) is { } call)
                    yield return op == OpCodes.Ldftn || op == OpCodes.Ldvirtftn ? call with { IsPointer = true } : call;
                constant = op.Value >= OpCodes.Ldc_I4_0.Value && op.Value <= OpCodes.Ldc_I4_8.Value ? op.Value - OpCodes.Ldc_I4_0.Value : null;
                constrained = op == OpCodes.Constrained ? CompiledTypeNames.Of(Metadata, (EntityHandle)MetadataTokens.Handle(operand)) : null;
            }
        }

        CompiledCall Call(EntityHandle called, ApiTypeName constrained, int? constant)
        {
            IReadOnlyList<ApiTypeName> arguments = Array.Empty<ApiTypeName>();
            if (called.Kind == HandleKind.MethodSpecification)
            {
                MethodSpecification generic = Metadata.GetMethodSpecification((MethodSpecificationHandle)called);
                arguments = generic.DecodeSignature(CompiledTypeNames.Instance, null);
                called = generic.Method;
            }
            if (called.Kind == HandleKind.MethodDefinition)
            {
                MethodDefinition own = Metadata.GetMethodDefinition((MethodDefinitionHandle)called);
                return new CompiledCall(called, Member(CompiledTypeNames.Of(Metadata, own.GetDeclaringType()), own), arguments,
                    constrained, constant);
            }
            MemberReference reference = Metadata.GetMemberReference((MemberReferenceHandle)called);
            ApiTypeName owner = CompiledTypeNames.Of(Metadata, reference.Parent);
            return owner.Form == ApiTypeForm.Named ? new CompiledCall(called, Member(owner, reference), arguments, constrained, constant) : null;
        }

        /// <summary>Properties and fields that attributes of other assemblies are given by name: they stand in no table of references.</summary>
        /// <param name="wanted">Which assemblies' attributes to read.</param>
        /// <param name="unity">Knows how large enums are.</param>
        public IEnumerable<CompiledMember> AttributeArguments(Func<string, bool> wanted, ApiCatalog unity)
        {
            var names = new CompiledTypeNames(unity);
            foreach (CustomAttributeHandle handle in Metadata.CustomAttributes)
            {
                CustomAttribute attribute = Metadata.GetCustomAttribute(handle);
                if (attribute.Constructor.Kind != HandleKind.MemberReference)
                    continue;
                EntityHandle type = Metadata.GetMemberReference((MemberReferenceHandle)attribute.Constructor).Parent;
                if (AssemblyOf(type) is not { } assembly || !wanted(assembly))
                    continue;
                ApiTypeName owner = CompiledTypeNames.Of(Metadata, type);
                foreach (CustomAttributeNamedArgument<ApiTypeName> argument in attribute.DecodeValue(names).NamedArguments)
                    yield return argument.Kind == CustomAttributeNamedArgumentKind.Field
                        ? new CompiledMember(owner, argument.Name, true, false, 0, argument.Type, Array.Empty<ApiTypeName>())
                        : new CompiledMember(owner, "set_" + argument.Name, false, false, 0, ApiTypeName.Named(new[] { "System", "Void" }),
                            new[] { argument.Type });
            }
        }

        public IEnumerable<TypeDefinition> Types => Metadata.TypeDefinitions.Select(Metadata.GetTypeDefinition);

        public CompiledMember Member(ApiTypeName owner, MethodDefinition method)
        {
            MethodSignature<ApiTypeName> signature = method.DecodeSignature(CompiledTypeNames.Instance, null);
            return Method(owner, Metadata.GetString(method.Name), signature);
        }

        CompiledMember Member(ApiTypeName owner, MemberReference reference)
        {
            string name = Metadata.GetString(reference.Name);
            return reference.GetKind() == MemberReferenceKind.Field
                ? new CompiledMember(owner, name, true, null, 0, reference.DecodeFieldSignature(CompiledTypeNames.Instance, null),
                Array.Empty<ApiTypeName>())
                : Method(owner, name, reference.DecodeMethodSignature(CompiledTypeNames.Instance, null));
        }

        static CompiledMember Method(ApiTypeName owner, string name, MethodSignature<ApiTypeName> signature) =>
            new(owner, name, false, !signature.Header.IsInstance, signature.GenericParameterCount, signature.ReturnType, signature.ParameterTypes);

        /// <summary>The other assembly that a type is in; null for a type of this one, of an array or a type parameter.</summary>
        public string AssemblyOf(EntityHandle type)
        {
            while (true)
                switch (type.Kind)
                {
                    case HandleKind.TypeReference:
                        type = Metadata.GetTypeReference((TypeReferenceHandle)type).ResolutionScope;
                        break;
                    case HandleKind.TypeSpecification:
                        BlobReader blob = Metadata.GetBlobReader(Metadata.GetTypeSpecification((TypeSpecificationHandle)type).Signature);
                        if (blob.ReadSignatureTypeCode() != SignatureTypeCode.GenericTypeInstance)
                            return null;
                        blob.ReadByte();
                        type = blob.ReadTypeHandle();
                        break;
                    case HandleKind.AssemblyReference:
                        return Metadata.GetString(Metadata.GetAssemblyReference((AssemblyReferenceHandle)type).Name);
                    default:
                        return null;
                }
        }
    }
}
