using System;
using System.Reflection;
using Host.Assets;
using Rill;
using UnityEngine.Headless;
using UnityEngine.SceneManagement;

namespace Host.Tests
{
    /// <summary>A sample of the package as the scene of a built player, until it is disposed of.</summary>
    sealed class SampleScene : IDisposable
    {
        readonly ProjectAssets assets;
        readonly IAssetSource assetsBefore = Player.Assets;
        readonly Func<string, Scene> loaderBefore = SceneManager.SceneLoader;
        readonly Func<string, StageShader> findBefore = StageShader.EditorFind;
        readonly string path;

        public SampleScene(string sample)
        {
            LocatedScene located = Session.Locate(sample);
            path = located.AssetPath;
            assets = new ProjectAssets(located.Mounts,
                new[] { typeof(FluidSimulation).Assembly, typeof(FluidBuoyancy).Assembly, Assembly.Load("Rill.Samples") }, strict: true);
            Player.Assets = assets;
            StageShader.EditorFind = null;
            SceneManager.SceneLoader = name => SceneAsset.Load(assets, name);
            try
            {
                Load();
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        /// <summary>Loads the scene, instead of what is loaded.</summary>
        public void Load() => SceneManager.LoadNow(path, LoadSceneMode.Single);

        public void Dispose()
        {
            SceneManager.UnloadEverything();
            assets.ReloadAll();
            Player.Assets = assetsBefore;
            StageShader.EditorFind = findBefore;
            SceneManager.SceneLoader = loaderBefore;
        }
    }
}
