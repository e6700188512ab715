using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Xml.Linq;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;

namespace Host.Manual
{
    /// <summary>The public types of compiled assemblies, with the documentation that the compiler wrote beside each.</summary>
    sealed class ApiLibrary
    {
        /// <summary>Folder of the pages, below that of the HTML.</summary>
        public const string Folder = "api/";

        readonly Dictionary<string, XElement> comments = new(StringComparer.Ordinal);
        readonly Dictionary<string, string> addresses = new(StringComparer.Ordinal);
        readonly Dictionary<string, string> names = new(StringComparer.Ordinal);

        /// <summary>By name.</summary>
        public readonly IReadOnlyList<ApiType> Types;

        /// <param name="names">Assemblies; their references lie in the folder too.</param>
        public ApiLibrary(string folder, IEnumerable<string> names)
        {
            string[] files = names.Select(name => Path.Combine(folder, name + ".dll")).ToArray();
            Dictionary<string, MetadataReference> references = Platform().Concat(Directory.GetFiles(folder, "Unity*.dll")).Concat(files).Distinct()
                .ToDictionary(file => file, file => (MetadataReference)MetadataReference.CreateFromFile(file));
            CSharpCompilation compilation = CSharpCompilation.Create("Manual", references: references.Values);
            foreach (string file in files)
                foreach (XElement member in XDocument.Load(Path.ChangeExtension(file, ".xml"), LoadOptions.PreserveWhitespace).Descendants("member"))
                    comments.TryAdd((string)member.Attribute("name"), member);
            Types = files.Select(file => (IAssemblySymbol)compilation.GetAssemblyOrModuleSymbol(references[file]))
                .SelectMany(assembly => Public(assembly.GlobalNamespace)).Select(type => new ApiType(type))
                .OrderBy(type => type.Name, StringComparer.OrdinalIgnoreCase).ThenBy(type => type.Name, StringComparer.Ordinal).ToList();
            foreach (ApiType type in Types)
                Enter(type);
        }

        static IEnumerable<string> Platform() => ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")).Split(Path.PathSeparator)
            .Where(file => Path.GetFileName(file) is string name
                && (name.StartsWith("System.", StringComparison.Ordinal) || name == "netstandard.dll")
                && Path.GetDirectoryName(file) == Path.GetDirectoryName(typeof(object).Assembly.Location));

        static IEnumerable<INamedTypeSymbol> Public(INamespaceOrTypeSymbol container) => container.GetMembers().OfType<INamespaceOrTypeSymbol>()
            .Where(member => member is INamespaceSymbol || ApiType.IsVisible(member))
            .SelectMany(member => Public(member).Concat(member is INamedTypeSymbol type ? new[] { type } : Array.Empty<INamedTypeSymbol>()));

        void Enter(ApiType type)
        {
            addresses.Add(type.Id, type.Address);
            names[type.Name] = type.Address;
            foreach (ApiMember member in type.Members)
            {
                addresses.Add(member.Id, $"{type.Address}#{member.Anchor}");
                names.TryAdd($"{type.Name}.{member.Symbol.Name}", $"{type.Address}#{member.Anchor}");
            }
        }

        /// <summary>Address of a type or member below the folder of the HTML; null for what is not of the library.</summary>
        /// <param name="id">As in the compiler's documentation, as <c>T:Rill.FluidSimulation</c>.</param>
        public string AddressOf(string id) => addresses.TryGetValue(id, out string address) ? address : null;

        /// <summary>Address for a name in code, <c>Type</c> or <c>Type.Member</c>, with a call's brackets or without.</summary>
        public string AddressOfName(string code)
        {
            int bracket = code.IndexOf('(');
            return names.TryGetValue(bracket > 0 ? code.Substring(0, bracket) : code, out string address) ? address : null;
        }

        /// <summary>Returns the documentation of a type or member, or that which it inherits by its own word; null without.</summary>
        public XElement CommentOf(ISymbol symbol)
        {
            XElement comment = Comment(symbol.GetDocumentationCommentId());
            for (int depth = 0; comment?.Element("inheritdoc") is XElement inherit && depth < 8; depth++)
            {
                XElement own = comment;
                comment = Comment((string)inherit.Attribute("cref") ?? Inherited(symbol)?.GetDocumentationCommentId());
                if (comment != null && own.Elements().Any(element => element.Name != "inheritdoc"))
                    comment = Joined(own, comment);
            }
            return comment;
        }

        XElement Comment(string id) => id != null && comments.TryGetValue(id, out XElement comment) ? comment : null;

        // The member's own text goes before that which it inherits.
        static XElement Joined(XElement own, XElement inherited)
        {
            var joined = new XElement(own.Name, own.Elements().Where(element => element.Name != "inheritdoc"));
            foreach (XElement element in inherited.Elements())
                if (!joined.Elements(element.Name).Any(there => (string)there.Attribute("name") == (string)element.Attribute("name")))
                    joined.Add(element);
            return joined;
        }

        static ISymbol Inherited(ISymbol symbol) => symbol switch
        {
            INamedTypeSymbol type => type.BaseType?.SpecialType == SpecialType.System_Object ? type.Interfaces.FirstOrDefault() : type.BaseType,
            IMethodSymbol { OverriddenMethod: { } method } => method,
            IPropertySymbol { OverriddenProperty: { } property } => property,
            IEventSymbol { OverriddenEvent: { } raised } => raised,
            _ => symbol.ContainingType?.AllInterfaces.SelectMany(contract => contract.GetMembers())
                .FirstOrDefault(member => SymbolEqualityComparer.Default.Equals(Implementation(symbol.ContainingType, member), symbol)),
        };

        static ISymbol Implementation(INamedTypeSymbol type, ISymbol member) => type.FindImplementationForInterfaceMember(member);
    }
}
