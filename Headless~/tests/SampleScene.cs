using System;
using System.Reflection;
using Host.Assets;
using Rill;
using UnityEngine.Headless;
using UnityEngine.SceneManagement;

namespace Host.Tests
{
    /// <summary>A sample of the package as the player's scene, until it is disposed of.</summary>
    sealed class SampleScene : IDisposable
    {
        readonly ProjectAssets assets;
        readonly IAssetSource assetsBefore = Player.Assets;
        readonly Func<string, Scene> loaderBefore = SceneManager.SceneLoader;
        readonly string path;

        public SampleScene(string sample)
        {
            LocatedScene located = Session.Locate(sample);
            path = located.AssetPath;
            assets = new ProjectAssets(located.Mounts, new[] { typeof(FluidSimulation).Assembly, typeof(FluidBuoyancy).Assembly, Assembly.Load("Rill.Samples") }, strict: true);
            Player.Assets = assets;
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

        /// <summary>Loads the scene, in place of what is loaded.</summary>
        public void Load() => SceneManager.LoadNow(path, LoadSceneMode.Single);

        public void Dispose()
        {
            SceneManager.UnloadEverything();
            assets.ReloadAll();
            Player.Assets = assetsBefore;
            SceneManager.SceneLoader = loaderBefore;
        }
    }
}
