using System.Linq;
using System.Text;
using System.Text.RegularExpressions;
using Microsoft.CodeAnalysis;

namespace Host.Manual
{
    /// <summary>Declarations as C# has them, with links to the types of the library.</summary>
    sealed class ApiSignature
    {
        static readonly SymbolDisplayFormat Members = new(
            typeQualificationStyle: SymbolDisplayTypeQualificationStyle.NameAndContainingTypes,
            genericsOptions: SymbolDisplayGenericsOptions.IncludeTypeParameters | SymbolDisplayGenericsOptions.IncludeTypeConstraints,
            memberOptions: SymbolDisplayMemberOptions.IncludeAccessibility | SymbolDisplayMemberOptions.IncludeModifiers
                | SymbolDisplayMemberOptions.IncludeType | SymbolDisplayMemberOptions.IncludeRef | SymbolDisplayMemberOptions.IncludeParameters
                | SymbolDisplayMemberOptions.IncludeConstantValue,
            parameterOptions: SymbolDisplayParameterOptions.IncludeType | SymbolDisplayParameterOptions.IncludeName
                | SymbolDisplayParameterOptions.IncludeParamsRefOut | SymbolDisplayParameterOptions.IncludeDefaultValue
                | SymbolDisplayParameterOptions.IncludeExtensionThis,
            propertyStyle: SymbolDisplayPropertyStyle.ShowReadWriteDescriptor,
            kindOptions: SymbolDisplayKindOptions.IncludeMemberKeyword,
            miscellaneousOptions: SymbolDisplayMiscellaneousOptions.UseSpecialTypes | SymbolDisplayMiscellaneousOptions.EscapeKeywordIdentifiers
                | SymbolDisplayMiscellaneousOptions.AllowDefaultLiteral);

        static readonly SymbolDisplayFormat Names = new(
            typeQualificationStyle: SymbolDisplayTypeQualificationStyle.NameAndContainingTypes,
            genericsOptions: SymbolDisplayGenericsOptions.IncludeTypeParameters,
            miscellaneousOptions: SymbolDisplayMiscellaneousOptions.UseSpecialTypes);

        // Accessors that only the package reaches.
        static readonly Regex HiddenAccessor = new("<span class=\"k\">(?:internal|private|private protected)</span> " +
            "<span class=\"k\">(?:get|set|init)</span>; ");

        readonly ApiLibrary library;

        public ApiSignature(ApiLibrary library) => this.library = library;

        public string Of(ISymbol member) => HiddenAccessor.Replace(Parts(member, Members), "");

        public string Of(INamedTypeSymbol type)
        {
            var text = new StringBuilder("public ");
            if (type.TypeKind == TypeKind.Delegate)
                return CodeColors.Span("k", "public delegate") + " " + Parts(type.DelegateInvokeMethod.ReturnType, Names) + " " + type.Name + "("
                    + string.Join(", ", type.DelegateInvokeMethod.Parameters.Select(parameter => Parts(parameter, Members))) + ")";
            if (type.IsStatic)
                text.Append("static ");
            else if (type.TypeKind == TypeKind.Class)
                text.Append(type.IsAbstract ? "abstract " : type.IsSealed ? "sealed " : "");
            else if (type.TypeKind == TypeKind.Struct)
                text.Append(type.IsReadOnly ? "readonly " : "");
            string bases = string.Join(", ", new[] { type.BaseType }.Where(IsNamed).Concat(type.Interfaces.Where(ApiType.IsVisible))
                .Select(other => Parts(other, Names)));
            return CodeColors.Span("k", text + (type.TypeKind.ToString().ToLowerInvariant())) + " " + Html.Escape(type.ToDisplayString(Names))
                + (bases.Length > 0 ? " : " + bases : "");
        }

        static bool IsNamed(INamedTypeSymbol type) => type != null && ApiType.IsVisible(type)
            && type.SpecialType is not (SpecialType.System_Object or SpecialType.System_ValueType or SpecialType.System_Enum);

        string Parts(ISymbol symbol, SymbolDisplayFormat format)
        {
            var html = new StringBuilder();
            foreach (SymbolDisplayPart part in symbol.ToDisplayParts(format))
            {
                string text = Html.Escape(part.ToString() == "Infinity" ? "float.PositiveInfinity" : part.ToString());
                html.Append(part.Kind == SymbolDisplayPartKind.Keyword ? CodeColors.Span("k", text)
                    : part.Symbol is INamedTypeSymbol type && library.AddressOf(type.OriginalDefinition.GetDocumentationCommentId()) is string address
                    ? $"<a href=\"../{address}\">{text}</a>" : text);
            }
            return html.ToString();
        }
    }
}
