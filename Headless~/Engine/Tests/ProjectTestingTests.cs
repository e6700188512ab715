using System;
using System.IO;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>The tests of a user's project are found, run and counted, and obstacles are named.</summary>
    public class ProjectTestingTests
    {
        const string TestDefinition = @"{ ""name"": ""Game.Tests"", ""references"": [""Game"", ""UnityEngine.TestRunner"", ""UnityEditor.TestRunner""], ""overrideReferences"": true,
            ""precompiledReferences"": [""nunit.framework.dll""], ""autoReferenced"": false, ""defineConstraints"": [""UNITY_INCLUDE_TESTS""] }";

        const string Tests = @"
using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

public class LampTests
{
    [UnityTest] public IEnumerator A_lamp_gets_brighter()
    {
        var lamp = new GameObject().AddComponent<Lamp>();
        yield return null;
        yield return null;
        Assert.That(lamp.Brightness, Is.GreaterThan(1));
    }

    [Test] public void A_lamp_is_dark_at_first() => Assert.That(new GameObject().AddComponent<Lamp>().Brightness, Is.EqualTo(0));
    [TestCase(1), TestCase(2)] public void Lamps_shine_in_the_editor(int lamps) => Assert.That(Lamp.IsEditor);
    [Test] public void A_lamp_never_fails() { Debug.LogError(""the lamp broke""); }
}";

        const string Lamp = @"
using UnityEngine;
public class Lamp : MonoBehaviour
{
    public int Brightness;
    void Update() => Brightness++;
#if UNITY_EDITOR
    public static bool IsEditor => UnityEditor.EditorApplication.isCompiling == false;
#else
    public static bool IsEditor => false;
#endif
}";

        string root;
        int files;

        [SetUp]
        public void StartProject()
        {
            root = Path.Combine(Path.GetTempPath(), "rill-tested-" + Guid.NewGuid().ToString("N"));
            Directory.CreateDirectory(Path.Combine(root, "ProjectSettings"));
            Manifest(@"""com.unity.test-framework"": ""1.1.33""");
            Write("Assets/Scripts/Game.asmdef", @"{ ""name"": ""Game"" }");
            Write("Assets/Scripts/Lamp.cs", Lamp);
            Write("Assets/Tests/Game.Tests.asmdef", TestDefinition);
            Write("Assets/Tests/LampTests.cs", Tests);
        }

        [TearDown]
        public void RemoveProject() => Directory.Delete(root, true);

        void Manifest(string dependencies, string more = "")
        {
            Directory.CreateDirectory(Path.Combine(root, "Packages"));
            File.WriteAllText(Path.Combine(root, "Packages", "manifest.json"), $"{{ \"dependencies\": {{ {dependencies} }}{more} }}");
        }

        void Write(string path, string text)
        {
            string file = Path.Combine(root, path);
            Directory.CreateDirectory(Path.GetDirectoryName(file));
            File.WriteAllText(file, text);
            File.WriteAllText(file + ".meta", $"fileFormatVersion: 2\nguid: {++files:x32}\n");
        }

        [Test]
        public void Tests_pass_and_fail_as_in_the_Test_Runner()
        {
            var run = new ProjectRun(root);
            run.MustHaveEnded(1, "Game.Tests: 1 of 1 scripts compiled", "LampTests", "4 passed, 1 FAILED", "FAILED A_lamp_never_fails",
                "Unhandled log message: '[Error] the lamp broke'", "4 passed, 1 failed");
            Assert.That(run.Output[^1], Is.EqualTo("4 passed, 1 failed"));

            new ProjectRun(root, "--filter", "brighter", "--filter", "dark").MustHaveEnded(0, "2 passed, 0 failed");
            new ProjectRun(root, "--list").MustHaveEnded(0, "LampTests.A_lamp_never_fails");
        }

        [Test]
        public void A_filter_that_no_test_passes_is_a_failure() => new ProjectRun(root, "--filter", "no such test").MustHaveEnded(1,
            "FAILED no test ran");

        [Test]
        public void A_folder_that_is_no_project_is_named() => new ProjectRun(Path.Combine(root, "Assets")).MustHaveEnded(2,
            $"{Path.Combine(root, "Assets")} is no Unity project (a folder with Assets and ProjectSettings)");

        [Test]
        public void A_project_without_tests_is_told_how_to_make_some()
        {
            Directory.Delete(Path.Combine(root, "Assets", "Tests"), true);
            new ProjectRun(root).MustHaveEnded(2, $"{root} has no test assembly", "Tests Assembly Folder", "testables");
        }

        [Test]
        public void An_error_of_the_compiler_stops_with_file_and_line()
        {
            Write("Assets/Tests/BrokenTests.cs", "public class BrokenTests\n{\n    int Light() => Lamp.Dazzle;\n}\n");
            new ProjectRun(root).MustHaveEnded(2, "the project's scripts do not compile", "Assets/Tests/BrokenTests.cs(3,25): error CS0117: " +
                "'Lamp' does not contain a definition for 'Dazzle'");
        }

        [Test]
        public void A_package_that_is_not_here_is_named_where_a_script_needs_it()
        {
            Manifest(@"""com.unity.test-framework"": ""1.1.33"", ""com.studio.switches"": ""https://example.com/switches.git""");
            Write("Assets/Scripts/Switch.cs", "public class Switch\n{\n    Studio.Switches.Lever lever;\n}\n");
            new ProjectRun(root).MustHaveEnded(2, "Assets/Scripts/Switch.cs(3,5): error CS0246",
                "packages that are not here: com.studio.switches https://example.com/switches.git", "file:<folder>", "Library/PackageCache");
        }

        [Test]
        public void A_script_of_the_game_that_needs_what_the_host_lacks_is_left_out_and_the_tests_run()
        {
            Write("Assets/Scripts/Mirror.cs", "using UnityEngine;\npublic class Mirror : MonoBehaviour\n{\n    void Start() => " +
                "Camera.main.RenderToCubemap((Cubemap)null);\n}\n");
            new ProjectRun(root, "--filter", "dark").MustHaveEnded(0, "warning: left out: Assets/Scripts/Mirror.cs(4,33): error CS1061",
                "the host does not", "1 passed, 0 failed");
        }

        [Test]
        public void A_test_that_needs_what_the_host_lacks_is_not_passed_over()
        {
            Write("Assets/Tests/MirrorTests.cs", "using UnityEngine;\npublic class MirrorTests\n{\n    void Look() => " +
                "Camera.main.RenderToCubemap((Cubemap)null);\n}\n");
            new ProjectRun(root).MustHaveEnded(2, "Assets/Tests/MirrorTests.cs(4,32): error CS1061", "(Unity 2022.3 has it, the host does not)");
        }

        [TestCase(false, "4 passed, 1 failed")]
        [TestCase(true, "5 passed, 1 failed")]
        public void Tests_of_a_package_elsewhere_run_where_the_manifest_says_so(bool testable, string counts)
        {
            string elsewhere = root + "-package";
            try
            {
                Manifest(@"""com.unity.test-framework"": ""1.1.33"", ""com.studio.lamps"": ""file:" + elsewhere + @"""", testable ? @", ""testables"": [""com.studio.lamps""]" : "");
                Write(elsewhere + "/package.json", @"{ ""name"": ""com.studio.lamps"", ""version"": ""1.0.0"" }");
                Write(elsewhere + "/Tests/Lamps.Tests.asmdef", TestDefinition.Replace("Game.Tests", "Lamps.Tests"));
                Write(elsewhere + "/Tests/PackedTests.cs", "public class PackedTests { [NUnit.Framework.Test] public void One() { } }");
                new ProjectRun(root).MustHaveEnded(1, counts);
            }
            finally
            {
                Directory.Delete(elsewhere, true);
            }
        }

        [TestCase("--project runs the tests of that project alone", "--host-only")]
        [TestCase("the tests of a project run in one process", "--jobs", "2")]
        public void What_does_not_go_with_a_project_is_refused(string message, params string[] more) => new ProjectRun(root, more).MustHaveEnded(2,
            message);
    }
}
