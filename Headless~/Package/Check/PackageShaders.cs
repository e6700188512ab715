using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.CompilerServices;
using System.Text.Json;
using Host.Shaders;
using UnityEngine.Headless;

namespace Host.Check
{
    /// <summary>Shader files of a package that Unity would compile: those of its tests and samples too, and none of other hidden folders.</summary>
    static class PackageShaders
    {
        const string Samples = "Samples~/";

        // Several rules look at the same: a tree's are read once, and compiled once.
        static readonly ConditionalWeakTable<PackageTree, ConcurrentDictionary<(string, IShaderBackend), Lazy<Reading>>> readings = new();

        sealed class Reading
        {
            public int Files;
            public readonly List<ShaderVariant> Variants = new();
            public readonly List<string> Faults = new();
        }

        /// <summary>Files that cannot be read as what they are become faults.</summary>
        /// <param name="cacheFolder">Null: that of <see cref="ShaderCache"/>.</param>
        /// <param name="backend">Compiles the variants when asked; null = glslang.</param>
        public static IReadOnlyList<ShaderVariant> Variants(PackageTree package, string cacheFolder, Findings findings, out int files,
            IShaderBackend backend = null)
        {
            backend ??= ShaderBackend.Glslang;
            Reading reading = readings.GetOrCreateValue(package)
                .GetOrAdd((cacheFolder, backend), _ => new Lazy<Reading>(() => Read(package, cacheFolder, backend))).Value;
            reading.Faults.ForEach(findings.Fault);
            files = reading.Files;
            return reading.Variants;
        }

        static Reading Read(PackageTree package, string cacheFolder, IShaderBackend backend)
        {
            var reading = new Reading();
            var findings = new Findings();
            string packageFolder = PackageFolder(package, findings);
            reading.Faults.AddRange(findings.Faults);
            string Resolve(string include) => packageFolder != null && include.StartsWith(packageFolder, StringComparison.Ordinal)
                ? package.FullPath(include.Substring(packageFolder.Length)) : null;

            List<string> paths = Files(package, ".compute", ".shader").ToList();
            reading.Files = paths.Count;
            var cache = new ShaderCache(cacheFolder);
            (IReadOnlyList<ShaderVariant> variants, string fault) ReadFile(string path)
            {
                try
                {
                    return (ShaderImporter.AllVariants(package.FullPath(path), path, Resolve, cache, backend), null);
                }
                catch (ShaderCompileException e)
                {
                    return (Array.Empty<ShaderVariant>(), e.Message);
                }
            }

            foreach ((IReadOnlyList<ShaderVariant> variants, string fault) in paths.AsParallel().AsOrdered().Select(ReadFile))
            {
                reading.Variants.AddRange(variants);
                if (fault != null)
                    reading.Faults.Add(fault);
            }
            return reading;
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
