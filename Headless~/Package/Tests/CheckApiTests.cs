using System.IO;
using System.Linq;
using Host.Check;
using Host.Check.Api;
using Host.UnityApi;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>The rules about what the package uses see what Unity or .NET Standard lacks, and only that.</summary>
    public class CheckApiTests
    {
        static readonly string[] JustRill = { "Rill" };

        PlantedAssemblies planted;

        [SetUp]
        public void MakeFolder() => planted = new PlantedAssemblies();

        [TearDown]
        public void RemoveFolder() => planted.Dispose();

        Rule Members(string unity, string package)
        {
            planted.Compile("UnityEngine", "using System; namespace UnityEngine { " + unity + " }");
            planted.Compile("Rill", "using System; using UnityEngine; " + package);
            return new UnityMembersRule(JustRill);
        }

        [Test]
        public void Members_that_every_version_has_are_no_fault()
        {
            Rule rule = Members(
                @"public class Object { public string name { get; set; } public static void Destroy(Object obj) { } public static T Instantiate<T>(T original, Transform parent) => original; }
                  public class Transform : Object { } public struct Vector3 { public float x;
                      public static Vector3 operator *(Vector3 a, float d) => a; public static Vector3 zero => default;
                      public void Scale(Vector3 scale) { } }
                  public class Event { public delegate void Call(); } public class AudioClip {
                      public delegate void PCMReaderCallback(float[] data); } public class ComputeBuffer
                      : IDisposable { public ComputeBuffer(int count, int stride) { } public void Dispose() { } }
                  public class Collider { } public static class Physics { public static int OverlapSphereNonAlloc(Vector3 position, float radius, Collider[] results) => 0; }",
                @"class Uses : UnityEngine.Object { float f(UnityEngine.Object o, AudioClip.PCMReaderCallback c) { o.name += ""x""; Destroy(Instantiate(this, new Transform())); Vector3 v = Vector3.zero * 2; v.Scale(v); c(null); new ComputeBuffer(1, 4).Dispose(); return v.x + Physics.OverlapSphereNonAlloc(v, 1, null); } }");
            Findings findings = planted.Examine(rule);
            Assert.That(findings.Faults, Is.Empty);
            Assert.That(findings.Looked, Does.Contain("8 types").And.Contain("14 members").And.Contain("2022.3").And.Contain(
                "6000.0").And.Contain("6000.3"));
        }

        [Test]
        public void An_override_in_a_generic_type_is_found_with_the_type_s_arguments()
        {
            Rule rule = Members("public class Object { } } namespace UnityEditor.AnimatedValues { public abstract class " +
                "BaseAnimValue<T> { protected BaseAnimValue(T value) { } protected abstract T GetValue(); }",
                "class X : UnityEditor.AnimatedValues.BaseAnimValue<float> { X() : base(1) { } protected override float GetValue() => 0; }");
            Assert.That(planted.Examine(rule).Faults, Is.Empty);
        }

        [TestCase("public class GameObject { public void Explode() { } }", "class X { void f(GameObject g) => g.Explode(); }",
            "UnityEngine.GameObject.Explode()", "Unity 2022.3, 6000.0, 6000.3 has no such member; first used in X.f",
            TestName = "A_member_that_no_version_has_is_named")]
        [TestCase("public class Gadget { }", "class X { Gadget f() => new Gadget(); }", "UnityEngine.Gadget", "has no such type",
            TestName = "A_type_that_no_version_has_is_named")]
        [TestCase("public class GameObject { public void SetActive(int value) { } }", "class X { void f(GameObject g) => g.SetActive(1); }",
            "SetActive(int)", "void SetActive(bool value)", TestName = "A_wrong_parameter_type_is_named_with_the_right_one")]
        [TestCase("public class GameObject { public bool SetActive(bool value) => value; }",
            "class X { void f(GameObject g) => g.SetActive(true); }", "SetActive(bool) : bool", "void SetActive(bool value)",
            TestName = "A_wrong_return_type_is_named")]
        [TestCase("public class Mathf { public bool Approximately(float a, float b) => true; }",
            "class X { void f(Mathf m) => m.Approximately(1, 2); }", "Mathf.Approximately(float, float)", "static bool Approximately",
            TestName = "An_instance_member_that_is_static_in_Unity_is_named")]
        [TestCase("public struct Vector3 { public static void OrthoNormalize(Vector3 normal, Vector3 tangent) { } }",
            "class X { void f(Vector3 v) => Vector3.OrthoNormalize(v, v); }", "OrthoNormalize", "ref Vector3",
            TestName = "A_parameter_that_is_passed_by_reference_in_Unity_is_named")]
        [TestCase("public class GameObject { public bool activeSelf { get; set; } }",
            "class X { void f(GameObject g) => g.activeSelf = true; }", "set_activeSelf(bool)", "bool activeSelf { get }",
            TestName = "A_setter_that_Unity_lacks_is_named")]
        [TestCase("public class GameObject { public bool activeSelf; }", "class X { bool f(GameObject g) => g.activeSelf; }",
            "activeSelf (bool)", "bool activeSelf { get }", TestName = "A_field_that_is_a_property_in_Unity_is_named")]
        [TestCase("public class ComputeBuffer { }", "class X { void f() => new ComputeBuffer(); }", "ComputeBuffer..ctor()",
            ".ctor(int count, int stride)", TestName = "A_constructor_that_Unity_lacks_is_named")]
        [TestCase("public class GameObject { public bool active { get; set; } }", "class X { bool f(GameObject g) => g.active; }",
            "get_active()", "Unity 2022.3, 6000.0, 6000.3 has it as obsolete", TestName = "An_obsolete_member_is_named")]
        [TestCase("public struct Vector3 { } public class Rigidbody { public Vector3 linearVelocity { get; set; } }",
            "class X { Vector3 f(Rigidbody r) => r.linearVelocity; }", "get_linearVelocity()", "Unity 2022.3 has no such member",
            TestName = "A_member_that_only_later_versions_have_is_named")]
        [TestCase("public struct Vector3 { } public class Rigidbody { public Vector3 velocity { get; set; } }",
            "class X { Vector3 f(Rigidbody r) => r.velocity; }", "get_velocity()", "Unity 6000.0, 6000.3 has it as obsolete",
            TestName = "A_member_that_became_obsolete_is_named")]
        [TestCase("public class ScriptableObject { protected virtual void Awaken() { } }",
            "class X : ScriptableObject { protected override void Awaken() { } }", "override UnityEngine.ScriptableObject.Awaken()", "in X",
            TestName = "An_override_of_what_Unity_lacks_is_named")]
        [TestCase("public class GameObject { public virtual void SetActive(bool value) { } }",
            "class X : GameObject { public override void SetActive(bool value) { } }", "override UnityEngine.GameObject.SetActive(bool)",
            "not as virtual", TestName = "An_override_of_what_is_not_virtual_in_Unity_is_named")]
        [TestCase("public class CustomYieldInstruction { }", "class X : CustomYieldInstruction { }", "X",
            "CustomYieldInstruction: abstract bool keepWaiting", TestName = "An_abstract_member_without_override_is_named")]
        [TestCase("public interface ISerializationCallbackReceiver { void OnBeforeSerialize(); }",
            "class X : ISerializationCallbackReceiver { public void OnBeforeSerialize() { } }", "X", "void OnAfterDeserialize()",
            TestName = "A_member_of_an_interface_that_is_not_implemented_is_named")]
        [TestCase("public class CreateAssetMenuAttribute : Attribute { public string color { get; set; } }",
            "[CreateAssetMenu(color = \"red\")] class X { }", "CreateAssetMenuAttribute.set_color(string)", "has no such member",
            TestName = "An_attribute_s_argument_that_Unity_lacks_is_named")]
        public void A_fault_of_the_package_is_named(string unity, string package, string what, string why)
            => planted.Catches(Members(unity, package), "Rill.dll: ", what, why);

        [TestCase("class X { float f(float x) => math.square(x); }", "Unity.Mathematics.math.square(float)")]
        [TestCase("class X { AffineTransform f; }", "Unity.Mathematics.AffineTransform")]
        public void What_the_lowest_Mathematics_lacks_is_named(string package, string what)
        {
            planted.Compile("Unity.Mathematics", "namespace Unity.Mathematics { public struct AffineTransform { } public static class math { " +
                "public static float square(float x) => x * x; public static float abs(float x) => x; } }");
            planted.Compile("Rill", "using Unity.Mathematics; class Y { float f(float x) => math.abs(x); } " + package);
            planted.Catches(new UnityMembersRule(JustRill), "Rill.dll: " + what, "Unity 2022.3 with Unity.Mathematics 1.2.6 has no such");
        }

        [Test]
        public void A_constant_that_the_lowest_Mathematics_lacks_is_named()
        {
            foreach (string name in PackageAssemblies.StandIns.Append("nunit.framework").Where(name => name != "Unity.Mathematics"))
                planted.Bring(name);
            planted.Compile("Unity.Mathematics", "namespace Unity.Mathematics { public static class math { public const float PI2 = 6f; } }");
            planted.Write("Runtime/Planted.cs", "class X { float f = Unity.Mathematics.math.PI2; }");
            planted.Catches(new SourceNamesRule(), "Runtime/Planted.cs:1", "math.PI2", "Unity.Mathematics 1.2.6");
        }

        [Test]
        public void Another_lowest_Mathematics_than_the_one_compared_is_named()
        {
            planted.Compile("Rill", "class X { }");
            planted.Write("package.json", "{ \"name\": \"com.x.y\", \"dependencies\": { \"com.unity.mathematics\": \"1.1.0\" } }");
            planted.Catches(new UnityMembersRule(JustRill), "com.unity.mathematics 1.1.0", "1.2.6");
        }

        [Test]
        public void An_assembly_that_is_not_there_is_named() => planted.Catches(new UnityMembersRule(JustRill), "Rill.dll is not in", "rill");

        [TestCase("void Broken((int a)", "void Broken((int a)")]
        [TestCase("operator ?(Thing a, Thing b) : bool", "unknown operator '?'")]
        [TestCase("int x { fetch }", "unknown accessor 'fetch'")]
        [TestCase("void Late(int a, // the first int b)", "comment")]
        [TestCase("int x y", "one word too many")]
        public void A_line_of_the_lists_that_cannot_be_read_is_named(string signature, string why)
        {
            UnityApiLists lists = UnityApiLists.Read(new StringReader("unity-api 1 unity-2022.3\nUnityEngine.Thing\n\t1\tclass\n\t1\t"
                + signature + "\n"));
            planted.Catches(new UnityMembersRule(new string[0], () => UnityCatalogs.Make(lists)), "UnityEngine.Thing | " + signature, why,
                "SignatureParser");
        }

        [TestCase("unity-ipa 1 unity-2022.3", "unity-ipa")]
        [TestCase("unity-api 1 unity-2022.3\n\t1\tclass", "Line 2")]
        [TestCase("unity-api 1 unity-2022.3\nUnityEngine.Thing\n\t2\tclass", "Line 3")]
        [TestCase("unity-api 1 unity-2022.3\nUnityEngine.Thing\n\tclass", "Line 3")]
        public void A_damaged_file_of_lists_is_refused(string text, string where)
            => Assert.That(() => UnityApiLists.Read(new StringReader(text)),
            Throws.InstanceOf<InvalidDataException>().With.Message.Contains(where));

        [Test]
        public void The_lists_hold_all_versions_and_lend_UIElements_to_the_oldest()
        {
            UnityApiLists lists = UnityApiLists.Load();
            Assert.That(lists.Versions, Is.EqualTo(new[] { "2022.3", "6000.0", "6000.3" }));
            Assert.That(lists.In("2022.3").Any(line => line.Type == "UnityEngine.UIElements.VisualElement" && line.Signature.StartsWith("class")));
            ApiLine velocity = lists.Lines.Single(line => line.Type == "UnityEngine.Rigidbody"
                && line.Signature.EndsWith(" linearVelocity { get set }"));
            Assert.That(lists.Name(velocity.Versions), Is.EqualTo("6000.0, 6000.3"));
        }

        [Test]
        public void A_type_of_NET_that_the_standard_lacks_is_named()
        {
            planted.Compile("Rill.Tests", "class X { object f() => System.Random.Shared; int g() => System.Math.Clamp(1, 2, 3); System.Half h; }");
            string[] faults = planted.Examine(new NetStandardRule(new[] { "Rill.Tests" })).Faults.Where(fault =>
                fault.StartsWith("Rill.Tests.dll")).ToArray();
            Assert.That(faults, Has.Length.EqualTo(2), string.Join("\n", faults));
            Assert.That(faults, Has.Some.Contains("System.Half: netstandard 2.1 has no such type"));
            Assert.That(faults, Has.Some.Contains("System.Random.get_Shared() : System.Random: netstandard 2.1 has no such member"));
        }

        [Test]
        public void A_reference_of_the_package_to_another_assembly_is_named()
        {
            planted.Compile("Newtonsoft.Json", "public class JsonConvert { }");
            planted.Compile("Rill", "class X : JsonConvert { }");
            Assert.That(planted.Examine(new NetStandardRule(JustRill)).Faults, Has.Some.Contains("Rill.dll references Newtonsoft.Json.dll"));
        }

        [Test]
        public void A_newer_language_version_is_named()
        {
            using (var copy = new PackageCopy())
                copy.Catches(new NetStandardRule(),
                    () => copy.Replace("Headless~/Package/Rill/Rill.csproj", "<LangVersion>9<", "<LangVersion>latest<"),
                    "Headless~/Package/Rill/Rill.csproj", "C# latest", "<LangVersion>9</LangVersion>");
        }

        [TestCase("NUnit.Framework.Assert.Multiple(() => { });", "NUnit.Framework.Assert.Multiple(NUnit.Framework.TestDelegate)")]
        [TestCase("NUnit.Framework.Warn.If(true);", "NUnit.Framework.Warn")]
        public void What_came_with_NUnit_3_6_is_named(string code, string what)
        {
            planted.Bring("nunit.framework");
            planted.Compile("Rill.Tests", "class X { void f() { NUnit.Framework.Assert.That(true); " + code + " } }");
            planted.Catches(new NUnitRule(new[] { "Rill.Tests" }), "Rill.Tests.dll uses ", what, "3.6 brought it");
        }

        void Sources(string unity, string source)
        {
            planted.Compile("UnityEngine", "namespace UnityEngine { " + unity + " }");
            foreach (string name in PackageAssemblies.StandIns.Skip(1).Append("nunit.framework"))
                planted.Bring(name);
            planted.Write("Runtime/Planted.cs", "using UnityEngine;\n" + source);
        }

        [TestCase("public enum HideFlags { None, HideInNowhere }", "class X { HideFlags f = HideFlags.HideInNowhere; }",
            "UnityEngine.HideFlags.HideInNowhere", "has no such member", TestName = "A_value_of_an_enum_that_Unity_lacks_is_named")]
        [TestCase("public enum HideFlags { None, HideInNowhere }",
            "class X { bool f(HideFlags h) => h switch { HideFlags.HideInNowhere => true, _ => false }; }",
            "UnityEngine.HideFlags.HideInNowhere", "has no such member", TestName = "A_value_of_an_enum_in_a_pattern_is_seen")]
        [TestCase("public enum Gadget { Whirl }", "class X { int n = (int)Gadget.Whirl; }", "UnityEngine.Gadget.Whirl", "has no such type",
            TestName = "A_value_of_an_enum_that_no_version_has_is_named")]
        [TestCase("public struct Mathf { public const float Tau = 6.28f; }", "class X { float f = Mathf.Tau; }", "UnityEngine.Mathf.Tau",
            "has no such member", TestName = "A_constant_that_Unity_lacks_is_named")]
        [TestCase("public class Object { public static void Destroy(Object obj, float delay) { } }",
            "class X { void f() => Object.Destroy(null,\ndelay: 1); }", "Destroy(delay:)", "(static void Destroy(Object obj, float t))",
            TestName = "An_argument_whose_name_Unity_lacks_is_named")]
        public void A_fault_in_the_sources_is_named(string unity, string source, string what, string why)
        {
            Sources(unity, source);
            planted.Catches(new SourceNamesRule(), source.Contains("\n") ? "Runtime/Planted.cs:3" : "Runtime/Planted.cs:2", what, why);
        }

        [Test]
        public void A_branch_that_is_not_compiled_is_named()
        {
            Sources("public class Object { }", "#if UNITY_6000_0_OR_NEWER\nclass X { }\n#endif\n");
            planted.Catches(new SourceNamesRule(), "Runtime/Planted.cs:2", "#if UNITY_6000_0_OR_NEWER", "unexamined");
        }

        [TestCase("class X { Object f() => Object.FindObjectOfType<Object>(); }", "FindObjectOfType<>()", "6000.0, 6000.3 has it as obsolete",
            TestName = "A_member_that_became_obsolete_is_named_in_a_sample")]
        [TestCase("#if UNITY_EDITOR\nclass X { Object f() => Object.FindObjectOfType<Object>(); }\n#endif", "FindObjectOfType<>()", "obsolete",
            TestName = "A_branch_of_a_sample_for_the_editor_is_seen")]
        [TestCase("#if !ENABLE_LEGACY_INPUT_MANAGER\nclass X { HideFlags f = HideFlags.HideInNowhere; }\n#endif", "HideFlags.HideInNowhere",
            "has no such member", TestName = "A_branch_of_a_sample_without_the_old_input_is_seen")]
        [TestCase("#if UNITY_ANDROID\nclass X { }\n#endif", "Samples~/Game/Tests/Planted.cs:2", "#if UNITY_ANDROID",
            TestName = "A_branch_of_a_sample_that_is_not_compiled_is_named")]
        [TestCase("record struct X(int Y);", "Samples~/Game/Tests/Planted.cs:2", "10.0", TestName = "A_sample_in_a_newer_language_is_named")]
        public void A_fault_of_a_sample_is_named(string source, string what, string why)
        {
            planted.Compile("UnityEngine", "namespace UnityEngine { public enum HideFlags { None, HideInNowhere } " +
                "public class Object { public static T FindObjectOfType<T>() => default; public static T FindAnyObjectByType<T>() => default; } }");
            planted.Write("Samples~/Game/Good.cs", "class Good { UnityEngine.Object f() => " +
                "UnityEngine.Object.FindAnyObjectByType<UnityEngine.Object>(); }");
            Assert.That(planted.Examine(new SampleScriptsRule()).Faults, Is.Empty);
            planted.Write("Samples~/Game/Tests/Planted.cs", "using UnityEngine;\n" + source);
            planted.Catches(new SampleScriptsRule(), what, why);
        }

        const string Game = "Samples~/Key in a Well/Rill.Samples.KeyInAWell.asmdef",
            GameTests = "Samples~/Key in a Well/Tests/Rill.Samples.KeyInAWell.Tests.asmdef";

        [TestCase(Game, "    \"defineConstraints\": [\n        \"RILL_PHYSICS\"\n    ]", "    \"defineConstraints\": []", "refers to Rill.Physics",
            "com.unity.modules.physics", TestName = "A_sample_that_does_not_ask_for_a_module_is_named")]
        [TestCase(GameTests, "com.unity.test-framework", "com.unity.other", "refers to nunit.framework.dll", "com.unity.test-framework",
            TestName = "A_sample_s_tests_that_do_not_ask_for_the_framework_are_named")]
        [TestCase(GameTests, "        \"UNITY_INCLUDE_TESTS\",\n", "", "refers to Rill.Testing", "players lack",
            TestName = "A_sample_s_tests_that_players_would_compile_are_named")]
        [TestCase(Game, "com.unity.inputsystem", "com.unity.other", "refers to Unity.InputSystem", "no version define",
            TestName = "A_sample_that_does_not_ask_for_a_package_is_named")]
        [TestCase(Game, "\"Rill.Physics\",", "\"Gadgets\", \"Rill.Physics\",", "refers to Gadgets", "nothing is known",
            TestName = "A_sample_that_refers_to_what_is_not_known_is_named")]
        [TestCase("Samples~/Key in a Well/WellKeyboard.cs", "keys?.spaceKey", "keys?.spacebarKey", "WellKeyboard.cs:37", "spacebarKey",
            TestName = "A_branch_of_a_sample_that_does_not_compile_is_named")]
        public void A_fault_in_how_a_sample_is_compiled_is_named(string file, string text, string with, string what, string why)
        {
            using (var copy = new PackageCopy())
                copy.Catches(new SampleScriptsRule(), () => copy.Replace(file, text, with), what, why);
        }

        [Test]
        public void A_loose_script_of_a_sample_that_needs_a_module_is_named()
        {
            using (var copy = new PackageCopy())
                copy.Catches(new SampleScriptsRule(), () => copy["Samples~/Column/Push.cs"] = "using UnityEngine; " +
                    "public sealed class Push : MonoBehaviour { public Rigidbody body; void Start() => body.AddForce(Vector3.up); }",
                    "Samples~/Column/Push.cs", "com.unity.modules.physics", "Give the scripts an .asmdef");
        }

        [Test]
        public void A_constant_of_what_is_not_known_is_named()
        {
            Sources("public enum HideFlags { None }", "class X { object n = Nothing.None; }");
            planted.Catches(new SourceNamesRule(), "Runtime/Planted.cs:2", "Nothing.None", "does not compile");
        }
    }
}
