using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Host;
using Host.Assets;
using NUnit.Framework;
using UnityEngine.Headless;
using UnityEngine.SceneManagement;

namespace Rill.Samples.Tests
{
    /// <summary>Imports the samples that bring tests, as into a project, for as long as those tests run.</summary>
    [SetUpFixture]
    public sealed class ImportedSamples
    {
        static readonly string[] WithTests = { "Key in a Well" };

        IAssetSource assetsBefore;
        Func<string, Scene> loaderBefore;
        ProjectAssets assets;

        [OneTimeSetUp]
        public void Import()
        {
            List<MountedFolder> mounts = WithTests.SelectMany(sample => Session.Locate(sample).Mounts).ToList();
            assets = new ProjectAssets(mounts, new[] { typeof(FluidSimulation).Assembly, typeof(FluidBuoyancy).Assembly,
                Assembly.Load("Rill.Samples") }, strict: true);
            (assetsBefore, loaderBefore) = (Player.Assets, SceneManager.SceneLoader);
            Player.Assets = assets;
            SceneManager.SceneLoader = name => SceneAsset.Load(assets, name);
        }

        [OneTimeTearDown]
        public void Remove()
        {
            SceneManager.UnloadEverything();
            assets.ReloadAll();
            (Player.Assets, SceneManager.SceneLoader) = (assetsBefore, loaderBefore);
        }
    }
}
