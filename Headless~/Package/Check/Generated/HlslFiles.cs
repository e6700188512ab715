using System;
using System.Collections.Generic;
using System.IO;
using System.Reflection;
using System.Security.Cryptography;
using System.Text;

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
            string assembly = Path.Combine(package.Assemblies, "Rill.dll");
            if (!File.Exists(assembly))
            {
                findings.Fault($"{assembly} is not there: build it first (Headless~/rill does)");
                return null;
            }
            IReadOnlyDictionary<string, string> files = GeneratedHlsl.Files(Assembly.LoadFrom(assembly).GetTypes(),
                CodeSummaries.Load(Path.ChangeExtension(assembly, ".xml")), findings);
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

        // Writes them like Headless~/Engine/tools/make-meta: the GUID comes from the path.
        static string Meta(string path, string importer) =>
            $"fileFormatVersion: 2\nguid: " +
            $"{Convert.ToHexString(MD5.HashData(Encoding.UTF8.GetBytes("com.rill.fluids:" + path))).ToLowerInvariant()}\n{importer}:\n  " +
            "externalObjects: {}\n  userData: \n  assetBundleName: \n  assetBundleVariant: \n";
    }
}
