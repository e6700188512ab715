using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Host.Shaders;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.SceneManagement;
using Object = UnityEngine.Object;

namespace Host.Assets
{
    // Which file becomes what.
    internal sealed partial class ProjectAssets
    {
        readonly Dictionary<string, UnityYaml> prefabs = new Dictionary<string, UnityYaml>();
        readonly Stack<string> prefabsOpening = new Stack<string>();
        readonly EngineObjects engine;
        readonly Queue<Action> wakeups = new Queue<Action>();
        int loading;

        static readonly string[] YamlExtensions = { ".asset", ".mat", ".prefab", ".mesh", ".rendertexture" };

        /// <summary>Whether to open a file at all for someone who wants that type: Resources.LoadAll("") must not compile every shader.</summary>
        static bool CouldBe(AssetEntry entry, Type type)
        {
            switch (entry.Extension)
            {
                case ".compute": return type.IsAssignableFrom(typeof(ComputeShader));
                case ".shader": return type.IsAssignableFrom(typeof(Shader));
                case ".mat": return type.IsAssignableFrom(typeof(Material));
                case ".mesh": case ".obj": return type.IsAssignableFrom(typeof(Mesh));
                case ".rendertexture": return type.IsAssignableFrom(typeof(RenderTexture));
                case ".png": return type.IsAssignableFrom(typeof(Texture2D));
                case ".prefab": return type.IsAssignableFrom(typeof(GameObject)) || typeof(Component).IsAssignableFrom(type);
                case ".asset": return !typeof(Component).IsAssignableFrom(type) && type != typeof(GameObject);
                default: return IsText(entry) && type.IsAssignableFrom(typeof(TextAsset));
            }
        }

        static bool IsText(AssetEntry entry) => entry.Extension switch
        {
            ".txt" or ".json" or ".md" or ".csv" or ".xml" or ".html" or ".htm" or ".yaml" or ".bytes" or ".fnt" => true,
            _ => false,
        };

        /// <summary>Null for a kind of file of which no object is made.</summary>
        LoadedAsset Load(AssetEntry entry)
        {
            if (loaded.TryGetValue(entry.Path, out var asset)) return asset;
            try
            {
                asset = Reading(() => Import(entry));
            }
            catch
            {
                // Half-read objects must not be found by the next who asks.
                loaded.Remove(entry.Path);
                throw;
            }
            return loaded[entry.Path] = asset;
        }

        /// <summary>OnEnable of a ScriptableObject may look at assets that refer back to it: first all values, then all calls.</summary>
        T Reading<T>(Func<T> read)
        {
            T result;
            loading++;
            try
            {
                result = read();
            }
            catch
            {
                if (loading == 1) wakeups.Clear();
                throw;
            }
            finally
            {
                loading--;
            }
            if (loading == 0)
                while (wakeups.Count > 0) wakeups.Dequeue()();
            return result;
        }

        /// <summary>Its objects are made and have their values; waking them is the scene manager's.</summary>
        public Scene ReadScene(AssetEntry entry) => Reading(() =>
        {
            var scene = SceneManager.CreateForLoading(entry.Name, entry.Path);
            new ObjectBuilder(this, Documents(entry), scenes[entry.Path] = new LoadedAsset(entry), scene, wakeups.Enqueue).Build();
            return scene;
        });

        LoadedAsset Import(AssetEntry entry)
        {
            var asset = new LoadedAsset(entry);
            if (entry.IsFolder) return null;
            switch (entry.Extension)
            {
                case ".compute": return asset.With(MainFileId.ComputeShader, engine.ComputeShader(entry));
                case ".shader": return asset.With(MainFileId.Shader, engine.Shader(entry, note => Note($"{entry.Path}: {note}")));
                case ".png": return asset.With(MainFileId.Texture, engine.Texture(entry));
                case ".obj": return ModelReader.Read(asset);
                case ".jpg": case ".jpeg": case ".tga": case ".psd": case ".exr": case ".hdr": case ".tif": case ".tiff": case ".bmp":
                    Fail($"{entry.Path}: the host reads textures from .png files only: convert it");
                    return null;
            }
            if (IsText(entry)) return asset.With(MainFileId.TextAsset, engine.Text(entry));
            if (!YamlExtensions.Contains(entry.Extension)) return null;

            loaded[entry.Path] = asset;
            var roots = new ObjectBuilder(this, Documents(entry), asset, default, wakeups.Enqueue).Build();
            ObjectFactory.Wake(roots);
            asset.Main = roots.Count > 0 ? roots[0] : MainOf(asset);
            return asset;
        }

        /// <summary>The lowest well-known id is the asset itself, others are its sub-assets.</summary>
        static Object MainOf(LoadedAsset asset) =>
            asset.Objects.TryGetValue(11400000, out var main) || asset.Objects.TryGetValue(MainFileId.Material, out main) ? main
            : asset.Objects.Values.FirstOrDefault();

        /// <summary>A file's documents with its prefab instances expanded.</summary>
        public UnityYaml Documents(AssetEntry entry)
        {
            if (prefabs.TryGetValue(entry.Path, out var documents)) return documents;
            if (prefabsOpening.Contains(entry.Path))
                throw new AssetException(
                $"{entry.Path} contains itself as a prefab, by way of {string.Join(", ", prefabsOpening)}: remove one of the instances");
            prefabsOpening.Push(entry.Path);
            documents = new PrefabExpander(PrefabDocuments, text => Note(text)).Expand(UnityYaml.Load(entry.File, entry.Path));
            prefabsOpening.Pop();
            // A scene is opened once, a prefab by every file that has an instance of it.
            if (entry.Extension == ".prefab") prefabs[entry.Path] = documents;
            return documents;
        }

        UnityYaml PrefabDocuments(FileReference prefab, string instance)
        {
            var entry = Entry(prefab, new ReadScope(() => instance));
            if (entry == null) return null;
            if (entry.Extension == ".prefab") return Documents(entry);
            Note($"{prefab.Location}: {instance} is of {entry.Path}, a model: the host reads no models, so it is left out");
            return null;
        }
    }
}
