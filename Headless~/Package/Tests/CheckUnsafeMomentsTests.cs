using Host.Check;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>The rule about what Unity may call on another thread follows calls to what needs the main one.</summary>
    public class CheckUnsafeMomentsTests
    {
        const string Unity = @"namespace UnityEngine { public class Object { public string name => null; public static void DestroyImmediate(Object o) { } }
            public class Component : Object { public T GetComponent<T>() => default; } public class MonoBehaviour : Component { public bool enabled; }
            public class ScriptableObject : Object { } public static class Debug { public static void LogWarning(object m) { } }
            public static class Mathf { public static float Clamp01(float x) => x; } public struct Vector3 { public static Vector3 one => default; }
            public static class Resources { public static T Load<T>(string path) => default; } public static class Shader { public static int PropertyToID(string n) => 0; }
            public class GraphicsBuffer { public GraphicsBuffer(int count) { } } public class Material : Object { public Material() { } }
            public interface ISerializationCallbackReceiver { void OnBeforeSerialize(); void OnAfterDeserialize(); } public class AnimationCurve { } }
            namespace UnityEditor { public static class AssetDatabase { public static string GetAssetPath(UnityEngine.Object o) => null; }
            public class Editor : UnityEngine.ScriptableObject { } }";

        static readonly string[] Planted = { "Rill", "Rill.Editor" };

        PlantedAssemblies planted;

        [SetUp]
        public void MakeFolder() => planted = new PlantedAssemblies();

        [TearDown]
        public void RemoveFolder() => planted.Dispose();

        Findings Examine(string package, string editor = "")
        {
            const string usings = "using System; using System.Linq; using System.Collections.Generic; using UnityEngine; ";
            planted.Compile("UnityEngine", Unity);
            planted.Compile("Rill", usings + package);
            planted.Compile("Rill.Editor", usings + "using UnityEditor; " + editor);
            return planted.Examine(new UnsafeMomentsRule(Planted));
        }

        [TestCase("class X : MonoBehaviour { void OnValidate() { var n = name; } }", "X.OnValidate calls UnityEngine.Object.get_name",
            TestName = "OnValidate_that_reads_the_name_is_named")]
        [TestCase("class X : ScriptableObject { void OnValidate() => A(); void A() => B.C(this); } static class B { public static void C(X x) => UnityEngine.Object.DestroyImmediate(x); }",
            "X.OnValidate > X.A > B.C calls UnityEngine.Object.DestroyImmediate", TestName = "The_path_to_a_forbidden_call_is_told")]
        [TestCase("abstract class P : MonoBehaviour { void OnValidate() => Check(); protected abstract void Check(); } class X : P { protected override void Check() => GetComponent<X>(); }",
            "P.OnValidate > X.Check calls UnityEngine.Component.GetComponent", TestName = "Overrides_are_followed")]
        [TestCase("interface I { void Do(); } class Y : I { void I.Do() => Resources.Load<UnityEngine.Object>(\"\"); } class X : MonoBehaviour { I i; void OnValidate() => i.Do(); }",
            "X.OnValidate > Y.I.Do calls UnityEngine.Resources.Load", TestName = "Implementations_of_interfaces_are_followed")]
        [TestCase("class X : MonoBehaviour { Material m = new Material(); }", "X..ctor calls UnityEngine.Material..ctor",
            TestName = "A_field_initializer_is_held")]
        [TestCase("class X : MonoBehaviour { static string s = Resources.Load<string>(\"\"); }", "X..cctor calls UnityEngine.Resources.Load",
            TestName = "A_static_initializer_of_a_component_is_held")]
        [TestCase("class B { public GraphicsBuffer b = new GraphicsBuffer(1); } class X : MonoBehaviour { B b = new B(); }",
            "X..ctor > B..ctor calls UnityEngine.GraphicsBuffer..ctor", TestName = "What_a_constructor_makes_is_followed")]
        [TestCase("class X : ISerializationCallbackReceiver { UnityEngine.Object o; public void OnBeforeSerialize() { var n = o.name; } void ISerializationCallbackReceiver.OnAfterDeserialize() { } }",
            "X.OnBeforeSerialize calls UnityEngine.Object.get_name", TestName = "A_callback_of_serialization_is_held")]
        [TestCase("class X : ISerializationCallbackReceiver { public MonoBehaviour o; public void OnBeforeSerialize() { } void ISerializationCallbackReceiver.OnAfterDeserialize() => o.GetComponent<X>(); }",
            "X.UnityEngine.ISerializationCallbackReceiver.OnAfterDeserialize calls UnityEngine.Component.GetComponent",
            TestName = "An_explicit_callback_of_serialization_is_held")]
        [TestCase("class X : MonoBehaviour { List<X> all; void OnValidate() => all.ForEach(x => x.GetComponent<X>()); }",
            "calls UnityEngine.Component.GetComponent", TestName = "A_delegate_that_is_handed_to_another_s_method_is_followed")]
        public void A_forbidden_call_is_named_with_the_path_to_it(string package, string fault)
            => Assert.That(Examine(package).Faults, Has.Some.StartsWith("Rill.dll: ").And.Contains(fault));

        [Test]
        public void A_delegate_field_reaches_what_another_assembly_assigns_to_it()
        {
            Findings findings = Examine("public static class Hooks { public static Func<UnityEngine.Object, string> Find; } " +
                "class X : MonoBehaviour { void OnValidate() => Hooks.Find?.Invoke(this); }",
                "static class E { static void Install() => Hooks.Find = Of; static string Of(UnityEngine.Object o) => AssetDatabase.GetAssetPath(o); }");
            Assert.That(findings.Faults, Has.Exactly(1).Contains("X.OnValidate > E.Of calls UnityEditor.AssetDatabase.GetAssetPath"));
        }

        [Test]
        public void Arithmetic_logs_and_what_is_called_elsewhere_are_no_fault()
        {
            Findings findings = Examine(@"class X : MonoBehaviour { float x; Vector3 v = Vector3.one; AnimationCurve c = new AnimationCurve(); static int id = Shader.PropertyToID(""_A"");
                    static Func<X, string> later = x => x.name; void OnValidate() { x = Mathf.Clamp01(x); Debug.LogWarning(""a"" + x); }
                    void OnEnable() => GetComponent<X>(); public float Y { set { x = value; Log(); } } void Log() => Debug.LogWarning(name); }
                class Plain { string n = Resources.Load<string>(""""); void OnValidate() => n.ToString(); }", "class E : Editor { void OnEnable() => AssetDatabase.GetAssetPath(this); }");
            Assert.That(findings.Faults, Is.Empty);
        }
    }
}
