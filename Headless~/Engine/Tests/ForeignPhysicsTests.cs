using System;
using System.IO;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>A user's project finds floors, messages, queries and settings of the physics, and what is preloaded.</summary>
    public class ForeignPhysicsTests
    {
        const string Tests = @"
using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

public class CrateTests
{
    [UnityTest] public IEnumerator A_crate_lands_on_a_primitive_and_hears_of_it()
    {
        GameObject floor = GameObject.CreatePrimitive(PrimitiveType.Cube), crate = GameObject.CreatePrimitive(PrimitiveType.Cube);
        floor.transform.localScale = new Vector3(10f, 1f, 10f);
        crate.transform.position = new Vector3(0f, 1.5f, 0f);
        crate.AddComponent<Rigidbody>();
        var ear = crate.AddComponent<Ear>();
        for (int i = 0; i < 50; i++) yield return new WaitForFixedUpdate();
        Assert.That(crate.transform.position.y, Is.EqualTo(1f).Within(0.01f));
        Assert.That(ear.Heard, Is.EqualTo(""Cube""));
        Assert.That(Physics.Raycast(new Vector3(3f, 5f, 3f), Vector3.down, out RaycastHit hit) && hit.transform == floor.transform);
        Assert.That(gameObjectScene(crate).GetPhysicsScene() == Physics.defaultPhysicsScene);
    }

    static UnityEngine.SceneManagement.Scene gameObjectScene(GameObject thing) => thing.scene;

    [Test] public void Layers_are_those_of_the_settings() =>
        Assert.That(Physics.GetIgnoreLayerCollision(8, 9) && !Physics.GetIgnoreLayerCollision(8, 8) && !Physics.GetIgnoreLayerCollision(0, 9));
    [Test] public void Gravity_is_that_of_the_settings() => Assert.That(Physics.gravity.y, Is.EqualTo(-10f));
}";

        const string Ear = @"
using UnityEngine;
public class Ear : MonoBehaviour
{
    public string Heard;
    void OnCollisionEnter(Collision collision) => Heard = collision.gameObject.name;
}";

        const string Catalogue = @"
using UnityEngine;
public class Catalogue : ScriptableObject
{
    public int pages;
    static Catalogue loaded;
    void OnEnable() => loaded = this;
    [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.AfterAssembliesLoaded)]
    static void Look() => Debug.Log(loaded != null ? $""a catalogue of {loaded.pages} pages"" : ""no catalogue"");
}";

        string root;
        int files;

        [SetUp]
        public void StartProject()
        {
            root = Path.Combine(Path.GetTempPath(), "rill-physics-" + Guid.NewGuid().ToString("N"));
            Write("ProjectSettings/ProjectVersion.txt", "m_EditorVersion: 2022.3.0f1\n");
            Write("Packages/manifest.json", @"{ ""dependencies"": { ""com.unity.test-framework"": ""1.1.33"", ""com.unity.ide.rider"": ""3.0.24"", ""com.unity.modules.physics"": ""1.0.0"" } }");
        }

        [TearDown]
        public void RemoveProject() => Directory.Delete(root, true);

        string Write(string path, string text)
        {
            string file = Path.Combine(root, path), guid = (++files).ToString("x32");
            Directory.CreateDirectory(Path.GetDirectoryName(file));
            File.WriteAllText(file, text);
            if (path.StartsWith("Assets/"))
                File.WriteAllText(file + ".meta", $"fileFormatVersion: 2\nguid: {guid}\n");
            return guid;
        }

        static string Asset(int kind, string type, string fields)
            => $"%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!{kind} &11400000\n{type}:\n{fields}";

        // All layers meet but 8 and 9: byte 1 of their masks lacks the other's bit.
        static string Matrix()
        {
            var text = new System.Text.StringBuilder();
            for (int layer = 0; layer < 32; layer++)
                text.Append(layer == 8 ? "fffdffff" : layer == 9 ? "fffeffff" : "ffffffff");
            return text.ToString();
        }

        [Test]
        public void Bodies_messages_queries_and_settings_are_those_of_the_project()
        {
            Write("ProjectSettings/DynamicsManager.asset", Asset(55, "PhysicsManager",
                $"  m_Gravity: {{x: 0, y: -10, z: 0}}\n  m_LayerCollisionMatrix: {Matrix()}\n"));
            Write("Assets/Scripts/Game.asmdef", @"{ ""name"": ""Game"" }");
            Write("Assets/Scripts/Ear.cs", Ear);
            Write("Assets/Tests/Game.Tests.asmdef", @"{ ""name"": ""Game.Tests"", ""references"": [""Game"", ""UnityEngine.TestRunner"", ""UnityEditor.TestRunner""], ""overrideReferences"": true,
                ""precompiledReferences"": [""nunit.framework.dll""], ""autoReferenced"": false, ""defineConstraints"": [""UNITY_INCLUDE_TESTS""] }");
            Write("Assets/Tests/CrateTests.cs", Tests);
            new ProjectRun(root).MustHaveEnded(0, "3 passed, 0 failed");
        }

        [Test]
        public void A_player_loads_the_preloaded_assets_before_its_first_script()
        {
            string script = Write("Assets/Catalogue.cs", Catalogue);
            string asset = Write("Assets/Lamps.asset", Asset(114, "MonoBehaviour",
                $"  m_Script: {{fileID: 11500000, guid: {script}, type: 3}}\n  m_Name: Lamps\n  pages: 12\n"));
            const string gone = "0123456789abcdef0123456789abcdef";
            Write("ProjectSettings/ProjectSettings.asset", Asset(129, "PlayerSettings", "  preloadedAssets:\n  - {fileID: 0}\n" +
                $"  - {{fileID: 11400000, guid: {asset}, type: 2}}\n  - {{fileID: 11400000, guid: {gone}, type: 2}}\n"));
            Scene();
            using var run = new ForeignRun(root, 2, "Main", "--no-frames");
            run.MustHaveSucceeded();
            Assert.That(run.Output, Does.Contain("a catalogue of 12 pages"));
            Assert.That(run.Errors, Has.Exactly(1).Contains("Preloaded Assets").And.Some.Contains(gone));
        }

        [Test]
        public void What_a_player_has_nothing_of_is_no_warning_and_missing_meta_files_are_one()
        {
            Scene();
            for (int i = 0; i < 12; i++)
                File.WriteAllText(Path.Combine(root, "Assets", $"Note{i}.txt"), "");
            using var run = new ForeignRun(root, 1, "Main", "--no-frames");
            run.MustHaveSucceeded();
            Assert.That(run.Errors, Has.Exactly(1).Contains("meta file").And.Some.Contains("12 files and folders (Assets/Note0.txt, "));
            Assert.That(run.Errors, Has.None.Contains("com.unity."));
        }

        [Test]
        public void A_package_that_a_player_needs_is_still_missed()
        {
            Write("Packages/manifest.json", @"{ ""dependencies"": { ""com.unity.inputsystem"": ""1.7.0"", ""com.unity.test-framework"": ""1.1.33"" } }");
            Scene();
            using var run = new ForeignRun(root, 1, "Main", "--no-frames");
            Assert.That(run.Errors, Has.Exactly(1).Contains("com.unity.").And.Some.Contains("com.unity.inputsystem 1.7.0 is not here"));
        }

        void Scene()
        {
            Write("Assets/Main.unity", "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!1 &100\nGameObject:\n  m_Component:\n" +
                "  - component: {fileID: 101}\n  m_Name: Thing\n  m_IsActive: 1\n--- !u!4 &101\nTransform:\n  m_GameObject: {fileID: 100}\n" +
                "  m_LocalRotation: {x: 0, y: 0, z: 0, w: 1}\n  m_LocalPosition: {x: 0, y: 0, z: 0}\n  m_LocalScale: {x: 1, y: 1, z: 1}\n" +
                "  m_Children: []\n  m_Father: {fileID: 0}\n");
        }
    }
}
