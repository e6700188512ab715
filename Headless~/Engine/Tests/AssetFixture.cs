using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Host.Assets;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.SceneManagement;
using Object = UnityEngine.Object;

namespace Host.Tests
{
    /// <summary>Opens the projects of these tests and leaves the player as it was.</summary>
    public abstract class AssetFixture
    {
        /// <summary>Files under Assets/: a Unity project, and a package that its manifest refers to.</summary>
        internal static readonly string ProjectRoot = Path.Combine(Folder(), "Assets", "Project");
        internal static readonly string PackageRoot = Path.Combine(Folder(), "Assets", "Package");

        static string Folder() => TestFolder.Path;

        IAssetSource assetsBefore;
        bool linearBefore, strictBefore;
        string projectBefore;
        Dictionary<Type, int> ordersBefore;
        TemporaryProject temporary;
        static readonly List<ProjectAssets> opened = new List<ProjectAssets>();

        [SetUp]
        public void RememberThePlayer()
        {
            assetsBefore = Player.Assets;
            linearBefore = Player.LinearColorSpace;
            strictBefore = Player.Strict;
            projectBefore = Player.ProjectPath;
            ordersBefore = new Dictionary<Type, int>(ExecutionOrder.FromMeta);
            Fixtures.Part.Log.Clear();
        }

        [TearDown]
        public void RestoreThePlayer()
        {
            SceneManager.UnloadEverything();
            foreach (var project in opened) project.ReloadAll();
            opened.Clear();
            SceneManager.SceneLoader = null;
            SceneManager.BuildScenes.Clear();
            ExecutionOrder.FromMeta.Clear();
            foreach (var order in ordersBefore) ExecutionOrder.FromMeta.Add(order.Key, order.Value);
            Player.Assets = assetsBefore;
            Player.LinearColorSpace = linearBefore;
            Player.Strict = strictBefore;
            Player.ProjectPath = projectBefore;
            temporary?.Dispose();
            temporary = null;
        }

        internal static ProjectAssets Open(bool strict = true)
        {
            var project = ProjectAssets.Open(ProjectRoot, new[] { typeof(AssetFixture).Assembly }, strict);
            Play(project, ProjectRoot);
            return project;
        }

        /// <summary>Plays like a session of the host when it starts.</summary>
        internal static void Play(ProjectAssets project, string root)
        {
            opened.Add(project);
            Player.Assets = project;
            SceneManager.SceneLoader = name => SceneAsset.Load(project, name);
            ProjectSettings.Apply(root, path => project.ResolvePath(path) != null);
            foreach (var order in project.ExecutionOrders()) ExecutionOrder.FromMeta[order.Key] = order.Value;
        }

        internal static Scene LoadMain(ProjectAssets project)
        {
            var scene = SceneManager.LoadNow("Assets/Scenes/Main.unity", LoadSceneMode.Single);
            Assert.That(scene.IsValid(), "the scene was found");
            return scene;
        }

        internal static T Get<T>(Scene scene, string path) where T : Component
        {
            var parts = path.Split(new[] { '/' }, 2);
            var root = scene.GetRootGameObjects().Single(r => r.name == parts[0]).transform;
            return (parts.Length == 1 ? root : root.Find(parts[1])).GetComponent<T>();
        }

        /// <summary>For what needs a device: the player's own, or one for this test.</summary>
        internal static void WithDevice(Action test)
        {
            if (Player.Device != null)
            {
                test();
                return;
            }
            using var device = new Host.Vulkan.VulkanDevice(validation: true);
            Player.Device = device;
            try
            {
                test();
            }
            finally
            {
                foreach (var project in opened) project.ReloadAll();
                Gpu.Reset();
                Player.Device = null;
            }
        }

        /// <summary>A project of its own for one test, with the fixture scripts in Assets/Scripts.</summary>
        internal TemporaryProject Temporary() => temporary ??= new TemporaryProject();
    }

    /// <summary>Files written for one test; .meta files come by themselves unless the test writes them.</summary>
    internal sealed class TemporaryProject : IDisposable
    {
        public const string Header = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n";
        public const string PartGuid = "10000000000000000000000000000003", RecipeGuid = "10000000000000000000000000000002";

        public readonly string Root = Path.Combine(Path.GetTempPath(), "rill-assets-" + Guid.NewGuid().ToString("N"));

        public TemporaryProject()
        {
            Write("Packages/manifest.json", "{}", null);
            Write("Assets/Scripts/Part.cs", "", PartGuid);
            Write("Assets/Scripts/Recipe.cs", "", RecipeGuid);
        }

        /// <param name="guid">Null writes no .meta file.</param>
        public TemporaryProject Write(string path, string text, string guid)
        {
            var file = Path.Combine(Root, path);
            Directory.CreateDirectory(Path.GetDirectoryName(file));
            File.WriteAllText(file, text);
            if (guid != null) File.WriteAllText(file + ".meta", $"fileFormatVersion: 2\nguid: {guid}\n");
            return this;
        }

        /// <summary>A scene of one object 'Tank' with a Part whose fields are the given lines.</summary>
        public TemporaryProject Scene(string fields, string script = PartGuid)
            => Write("Assets/Main.unity", SceneText(fields, script), "a0000000000000000000000000000001");

        public static string SceneText(string fields, string script = PartGuid) => Header
            + "--- !u!1 &10\nGameObject:\n  m_Component:\n  - component: {fileID: 11}\n  - component: {fileID: 12}\n  m_Name: Tank\n  m_IsActive: 1\n"
            + "--- !u!4 &11\nTransform:\n  m_GameObject: {fileID: 10}\n  m_Father: {fileID: 0}\n"
            + $"--- !u!114 &12\nMonoBehaviour:\n  m_GameObject: {{fileID: 10}}\n  m_Enabled: 1\n  m_Script: {{fileID: 11500000, guid: " +
            $"{script}, type: 3}}\n  m_Name: \n{fields}";

        public ProjectAssets Open(bool strict = true)
        {
            var project = ProjectAssets.Open(Root, new[] { typeof(TemporaryProject).Assembly }, strict);
            AssetFixture.Play(project, Root);
            return project;
        }

        public Scene Load(bool strict = true)
        {
            Open(strict);
            return SceneManager.LoadNow("Main", LoadSceneMode.Single);
        }

        /// <summary>The message that opening the scene ends with.</summary>
        public string Fault() => Assert.Throws<AssetException>(() => Load()).Message;

        public void Dispose() => Directory.Delete(Root, true);
    }
}
