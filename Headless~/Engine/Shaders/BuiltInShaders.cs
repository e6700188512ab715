using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Shaders
{
    /// <summary>Standard, Unlit/Color and their like, imported when first asked for.</summary>
    internal static class BuiltInShaders
    {
        static readonly Regex Name = new Regex("^Shader \"([^\"]+)\"", RegexOptions.Multiline);
        // Names from before Unity 5 still find their shaders.
        static readonly string[] Former = { "", "Legacy Shaders/" };

        static readonly Lazy<Dictionary<string, string>> files = new Lazy<Dictionary<string, string>>(() =>
            Directory.GetFiles(BuiltInFiles.Shaders, "*.shader").ToDictionary(f => Name.Match(File.ReadAllText(f)).Groups[1].Value));
        static readonly Dictionary<string, ShaderSource> sources = new Dictionary<string, ShaderSource>();
        static readonly Dictionary<string, Shader> shaders = new Dictionary<string, Shader>();

        public static IEnumerable<string> Names => files.Value.Keys;

        /// <summary>The engine finds them from here on.</summary>
        public static void Install() => BuiltinResources.FindShader = Find;

        static Shader Find(string name)
        {
            name = Former.Select(prefix => prefix + name).FirstOrDefault(files.Value.ContainsKey);
            if (name == null)
                return null;
            if (shaders.TryGetValue(name, out Shader shader) && shader != null)
                return shader;
            if (!sources.TryGetValue(name, out ShaderSource source))
            {
                string file = files.Value[name];
                sources.Add(name, source = ShaderImporter.ImportShader(file, Path.GetFileName(file), null, new ShaderCache()));
            }
            shader = Shader.Create(source);
            (shader.IsAsset, shader.hideFlags) = (true, HideFlags.HideAndDontSave);
            return shaders[name] = shader;
        }
    }
}
