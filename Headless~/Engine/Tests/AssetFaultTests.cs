using System.Linq;
using Fixtures;
using Host.Assets;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Host.Tests
{
    /// <summary>Faults of a file are reported with file, line, object, field and remedy.</summary>
    public class AssetFaultTests : AssetFixture
    {
        const string Missing = "dddddddddddddddddddddddddddddddd";

        [Test]
        public void A_missing_guid_names_file_line_object_field_and_remedy()
        {
            var message = Temporary().Scene($"  partner: {{fileID: 5, guid: {Missing}, type: 3}}\n").Fault();
            Assert.That(message, Does.StartWith("Assets/Main.unity(20): Part on 'Tank', field partner refers to an asset with guid " + Missing));
            Assert.That(message, Does.Contain("restore the asset with its .meta file"));
        }

        [Test]
        public void A_missing_guid_is_none_and_logged_when_not_strict()
        {
            LogAssert.Expect(LogType.Error, new System.Text.RegularExpressions.Regex("refers to an asset with guid " + Missing));
            var scene = Temporary().Scene($"  size: 9\n  partner: {{fileID: 5, guid: {Missing}, type: 3}}\n").Load(strict: false);
            Assert.That(Get<Part>(scene, "Tank").partner, Is.Null);
            Assert.That(Get<Part>(scene, "Tank").size, Is.EqualTo(9));
        }

        [Test]
        public void A_missing_file_id_of_the_scene_is_named() =>
            Assert.That(Temporary().Scene("  partner: {fileID: 99}\n").Fault(),
            Is.EqualTo(
            "Assets/Main.unity(20): Part on 'Tank', field partner refers to object 99, which is not in this file: assign the field again"));

        [Test]
        public void A_missing_file_id_of_an_asset_lists_what_the_asset_has() =>
            Assert.That(Temporary().Write("Assets/Note.txt", "x", "e0000000000000000000000000000001")
            .Scene("  partner: {fileID: 99, guid: e0000000000000000000000000000001, type: 3}\n").Fault(),
                Does.Contain("object 99 of Assets/Note.txt, which has none with that file id (it has 4900000 TextAsset)"));

        [Test]
        public void An_object_of_the_wrong_type_is_refused() =>
            Assert.That(Temporary().Scene("  partner: {fileID: 11}\n").Fault(),
            Does.Contain("field partner is of type Part, but {fileID: 11} is the Transform 'Tank'"));

        [Test]
        public void A_guid_that_two_assets_have_is_refused() =>
            Assert.That(Temporary().Write("Assets/A.txt", "x", "e0000000000000000000000000000001")
            .Write("Assets/B.txt", "x", "e0000000000000000000000000000001")
                .Scene("  partner: {fileID: 4900000, guid: e0000000000000000000000000000001, type: 3}\n").Fault(),
                    Does.Contain("a guid that two assets have").And.Contain("Assets/B.txt has the guid"));

        [Test]
        public void A_missing_script_names_its_object() =>
            Assert.That(Temporary().Scene("  size: 1\n", Missing).Fault(),
            Does.Contain("the script of a component on 'Tank' refers to an asset with guid " + Missing));

        [Test]
        public void A_script_without_its_class_names_file_and_assemblies() =>
            Assert.That(Temporary().Write("Assets/Scripts/Gone.cs", "", "e0000000000000000000000000000002")
            .Scene("", "e0000000000000000000000000000002").Fault(),
                Does.Contain("Assets/Scripts/Gone.cs has no MonoBehaviour or ScriptableObject named Gone in the loaded assemblies (Engine.Tests)"));

        [Test]
        public void An_asset_class_on_an_object_is_refused() =>
            Assert.That(Temporary().Scene("", TemporaryProject.RecipeGuid).Fault(), Does.Contain("is Recipe, which is no MonoBehaviour"));

        [TestCase("  size: big\n", "Assets/Main.unity(20): 'big' is not a number, as Part on 'Tank', field size (Single) needs it")]
        [TestCase("  size: {x: 1}\n", "field size is of type Single, but the file has a group of fields")]
        [TestCase("  counts: 0102\n", "field counts is of type List`1, but the file has the value '0102'")]
        [TestCase("  nozzles:\n  - radius: 1\n  - radius: wide\n",
            "Assets/Main.unity(22): 'wide' is not a number, as Part on 'Tank', field nozzles[1].radius (Single) needs it")]
        [TestCase("  partner: 5\n", "field partner is of type Part, but the file has the value '5'")]
        public void A_value_that_does_not_fit_names_its_field(string fields, string expected)
            => Assert.That(Temporary().Scene(fields).Fault(), Does.Contain(expected));

        [Test]
        public void A_prefab_that_is_gone_names_its_instance()
        {
            var instance = $"--- !u!1001 &50\nPrefabInstance:\n  m_Modification:\n    m_TransformParent: {{fileID: 0}}\n    " +
                $"m_Modifications: []\n  m_SourcePrefab: {{fileID: 100100000, guid: {Missing}, type: 3}}\n";
            Assert.That(Temporary().Scene("  size: 1\n" + instance).Fault(),
                Does.StartWith("Assets/Main.unity(26): the prefab instance 50 refers to an asset with guid " + Missing));
        }

        [Test]
        public void A_prefab_that_contains_itself_is_refused()
        {
            var prefab = TemporaryProject.SceneText("  size: 1\n") + "--- !u!1001 &50\nPrefabInstance:\n  m_Modification:\n    " +
                "m_TransformParent: {fileID: 11}\n    m_Modifications: []\n  m_SourcePrefab: {fileID: 100100000, guid: " +
                "e0000000000000000000000000000003, type: 3}\n";
            var project = Temporary().Write("Assets/Loop.prefab", prefab, "e0000000000000000000000000000003").Open();
            Assert.That(Assert.Throws<AssetException>(() => project.LoadAtPath<GameObject>("Assets/Loop.prefab")).Message,
                Does.Contain("Assets/Loop.prefab contains itself"));
        }

        [Test]
        public void A_built_in_asset_that_the_host_lacks_is_a_warning()
        {
            var project = Temporary().Scene("  partner: {fileID: 10101, guid: 0000000000000000f000000000000000, type: 0}\n").Open();
            UnityEngine.SceneManagement.SceneManager.LoadNow("Main", UnityEngine.SceneManagement.LoadSceneMode.Single);
            Assert.That(project.Warnings.Single(), Does.Contain("Unity's built-in object 10101, which the host does not have"));
        }

        [Test]
        public void A_script_of_Unitys_own_packages_is_left_out_with_a_warning()
        {
            var project = Temporary().Scene("  m_Version: 2\n", "a79441f348de89743a2939f4d699eac1").Open();
            var scene = UnityEngine.SceneManagement.SceneManager.LoadNow("Main", UnityEngine.SceneManagement.LoadSceneMode.Single);
            Assert.That(scene.GetRootGameObjects().Single().GetComponents<MonoBehaviour>(), Is.Empty);
            Assert.That(project.Warnings.Single(), Does.Contain("Universal Render Pipeline, camera data"));
        }

        [Test]
        public void A_script_inside_of_Unity_is_left_out_with_a_warning()
        {
            var project = Temporary().Write("Assets/Main.unity",
                TemporaryProject.SceneText("").Replace("fileID: 11500000, guid: " + TemporaryProject.PartGuid,
                "fileID: 19102, guid: 0000000000000000e000000000000000"), null).Open();
            UnityEngine.SceneManagement.SceneManager.LoadNow("Main", UnityEngine.SceneManagement.LoadSceneMode.Single);
            Assert.That(project.Warnings.Single(), Does.Contain("no script 19102 of Unity's own modules"));
        }

        [Test]
        public void A_scene_that_does_not_exist_is_invalid()
        {
            LogAssert.Expect(LogType.Error, new System.Text.RegularExpressions.Regex("Scene 'Nowhere' couldn't be loaded"));
            Temporary().Scene("").Open();
            Assert.That(UnityEngine.SceneManagement.SceneManager.LoadNow("Nowhere", UnityEngine.SceneManagement.LoadSceneMode.Single)
                .IsValid(), Is.False);
        }
    }
}
