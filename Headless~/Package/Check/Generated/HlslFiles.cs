using System.Collections.Generic;
using System.IO;
using System.Reflection;

namespace Host.Check
{
    /// <summary>Declarations common to C# and HLSL, in HLSL: a file for each name that [GenerateHlsl] gives in the package's main assembly.</summary>
    sealed class HlslFiles : GeneratedFiles
    {
        const string OfThePackage = "Runtime/Gpu/GenerateHlslAttribute.cs";

        public override string Folder => "Shaders/Generated/";

        public override IReadOnlyDictionary<string, string> Texts(PackageTree package, Findings findings)
        {
            if (!package.Has(OfThePackage))
                return null;
            Assembly assembly = Compiled(package, "Rill", findings);
            IReadOnlyDictionary<string, string> files = assembly == null ? null : GeneratedHlsl.Files(assembly.GetTypes(),
                CodeSummaries.Load(Path.ChangeExtension(assembly.Location, ".xml")), findings);
            if (files == null)
                return null;
            var texts = new Dictionary<string, string> { [Folder.TrimEnd('/') + ".meta"] = Meta(Folder.TrimEnd('/'),
                "folderAsset: yes\nDefaultImporter") };
            foreach ((string name, string text) in files)
            {
                string path = $"{Folder}{name}.hlsl";
                texts.Add(path, text);
                texts.Add(path + ".meta", Meta(path, "ShaderIncludeImporter"));
            }
            return texts;
        }
    }
}
