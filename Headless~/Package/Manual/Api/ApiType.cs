using System;
using System.Collections.Generic;
using System.Linq;
using Microsoft.CodeAnalysis;

namespace Host.Manual
{
    /// <summary>A public type and what of it others can use.</summary>
    sealed class ApiType
    {
        public readonly INamedTypeSymbol Symbol;

        /// <summary>With the names of the types around it.</summary>
        public readonly string Name;

        /// <summary>Enum members by value, fields of structs as declared, all else by name: parts of a type are compiled in no fixed
        /// order.</summary>
        public readonly IReadOnlyList<ApiMember> Members;

        public ApiType(INamedTypeSymbol symbol)
        {
            Symbol = symbol;
            Name = symbol.ContainingType == null ? symbol.Name : $"{symbol.ContainingType.Name}.{symbol.Name}";
            var members = new List<ApiMember>();
            var taken = new HashSet<string>(StringComparer.OrdinalIgnoreCase);
            foreach (ISymbol member in Ordered(symbol.GetMembers().Where(IsShown)))
            {
                string name = member.Kind == SymbolKind.Method && member.Name == ".ctor" ? "constructor" : member.Name, anchor = name;
                for (int i = 2; !taken.Add(anchor); i++)
                    anchor = $"{name}-{i}";
                members.Add(new ApiMember(member, anchor));
            }
            Members = members;
        }

        public string Id => Symbol.GetDocumentationCommentId();
        public string Address => $"{ApiLibrary.Folder}{Name}{(Symbol.Arity > 0 ? $"-{Symbol.Arity}" : "")}.html";

        /// <summary>Returns the kind that follows a type's name in a title.</summary>
        public string Kind => Symbol.TypeKind switch
        {
            TypeKind.Struct => "struct",
            TypeKind.Enum => "enum",
            TypeKind.Interface => "interface",
            TypeKind.Delegate => "delegate",
            _ => "class",
        };

        /// <summary>Whether code outside of the assembly reaches it.</summary>
        public static bool IsVisible(ISymbol symbol) => symbol.DeclaredAccessibility is Accessibility.Public or Accessibility.Protected
            or Accessibility.ProtectedOrInternal;

        static bool IsShown(ISymbol member) => IsVisible(member) && !member.IsImplicitlyDeclared && member switch
        {
            IMethodSymbol { MethodKind: MethodKind.Constructor } constructor => IsWritten(constructor),
            IMethodSymbol method => method.ContainingType.TypeKind != TypeKind.Delegate && method.MethodKind is MethodKind.Ordinary
                or MethodKind.UserDefinedOperator or MethodKind.Conversion,
            IFieldSymbol field => field.ContainingType.TypeKind != TypeKind.Enum || field.HasConstantValue,
            _ => member.Kind is SymbolKind.Property or SymbolKind.Event,
        };

        // One without parameters is made by the compiler, but for those that create what Unity does not.
        static bool IsWritten(IMethodSymbol constructor) => constructor.Parameters.Length > 0
            && constructor.ContainingType.TypeKind != TypeKind.Delegate;

        IEnumerable<ISymbol> Ordered(IEnumerable<ISymbol> members)
        {
            if (Symbol.TypeKind == TypeKind.Enum)
                return members.OrderBy(member => Convert.ToInt64(((IFieldSymbol)member).ConstantValue));
            return members.OrderBy(member => ApiMember.GroupOf(member))
                .ThenBy(member => Symbol.TypeKind == TypeKind.Struct && member is IFieldSymbol ? "" : member.Name, StringComparer.Ordinal)
                .ThenBy(member => member is IFieldSymbol ? "" : member.GetDocumentationCommentId(), StringComparer.Ordinal);
        }
    }

    /// <summary>Groups of members, in the order of a page.</summary>
    enum ApiGroup { Constructors, Fields, Properties, Methods, Operators, Events }

    /// <summary>A member of a type.</summary>
    /// <param name="Anchor">Its place on the type's page.</param>
    sealed record ApiMember(ISymbol Symbol, string Anchor)
    {
        public string Id => Symbol.GetDocumentationCommentId();
        public ApiGroup Group => GroupOf(Symbol);

        /// <summary>Returns the name as a heading has it.</summary>
        public string Title => Symbol switch
        {
            IMethodSymbol { MethodKind: MethodKind.Constructor } => Symbol.ContainingType.Name,
            IMethodSymbol { MethodKind: MethodKind.UserDefinedOperator or MethodKind.Conversion } => Symbol.Name.Replace("op_", ""),
            IPropertySymbol { IsIndexer: true } => "this[]",
            _ => Symbol.Name,
        };

        public static ApiGroup GroupOf(ISymbol symbol) => symbol switch
        {
            IFieldSymbol => ApiGroup.Fields,
            IPropertySymbol => ApiGroup.Properties,
            IEventSymbol => ApiGroup.Events,
            IMethodSymbol { MethodKind: MethodKind.Constructor } => ApiGroup.Constructors,
            IMethodSymbol { MethodKind: MethodKind.UserDefinedOperator or MethodKind.Conversion } => ApiGroup.Operators,
            _ => ApiGroup.Methods,
        };
    }
}
