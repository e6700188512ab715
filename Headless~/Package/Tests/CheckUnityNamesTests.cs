using Host.Check;
using Host.Check.Api;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>The rules about names that Unity's classes have already, and about methods that Unity calls by name.</summary>
    public class CheckUnityNamesTests
    {
        const string Unity = @"using System.Collections; namespace UnityEngine { public class Object { } public class Component : Object { }
            public class MonoBehaviour : Component { } public class ScriptableObject : Object { } public class Collider { } public struct Bounds { }
            public class GameObject { } public struct Rect { } }
            namespace UnityEditor { public class Editor : UnityEngine.ScriptableObject { public virtual void OnInspectorGUI() { } public virtual bool HasPreviewGUI() => false; }
            public class EditorWindow : UnityEngine.ScriptableObject { } public class AssetPostprocessor { } public class AssetModificationProcessor { } }";

        static readonly string[] Planted = { "Rill" };

        PlantedAssemblies planted;

        [SetUp]
        public void MakeFolder() => planted = new PlantedAssemblies();

        [TearDown]
        public void RemoveFolder() => planted.Dispose();

        void Compile(string package)
        {
            planted.Compile("UnityEngine", Unity);
            planted.Compile("Rill", "using System.Collections; using UnityEngine; using UnityEditor; " + package);
        }

        [TestCase("class X : MonoBehaviour { Collider collider; }", "X.collider", "UnityEngine.Component.collider", "obsolete",
            TestName = "A_private_field_that_hides_an_obsolete_property_is_named")]
        [TestCase("class X : MonoBehaviour { static int runInEditMode; }", "X.runInEditMode", "UnityEngine.MonoBehaviour.runInEditMode", "2022.3",
            TestName = "A_static_that_hides_an_inherited_property_is_named")]
        [TestCase("class X : ScriptableObject { string name { get; } }", "X.name", "UnityEngine.Object.name", "rename it",
            TestName = "A_property_that_hides_the_name_is_named")]
        [TestCase("class X : ScriptableObject { class hideFlags { } }", "X.hideFlags", "UnityEngine.Object.hideFlags", "rename it",
            TestName = "A_nested_type_that_hides_a_member_is_named")]
        [TestCase("class X : MonoBehaviour { void CancelInvoke() { } }", "X.CancelInvoke", "void CancelInvoke()", "rename it",
            TestName = "A_method_with_the_parameters_of_an_inherited_one_is_named")]
        [TestCase("class X : MonoBehaviour { int StopAllCoroutines; }", "X.StopAllCoroutines", "StopAllCoroutines()", "rename it",
            TestName = "A_field_that_hides_a_method_is_named")]
        [TestCase("class X : MonoBehaviour { event System.Action rigidbody; }", "X.rigidbody", "UnityEngine.Component.rigidbody", "obsolete",
            TestName = "An_event_that_hides_a_property_is_named_once")]
        [TestCase("class Part : MonoBehaviour { } class X : Part { int tag; }", "X.tag", "UnityEngine.Component.tag", "rename it",
            TestName = "What_a_class_of_the_package_inherits_counts")]
        [TestCase("class X : Editor { object serializedObject; }", "X.serializedObject", "UnityEditor.Editor.serializedObject", "rename it",
            TestName = "A_field_of_an_inspector_is_named")]
        public void A_hidden_member_is_named(string package, string member, string hidden, string more)
        {
            Compile(package);
            Findings findings = planted.Examine(new HiddenMembersRule(Planted));
            Assert.That(findings.Faults, Has.Some.Contains("Rill.dll: " + member + " hides").And.Contains(hidden).And.Contains(more));
            // The field that the compiler makes behind an event is of the same name.
            Assert.That(findings.Faults, Has.All.Contains(member));
        }

        [Test]
        public void What_hides_nothing_is_no_fault()
        {
            Compile(@"class X : Editor { int colliders; class Collision { } void Repaint(int times) { } public override void OnInspectorGUI() { } public override bool HasPreviewGUI() => true; }
                class Plain { Collider collider; string name; } struct S { int tag; } interface I { string name { get; } } enum E { name }
                class Y : MonoBehaviour, I { string I.name => null; void GetComponent(string a, int b) { } }");
            Findings findings = planted.Examine(new HiddenMembersRule(Planted));
            Assert.That(findings.Faults, Is.Empty);
            Assert.That(findings.Looked, Does.Contain("2 classes"));
        }

        [TestCase("class X : MonoBehaviour { static void Reset() { } }", "X.Reset", "not its form", TestName = "A_static_message_is_named")]
        [TestCase("class X : MonoBehaviour { public static void Update(int step) { } }", "X.Update", "not its form",
            TestName = "A_static_method_with_other_parameters_is_named_too")]
        [TestCase("class X : MonoBehaviour { void Awake(int when) { } }", "X.Awake", "void Awake()", TestName = "A_message_with_a_parameter_too_many_is_named")]
        [TestCase("class X : MonoBehaviour { void OnTriggerEnter(GameObject other) { } }", "X.OnTriggerEnter", "UnityEngine.Collider",
            TestName = "A_message_with_a_wrong_parameter_is_named")]
        [TestCase("class X : MonoBehaviour { int OnDestroy() => 0; }", "X.OnDestroy", "void OnDestroy()", TestName = "A_message_that_returns_something_is_named")]
        [TestCase("class X : MonoBehaviour { IEnumerator OnEnable() => null; }", "X.OnEnable", "void OnEnable()",
            TestName = "A_message_that_cannot_be_a_coroutine_is_named")]
        [TestCase("class X : MonoBehaviour { void OnValidate<T>() { } }", "X.OnValidate", "not its form", TestName = "A_generic_message_is_named")]
        [TestCase("class X : ScriptableObject { void Update() { } }", "X.Update", "UnityEngine.MonoBehaviour alone",
            TestName = "A_message_on_a_class_that_does_not_receive_it_is_named")]
        [TestCase("class X : MonoBehaviour { void OnSceneGUI() { } }", "X.OnSceneGUI", "UnityEditor.Editor alone",
            TestName = "A_message_of_the_Editor_on_a_component_is_named")]
        [TestCase("class X : Editor { void HasFrameBounds() { } }", "X.HasFrameBounds", "bool HasFrameBounds()", TestName = "A_message_of_an_inspector_is_held")]
        [TestCase("class X : EditorWindow { static void CreateGUI() { } }", "X.CreateGUI", "not its form", TestName = "A_message_of_a_window_is_held")]
        [TestCase("class X : AssetPostprocessor { void OnPostprocessAllAssets(string[] a, string[] b, string[] c, string[] d) { } }",
            "X.OnPostprocessAllAssets", "static void", TestName = "A_static_message_of_imports_is_held")]
        [TestCase("abstract class P : Editor { bool HasFrameBounds() => true; } class X : P { }", "P.HasFrameBounds", "make it protected",
            TestName = "A_private_message_of_a_base_of_inspectors_is_named")]
        [TestCase("class Part : MonoBehaviour { void OnEnable() { } } class X : Part { void OnEnable() { } }", "X.OnEnable", "hides the message of Part",
            TestName = "A_message_that_hides_that_of_its_base_is_named")]
        public void A_message_without_its_form_is_named(string package, string member, string why)
        {
            Compile(package);
            planted.Catches(new MessagesRule(Planted), "Rill.dll: " + member, why);
        }

        [Test]
        public void Messages_in_their_form_and_methods_of_other_classes_are_no_fault()
        {
            Compile(@"class X : MonoBehaviour { void Awake() { } IEnumerator Start() => null; void OnTriggerEnter() { } void OnTriggerStay(Collider other) { }
                    void OnAudioFilterRead(float[] data, int channels) { } protected virtual void OnDisable() { } }
                class Y : X { protected override void OnDisable() { } void Updates() { } }
                class Z : Editor { void OnSceneGUI() { } bool HasFrameBounds() => true; Bounds OnGetFrameBounds() => default; void OnEnable() { } }
                class W : EditorWindow { void Update() { } void ShowButton(Rect r) { } }
                class P : AssetPostprocessor { void OnPreprocessModel() { }
                    static void OnPostprocessAllAssets(string[] a, string[] b, string[] c, string[] d, bool reloaded) { } }
                class M : AssetModificationProcessor { static string[] OnWillSaveAssets(string[] paths) => paths; }
                class S : ScriptableObject { public void Update(int step) { } public void LateUpdate() { } } class Plain { static void Reset() { } int Awake() => 0; }");
            Assert.That(planted.Examine(new MessagesRule(Planted)).Faults, Is.Empty);
        }
    }
}
