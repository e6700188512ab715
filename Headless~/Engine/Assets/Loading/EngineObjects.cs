using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Host.Shaders;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace Host.Assets
{
    /// <summary>Makes the engine's objects from imported files.</summary>
    internal sealed class EngineObjects
    {
        readonly Lazy<ShaderCache> cache = new Lazy<ShaderCache>(() => new ShaderCache());
        readonly IncludeResolver includes;

        /// <param name="includes">"Packages/com.x/Shaders/Y.hlsl" to a file on disk; null when there is none.</param>
        public EngineObjects(IncludeResolver includes)
        {
            this.includes = includes;
            BuiltInShaders.Install();
        }

        public ComputeShader ComputeShader(AssetEntry entry) =>
            AsAsset(UnityEngine.ComputeShader.Create(ShaderImporter.ImportCompute(entry.File, entry.Path, includes, cache.Value)), entry.Name);

        /// <param name="note">Takes what the importer passed over.</param>
        public Shader Shader(AssetEntry entry, Action<string> note)
        {
            var source = ShaderImporter.ImportShader(entry.File, entry.Path, Includes, cache.Value, Player.PipelineTag);
            foreach (var text in source.Notes) note(text);
            return AsAsset(UnityEngine.Shader.Create(source), source.Name);
        }

        // The package of the pipeline that is stood in for is there in name.
        string Includes(string path) => Player.PipelinePackage != null && path == $"Packages/{Player.PipelinePackage}/package.json" ? path
            : includes?.Invoke(path);

        public TextAsset Text(AssetEntry entry) => AsAsset(new TextAsset(File.ReadAllBytes(entry.File)), entry.Name);

        /// <summary>Colors are sRGB unless the .meta file says otherwise, as the importer has it.</summary>
        public Texture2D Texture(AssetEntry entry)
        {
            var image = PngImage.Read(File.ReadAllBytes(entry.File), entry.Path);
            var settings = File.Exists(entry.File + ".meta")
                ? UnityYaml.ParsePlain(File.ReadAllText(entry.File + ".meta"), entry.Path + ".meta")["TextureImporter"] : null;
            var mipmaps = settings?["mipmaps"] ?? new YamlMapping(default);
            var texture = new Texture2D(image.Width, image.Height, TextureFormat.RGBA32, mipmaps.Bool("enableMipMap", true),
                !mipmaps.Bool("sRGBTexture", true));
            texture.SetPixels32(image.Pixels);
            texture.Apply();
            return AsAsset(TextureReader.Sampled(texture, settings?["textureSettings"]), entry.Name);
        }

        static T AsAsset<T>(T made, string name) where T : Object
        {
            made.name = name;
            made.IsAsset = true;
            return made;
        }

        static readonly Dictionary<string, Type> ComponentTypes = new[] { typeof(Component), typeof(Rigidbody) }
            .SelectMany(t => t.Assembly.GetExportedTypes()).Where(t => t.Namespace == "UnityEngine" && !t.IsAbstract
                && typeof(Component).IsAssignableFrom(t)).ToDictionary(t => t.Name);

        /// <summary>The engine's component that files call by that name; null when the host has none.</summary>
        public static Type ComponentType(string name) => ComponentTypes.TryGetValue(name, out var type) ? type : null;
    }
}
