using System.Linq;
using System.Reflection.Metadata;
using System.Reflection.PortableExecutable;

namespace Host.Check.Build
{
    /// <summary>
    /// Managed code stripping processes assemblies with types in scenes, what these refer to, and those with [AlwaysLinkAssembly]. It
    /// drops all others, and their methods with [RuntimeInitializeOnLoadMethod] or [Preserve] with them (Unity's manual, "Managed code
    /// stripping and the Unity linker").
    /// </summary>
    sealed class StrippingRule : Rule
    {
        static readonly string[] Kept = { "RuntimeInitializeOnLoadMethodAttribute", "PreserveAttribute" };

        public override string Name => "build: code stripping keeps every hook";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            int hooks = 0, assemblies = 0;
            foreach (AssemblyDefinition definition in RuntimeAssemblies.Of(package, findings))
                using (var file = new PEReader(RuntimeAssemblies.Open(package, definition)))
                {
                    MetadataReader reader = file.GetMetadataReader();
                    string[] own = reader.MethodDefinitions.Select(reader.GetMethodDefinition)
                        .Where(method => AttributeNames.Has(reader, method.GetCustomAttributes(), Kept))
                        .Select(method => $"{reader.GetString(reader.GetTypeDefinition(method.GetDeclaringType()).Name)}." +
                            reader.GetString(method.Name)).ToArray();
                    assemblies++;
                    hooks += own.Length;
                    if (own.Length > 0 && !AttributeNames.Has(reader, reader.GetAssemblyDefinition().GetCustomAttributes(),
                        "AlwaysLinkAssemblyAttribute"))
                        findings.Fault($"{definition.Name} has {own[0]}, which a build drops with the assembly where no scene reaches it: " +
                            $"write [assembly: AlwaysLinkAssembly] of UnityEngine.Scripting into {definition.Folder}AssemblyInfo.cs");
                }
            findings.Looked = $"{hooks} methods in {assemblies} assemblies";
            return findings;
        }
    }
}
