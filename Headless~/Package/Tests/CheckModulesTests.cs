using System.IO;
using Host.Check;
using Host.Check.Api;
using Host.UnityApi;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>The rule about Unity's built-in modules sees one that is in use and not asked for.</summary>
    public class CheckModulesTests
    {
        const string Manifest = "package.json", TestManifest = "TestProject~/Packages/manifest.json";

        [TestCase("\"com.unity.modules.imgui\": \"1.0.0\",", "", "Rill.Editor.dll uses UnityEngine.", "com.unity.modules.imgui",
            "package.json", TestName = "A_module_in_use_that_is_no_dependency_is_named")]
        [TestCase("\"com.unity.modules.jsonserialize\": \"1.0.0\"", "\"com.unity.modules.audio\": \"1.0.0\"",
            "Rill.Editor.dll uses UnityEngine.JsonUtility", "com.unity.modules.jsonserialize", "package.json",
            TestName = "A_module_of_one_type_that_is_no_dependency_is_named")]
        [TestCase("\"com.unity.modules.imgui\": \"1.0.0\",",
            "\"com.unity.modules.imgui\": \"1.0.0\", \"com.unity.modules.audio\": \"1.0.0\",", "com.unity.modules.audio",
            "no assembly uses", "remove it", TestName = "A_module_that_nothing_uses_is_named")]
        public void A_fault_of_the_manifest_is_named(string what, string with, string first, string second, string third)
        {
            using (var copy = new PackageCopy())
                copy.Catches(new ModulesRule(), () => copy.Replace(Manifest, what, with), first, second, third);
        }

        [Test]
        public void An_optional_module_needs_its_define_to_be_a_constraint()
        {
            using (var copy = new PackageCopy())
                copy.Catches(new ModulesRule(),
                    () => copy.Replace("Runtime/Physics/Rill.Physics.asmdef", "\"defineConstraints\": [\n        \"RILL_PHYSICS\"\n    ]",
                    "\"defineConstraints\": []"),
                    "Rill.Physics.dll uses UnityEngine.", "com.unity.modules.physics", "define constraint");
        }

        [TestCase("com.unity.modules.terrain", "Rill.Terrain.Tests.dll")]
        [TestCase("com.unity.test-framework", "Rill.Tests.dll")]
        public void What_only_tests_need_is_in_the_test_project(string module, string assembly)
        {
            using (var copy = new PackageCopy())
                copy.Catches(new ModulesRule(), () => copy.Replace(TestManifest, module, "com.unity.other"), assembly, module, TestManifest);
        }

        [Test]
        public void A_test_project_whose_manifest_cannot_be_read_is_named()
        {
            using (var copy = new PackageCopy())
                copy.Catches(new ModulesRule(), () => copy[TestManifest] = "{", TestManifest, "cannot be read");
        }

        [Test]
        public void A_type_whose_module_is_not_known_is_named()
        {
            using (var planted = new PlantedAssemblies())
            {
                planted.Compile("UnityEngine", "namespace UnityEngine { public class Gadget { public class Inner { } } }");
                planted.Compile("Rill", "class X { UnityEngine.Gadget f() => new UnityEngine.Gadget(); UnityEngine.Gadget.Inner g() => " +
                    "new UnityEngine.Gadget.Inner(); }");
                planted.Write(Manifest, "{ \"name\": \"com.x.y\", \"dependencies\": { \"com.x.gadgets\": \"1.0.0\" } }");
                planted.Write(TestManifest, "{ \"dependencies\": {} }");
                var justRill = new[] { "Rill" };
                Assert.That(planted.Examine(new ModulesRule(justRill)).Faults,
                    Has.Some.Contains("Rill.dll uses UnityEngine.Gadget").And.Some.Contains("modules.txt"));
                Assert.That(planted.Examine(new ModulesRule(justRill,
                    () => Read("UnityEngine.GadgetModule com.x.gadgets\n\tUnityEngine.Gadget"))).Faults, Is.Empty,
                    "a nested type is where the one around it is");
                Assert.That(planted.Examine(new ModulesRule(justRill,
                    () => Read("UnityEngine.GadgetModule -\n\tUnityEngine.Gadget"))).Faults, Is.Empty, "a module that is always there");
            }
        }

        [TestCase("UnityEngine.CoreModule", "(1)", "assembly package")]
        [TestCase("\tUnityEngine.Object", "(1)", "below no assembly")]
        [TestCase("A -\n\tUnityEngine.Object\nB -\n\tUnityEngine.Object", "(4)", "below two")]
        public void A_damaged_list_of_modules_is_refused(string text, string where, string why) =>
            Assert.That(() => Read(text), Throws.InstanceOf<InvalidDataException>().With.Message.Contains(where).And.Message.Contains(why));

        static UnityModules Read(string text) => UnityModules.Read(new StringReader(text));
    }
}
