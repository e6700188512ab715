using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection.Metadata;
using Host.Pipelines;
using Host.UnityApi;

namespace Host.Check.Api
{
    /// <summary>A type that one of the package's assemblies defines.</summary>
    sealed record PackageType(CompiledAssembly Assembly, TypeDefinitionHandle Handle)
    {
        IReadOnlyList<PackageMethod> methods;

        public TypeDefinition Definition => Assembly.Metadata.GetTypeDefinition(Handle);
        public ApiTypeName Name { get; } = CompiledTypeNames.Of(Assembly.Metadata, Handle);
        public IReadOnlyList<PackageMethod> Methods => methods ??= Definition.GetMethods().Select(handle => new PackageMethod(this, handle)).ToList();
        public string Text(StringHandle name) => Assembly.Metadata.GetString(name);
        public override string ToString() => Name.ToString();
    }

    /// <summary>A method of such a type.</summary>
    sealed class PackageMethod
    {
        public readonly PackageType Type;
        public readonly MethodDefinition Definition;
        public readonly CompiledMember Member;

        public PackageMethod(PackageType type, MethodDefinitionHandle handle)
        {
            Type = type;
            Definition = type.Assembly.Metadata.GetMethodDefinition(handle);
            Member = type.Assembly.Member(type.Name, Definition);
        }

        public string Name => Member.Name;
        /// <summary>Short name; of an explicit implementation, the interface's name for it.</summary>
        public string ShortName => Name[0] == '.' ? Name : Name.Substring(Name.LastIndexOf('.') + 1);
        public bool IsVirtual => (Definition.Attributes & System.Reflection.MethodAttributes.Virtual) != 0;

        public override string ToString() => $"{Type}.{Name}";
    }

    /// <summary>The types of all of the package's assemblies together, those of its adapters for render pipelines included.</summary>
    sealed class PackageTypes : IDisposable
    {
        readonly Dictionary<string, PackageType> byKey = new(StringComparer.Ordinal);

        public readonly IReadOnlyList<CompiledAssembly> Assemblies;
        public readonly IReadOnlyList<PackageType> All;

        /// <param name="names">Of the assemblies, but for the adapters. What is not there is a fault.</param>
        public PackageTypes(PackageTree package, IEnumerable<string> names, Findings findings)
        {
            Assemblies = PackageAssemblies.Open(package, names, findings).Concat(Adapters(package, findings)).ToList();
            All = Assemblies.SelectMany(assembly => assembly.Metadata.TypeDefinitions.Select(handle => new PackageType(assembly, handle))).ToList();
            foreach (PackageType type in All)
                byKey.TryAdd(type.Name.Key, type);
        }

        public void Dispose()
        {
            foreach (CompiledAssembly assembly in Assemblies)
                assembly.Dispose();
        }

        /// <summary>Null: the package has no such type.</summary>
        public PackageType Find(ApiTypeName name) => byKey.GetValueOrDefault(name.Key);

        /// <summary>The type and those of the package that it derives from, nearest first.</summary>
        public IEnumerable<PackageType> Lineage(PackageType type)
        {
            for (; type != null; type = BaseOf(type) is { } parent ? Find(parent) : null)
                yield return type;
        }

        /// <summary>Whether a type derives from another or implements it, as an interface.</summary>
        public bool DerivesFrom(PackageType type, ApiTypeName other)
        {
            foreach (PackageType inherited in Lineage(type))
            {
                if (inherited.Name.Key == other.Key || BaseOf(inherited)?.Key == other.Key)
                    return true;
                foreach (InterfaceImplementationHandle handle in inherited.Definition.GetInterfaceImplementations())
                    if (CompiledTypeNames.Of(inherited.Assembly.Metadata,
                        inherited.Assembly.Metadata.GetInterfaceImplementation(handle).Interface).Key
                        == other.Key)
                        return true;
            }
            return false;
        }

        /// <summary>The first class that is not the package's: null for an interface.</summary>
        public ApiTypeName ForeignBase(PackageType type) => BaseOf(Lineage(type).Last());

        static ApiTypeName BaseOf(PackageType type) =>
            type.Definition.BaseType.IsNil ? null : CompiledTypeNames.Of(type.Assembly.Metadata, type.Definition.BaseType);

        // Adapters in the version in which each has all of its paths.
        static IEnumerable<CompiledAssembly> Adapters(PackageTree package, Findings findings)
        {
            foreach (string file in PipelineKind.All.Select(PipelineAdapters.FileOf).Where(package.Has))
            {
                AdapterDefinition adapter = AdapterDefinition.Read(package.FullPath(file));
                byte[] image = PipelineAssemblies.Of(PipelineVersion.Find("17")).CompileAdapter(adapter, true, out List<string> errors);
                if (image != null)
                    yield return new CompiledAssembly(new MemoryStream(image));
                else
                    findings.Fault($"{adapter.Name} is not compiled: {string.Join("; ", errors)}");
            }
        }
    }
}
