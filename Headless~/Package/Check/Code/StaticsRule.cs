using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Reflection.Metadata;
using System.Reflection.Metadata.Ecma335;
using System.Reflection.PortableExecutable;

namespace Host.Check
{
    /// <summary>
    /// Without domain reload a static keeps its value from one play mode to the next: one that can change has to be set
    /// by a method with [RuntimeInitializeOnLoadMethod(SubsystemRegistration)]. What follows the assets that are
    /// loaded stays instead, and is marked by an attribute.
    /// </summary>
    sealed class StaticsRule : Rule
    {
        const string KeptBetweenPlays = "KeptBetweenPlaysAttribute";
        const int SubsystemRegistration = 4;        // of UnityEngine.RuntimeInitializeLoadType
        // Read-only statics of these hold no state; of other classes they may (a list, a buffer).
        static readonly HashSet<string> Immutable = new() { "String", "ProfilerMarker", "Type", "GpuMarker", "Feature", "Feature[]" };

        public override string Name => "code: statics are reset when play mode begins without a domain reload";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            int fields = 0;
            foreach (AssemblyDefinition definition in RuntimeAssemblies.Of(package, findings))
                using (var file = new PEReader(RuntimeAssemblies.Open(package, definition)))
                {
                    MetadataReader reader = file.GetMetadataReader();
                    HashSet<int> reset = FieldsSetAtStart(reader, file);
                    foreach (TypeDefinition type in reader.TypeDefinitions.Select(reader.GetTypeDefinition))
                        foreach (FieldDefinitionHandle handle in type.GetFields())
                        {
                            FieldDefinition field = reader.GetFieldDefinition(handle);
                            if ((field.Attributes & FieldAttributes.Static) == 0 || (field.Attributes & FieldAttributes.Literal) != 0
                                || IsCompilers(reader, type, field))
                                continue;
                            fields++;
                            bool constant = (field.Attributes & FieldAttributes.InitOnly) != 0 && HoldsNoState(reader, field);
                            bool isKept = AttributeNames.Has(reader, field.GetCustomAttributes(), KeptBetweenPlays);
                            if (!constant && !isKept && !reset.Contains(MetadataTokens.GetToken(handle)))
                                findings.Fault(
                                    $"{reader.GetString(type.Namespace)}.{reader.GetString(type.Name)}.{reader.GetString(field.Name)} " +
                                    $"of {definition.Name} is a static that can change; set it in a method with " +
                                    $"[RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]");
                        }
                }
            findings.Looked = $"{fields} static fields";
            return findings;
        }

        // Tables of array initializers and cached lambdas.
        static bool IsCompilers(MetadataReader reader, TypeDefinition type, FieldDefinition field) =>
            reader.GetString(type.Name)[0] == '<' || reader.GetString(field.Name)[0] == '<'
            && !reader.GetString(field.Name).Contains("k__BackingField");

        static bool HoldsNoState(MetadataReader reader, FieldDefinition field)
        {
            string type = field.DecodeSignature(new ShortNames(), null);
            return type.StartsWith("value ", StringComparison.Ordinal) || Immutable.Contains(type);
        }

        static HashSet<int> FieldsSetAtStart(MetadataReader reader, PEReader file)
        {
            var set = new HashSet<int>();
            foreach (MethodDefinition method in reader.MethodDefinitions.Select(reader.GetMethodDefinition)
                .Where(m => m.RelativeVirtualAddress != 0
                && m.GetCustomAttributes().Any(a => IsAtStart(reader, reader.GetCustomAttribute(a)))))
                foreach (int token in Code.FieldsStored(file.GetMethodBody(method.RelativeVirtualAddress).GetILBytes()))
                    set.Add(token);
            return set;
        }

        static bool IsAtStart(MetadataReader reader, CustomAttribute attribute)
        {
            if (AttributeNames.Of(reader, attribute) != "RuntimeInitializeOnLoadMethodAttribute")
                return false;
            BlobReader value = reader.GetBlobReader(attribute.Value);
            return value.Length >= 8 && value.ReadUInt16() == 1 && value.ReadInt32() == SubsystemRegistration;
        }

        /// <summary>"value Name" for value types, else the simple name.</summary>
        sealed class ShortNames : ISignatureTypeProvider<string, object>
        {
            static string Name(string name, byte kind) => kind == (byte)SignatureTypeKind.ValueType ? "value " + name : name;
            public string GetPrimitiveType(PrimitiveTypeCode code) => code == PrimitiveTypeCode.String ? "String"
                : code == PrimitiveTypeCode.Object ? "Object" : "value " + code;
            public string GetTypeFromDefinition(MetadataReader reader, TypeDefinitionHandle handle, byte kind)
                => Name(reader.GetString(reader.GetTypeDefinition(handle).Name), kind);
            public string GetTypeFromReference(MetadataReader reader, TypeReferenceHandle handle, byte kind)
                => Name(reader.GetString(reader.GetTypeReference(handle).Name), kind);
            public string GetTypeFromSpecification(MetadataReader reader, object context, TypeSpecificationHandle handle, byte kind)
                => reader.GetTypeSpecification(handle).DecodeSignature(this, context);
            public string GetGenericInstantiation(string type, System.Collections.Immutable.ImmutableArray<string> arguments) => type;
            public string GetSZArrayType(string element) => element + "[]";
            public string GetArrayType(string element, ArrayShape shape) => element + "[,]";
            public string GetByReferenceType(string element) => element + "&";
            public string GetPointerType(string element) => element + "*";
            public string GetPinnedType(string element) => element;
            public string GetModifiedType(string modifier, string type, bool required) => type;
            public string GetFunctionPointerType(MethodSignature<string> signature) => "method";
            public string GetGenericMethodParameter(object context, int index) => "parameter";
            public string GetGenericTypeParameter(object context, int index) => "parameter";
        }
    }
}
