using System.Linq;
using System.Reflection.Metadata;

namespace Host.Check
{
    /// <summary>Attributes of compiled code by the simple names of their classes.</summary>
    static class AttributeNames
    {
        public static bool Has(MetadataReader reader, CustomAttributeHandleCollection attributes, params string[] names)
            => attributes.Any(handle => names.Contains(Of(reader, reader.GetCustomAttribute(handle))));

        /// <summary>That of an attribute from this assembly or another.</summary>
        public static string Of(MetadataReader reader, CustomAttribute attribute)
        {
            EntityHandle type = attribute.Constructor.Kind == HandleKind.MemberReference
                ? reader.GetMemberReference((MemberReferenceHandle)attribute.Constructor).Parent
                : reader.GetMethodDefinition((MethodDefinitionHandle)attribute.Constructor).GetDeclaringType();
            return type.Kind switch
            {
                HandleKind.TypeReference => reader.GetString(reader.GetTypeReference((TypeReferenceHandle)type).Name),
                HandleKind.TypeDefinition => reader.GetString(reader.GetTypeDefinition((TypeDefinitionHandle)type).Name),
                _ => "",
            };
        }
    }
}
