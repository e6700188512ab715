using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using System.Reflection.Metadata;
using Host.UnityApi;

namespace Host.Check.Api
{
    /// <summary>Types of a compiled assembly in the form in which the lists' types are compared. Generic methods' parameters are "!!0",
    /// types' "!0".</summary>
    sealed class CompiledTypeNames : ISignatureTypeProvider<ApiTypeName, object>, ICustomAttributeTypeProvider<ApiTypeName>
    {
        public static readonly CompiledTypeNames Instance = new(null);

        readonly ApiCatalog unity;

        /// <param name="unity">Knows how large Unity's enums are: needed for attributes' arguments alone.</param>
        public CompiledTypeNames(ApiCatalog unity) => this.unity = unity;

        public static ApiTypeName Of(MetadataReader reader, EntityHandle type) => type.Kind switch
        {
            HandleKind.TypeReference => Instance.GetTypeFromReference(reader, (TypeReferenceHandle)type, 0),
            HandleKind.TypeDefinition => Instance.GetTypeFromDefinition(reader, (TypeDefinitionHandle)type, 0),
            _ => reader.GetTypeSpecification((TypeSpecificationHandle)type).DecodeSignature(Instance, null),
        };

        public ApiTypeName GetTypeFromReference(MetadataReader reader, TypeReferenceHandle handle, byte rawTypeKind)
        {
            var path = new List<string>();
            while (true)
            {
                TypeReference type = reader.GetTypeReference(handle);
                path.Insert(0, reader.GetString(type.Name));
                if (type.ResolutionScope.Kind == HandleKind.TypeReference)
                    handle = (TypeReferenceHandle)type.ResolutionScope;
                else
                    return ApiTypeName.Named(Split(reader, type.Namespace).Concat(path).ToList());
            }
        }

        public ApiTypeName GetTypeFromDefinition(MetadataReader reader, TypeDefinitionHandle handle, byte rawTypeKind)
        {
            var path = new List<string>();
            while (true)
            {
                TypeDefinition type = reader.GetTypeDefinition(handle);
                path.Insert(0, reader.GetString(type.Name));
                if (type.IsNested)
                    handle = type.GetDeclaringType();
                else
                    return ApiTypeName.Named(Split(reader, type.Namespace).Concat(path).ToList());
            }
        }

        static IEnumerable<string> Split(MetadataReader reader, StringHandle space) => space.IsNil ? Enumerable.Empty<string>()
            : reader.GetString(space).Split('.');

        public ApiTypeName GetTypeFromSpecification(MetadataReader reader, object context, TypeSpecificationHandle handle, byte rawTypeKind)
            => reader.GetTypeSpecification(handle).DecodeSignature(this, context);
        public ApiTypeName GetPrimitiveType(PrimitiveTypeCode code) => ApiTypeName.Named(new[] { "System", code.ToString() });
        public ApiTypeName GetGenericInstantiation(ApiTypeName type, ImmutableArray<ApiTypeName> arguments)
            => ApiTypeName.Named(type.Path, arguments);
        public ApiTypeName GetGenericTypeParameter(object context, int index) => ApiTypeName.Parameter("!" + index);
        public ApiTypeName GetGenericMethodParameter(object context, int index) => ApiTypeName.Parameter("!!" + index);
        public ApiTypeName GetSZArrayType(ApiTypeName element) => ApiTypeName.ArrayOf(element);
        public ApiTypeName GetArrayType(ApiTypeName element, ArrayShape shape) => ApiTypeName.ArrayOf(element, shape.Rank);
        public ApiTypeName GetByReferenceType(ApiTypeName element) => ApiTypeName.ReferenceTo(element);
        public ApiTypeName GetPointerType(ApiTypeName element) => ApiTypeName.PointerTo(element);
        // 'in' and 'volatile' are not a part of the type; parameters' own flags tell 'in'.
        public ApiTypeName GetModifiedType(ApiTypeName modifier, ApiTypeName type, bool isRequired) => type;
        public ApiTypeName GetPinnedType(ApiTypeName element) => element;
        public ApiTypeName GetFunctionPointerType(MethodSignature<ApiTypeName> signature)
            => ApiTypeName.Named(new[] { "delegate*" }, signature.ParameterTypes.Append(signature.ReturnType).ToList());

        public ApiTypeName GetSystemType() => ApiTypeName.Named(new[] { "System", "Type" });
        public bool IsSystemType(ApiTypeName type) => type.Key == "System.Type";
        public ApiTypeName GetTypeFromSerializedName(string name) => ApiTypeName.Named(name.Split(',')[0].Replace('+', '.').Split('.'));
        public PrimitiveTypeCode GetUnderlyingEnumType(ApiTypeName type) =>
            unity?.Find(type.Key)?.Declaration?.Type is { } stored && Enum.TryParse(stored.Name, out PrimitiveTypeCode code) ? code
            : PrimitiveTypeCode.Int32;
    }
}
