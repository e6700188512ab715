using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Host.Shaders;
using UnityEngine.Headless;

namespace Host.Check
{
    /// <summary>Shader files of a package that Unity would compile: those of its tests and samples too, and none of other hidden folders.</summary>
    static class PackageShaders
    {
        const string Samples = "Samples~/";

        /// <summary>Files that cannot be read as what they are become faults.</summary>
        /// <param name="backend">Compiles the variants when asked; null = glslang.</param>
        public static IReadOnlyList<ShaderVariant> Variants(PackageTree package, ShaderCache cache, Findings findings, out int files,
            IShaderBackend backend = null)
        {
            string packageFolder = PackageFolder(package, findings);
            string Resolve(string include) => packageFolder != null && include.StartsWith(packageFolder, StringComparison.Ordinal)
                ? package.FullPath(include.Substring(packageFolder.Length)) : null;

            List<string> paths = Files(package, ".compute", ".shader").ToList();
            files = paths.Count;
            var variants = new List<ShaderVariant>();
            foreach (string path in paths)
                try
                {
                    variants.AddRange(ShaderImporter.AllVariants(package.FullPath(path), path, Resolve, cache, backend));
                }
                catch (ShaderCompileException e)
                {
                    findings.Fault(e.Message);
                }
            return variants;
        }

        /// <summary>Includes of which no variant has read a line: nothing shows that they compile.</summary>
        public static IEnumerable<string> Unread(PackageTree package, IEnumerable<ShaderVariant> variants)
        {
            HashSet<string> read = variants.Where(v => v.Fxc != null).SelectMany(v => v.Fxc.Source.Files).Select(Path.GetFullPath).ToHashSet();
            return Files(package, ".hlsl", ".cginc").Where(file => !read.Contains(package.FullPath(file)));
        }

        /// <summary>Unity's own include files that a variant reads, of which this host has stand-ins.</summary>
        public static IEnumerable<string> StandIns(ShaderVariant variant) =>
            variant.Fxc == null ? Enumerable.Empty<string>()
            : variant.Fxc.Source.Files.Where(file => Path.GetDirectoryName(Path.GetFullPath(file)) == BuiltInFiles.Includes)
            .Select(Path.GetFileName);

        /// <summary>Those of its tests and samples too.</summary>
        public static IEnumerable<string> Files(PackageTree package, params string[] extensions)
        {
            var visible = new HashSet<string>(package.Visible);
            return package.WithExtension(extensions).Where(file => visible.Contains(file) || file.StartsWith(Samples, StringComparison.Ordinal));
        }

        // "Packages/com.name/", as includes have it; a package without a name is another rule's fault, but its includes fail here.
        static string PackageFolder(PackageTree package, Findings findings)
        {
            if (!package.Has("package.json"))
                return null;
            try
            {
                using JsonDocument manifest = JsonDocument.Parse(package.Read("package.json"));
                return manifest.RootElement.TryGetProperty("name", out JsonElement name) ? $"Packages/{name.GetString()}/" : null;
            }
            catch (JsonException e)
            {
                findings.Fault($"package.json: {e.Message}");
                return null;
            }
        }
    }
}
