using Host.Check.Api;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>The rule about what the host offers sees whatever compiles here and not in Unity.</summary>
    public class CheckHostSurfaceTests
    {
        static readonly string[] JustEngine = { "UnityEngine" };

        PlantedAssemblies planted;

        [SetUp]
        public void MakeFolder() => planted = new PlantedAssemblies();

        [TearDown]
        public void RemoveFolder() => planted.Dispose();

        static HostSurfaceRule Rule(string version = "2022.3") => new HostSurfaceRule(JustEngine, version);

        void Offer(string source) => planted.Compile("UnityEngine", "using System; namespace UnityEngine { " + source + " }");

        [TestCase("public class Object { public void Explode() { } }", "UnityEngine.Object.Explode()", "has no such member",
            TestName = "A_method_that_Unity_lacks_is_named")]
        [TestCase("public class Gadget { }", "UnityEngine.Gadget", "has no such type", TestName = "A_type_that_Unity_lacks_is_named")]
        [TestCase("public class Object { public class Inner { } }", "UnityEngine.Object.Inner", "has no such type",
            TestName = "A_nested_type_that_Unity_lacks_is_named")]
        [TestCase("public class Object { protected int secret; }", "UnityEngine.Object.secret", "has no such member",
            TestName = "A_protected_field_that_Unity_lacks_is_named")]
        [TestCase("public struct Object { }", "UnityEngine.Object", "has it as class, not as struct", TestName = "Another_kind_of_type_is_named")]
        [TestCase("public enum HideFlags { None, HideInNowhere }", "UnityEngine.HideFlags.HideInNowhere", "has no such member",
            TestName = "A_value_that_Unity_lacks_is_named")]
        [TestCase("public enum HideFlags : byte { None }", "HideFlags.value__", "stores it as int", TestName = "An_enum_of_another_size_is_named")]
        [TestCase("public class Object { public static void Destroy(Object obj, int t) { } }", "Destroy(UnityEngine.Object, int)",
            "static void Destroy(Object obj, float t)", TestName = "Another_parameter_type_is_named")]
        [TestCase("public class Object { public static void Destroy(Object obj, float delay) { } }", "Destroy(UnityEngine.Object, float)",
            "calls its parameter delay t", TestName = "Another_parameter_name_is_named")]
        [TestCase("public class Object { public static void Destroy(Object obj, float t = 0) { } }", "Destroy(UnityEngine.Object, float)",
            "does not have t optional", TestName = "An_optional_parameter_that_is_none_in_Unity_is_named")]
        [TestCase(
            "public struct Vector3 { public static void OrthoNormalize(out Vector3 normal, ref Vector3 tangent) => normal = default; }",
            "OrthoNormalize", "passes normal otherwise (Ref, not Out)", TestName = "Out_for_ref_is_named")]
        [TestCase("public class ComputeBuffer { }", "UnityEngine.ComputeBuffer..ctor()", ".ctor(int count, int stride)",
            TestName = "A_default_constructor_that_Unity_lacks_is_named")]
        [TestCase("public class Behaviour { public bool isActiveAndEnabled { get; set; } }", "set_isActiveAndEnabled(bool)",
            "has no such member", TestName = "A_setter_that_Unity_lacks_is_named_in_the_host")]
        [TestCase("public class Behaviour { public virtual bool enabled { get; set; } }", "get_enabled() : bool",
            "does not have it virtual", TestName = "A_virtual_member_that_is_not_so_in_Unity_is_named")]
        [TestCase("public class Camera { public bool orthographic { get; set; } } public class Light : Camera { }", "UnityEngine.Light",
            "has it without UnityEngine.Camera", TestName = "A_wrong_base_class_is_named")]
        [TestCase("public class Light : IDisposable { void IDisposable.Dispose() { } }", "UnityEngine.Light",
            "has it without System.IDisposable", TestName = "An_interface_that_Unity_s_type_lacks_is_named")]
        [TestCase("public struct Vector3 { public static Vector3 Exclude(Vector3 excludeThis, Vector3 fromThat) => fromThat; }",
            "Vector3.Exclude", "mark it [Obsolete]", TestName = "An_obsolete_member_that_is_not_marked_so_is_named")]
        [TestCase("public struct Vector3 { } public class Rigidbody { public Vector3 linearVelocity { get; } }", "get_linearVelocity()",
            "has no such member, 6000.0 and 6000.3 have", TestName = "A_member_of_a_later_version_is_named")]
        [TestCase("public class AudioClip { public delegate void PCMReaderCallback(double[] data); }", "PCMReaderCallback.Invoke(double[])",
            "has no such member", TestName = "A_delegate_of_another_signature_is_named")]
        [TestCase("public struct Mathf { public static readonly float Deg2Rad; }", "Mathf.Deg2Rad", "has it const",
            TestName = "A_constant_that_is_none_here_is_named")]
        public void A_fault_of_the_host_is_named(string source, string what, string why)
        {
            Offer(source);
            if (what.EndsWith("get_enabled() : bool"))
                Assert.That(planted.Examine(Rule()).Faults, Has.Count.EqualTo(2).And.All.Contains(why).And.Some.Contains(what));
            else
                planted.Catches(Rule(), "UnityEngine.dll offers ", what, "Unity 2022.3 ", why);
        }

        [Test]
        public void What_Unity_has_and_what_no_one_sees_is_no_fault()
        {
            Offer(@"public class Object { internal void Explode() { } private protected int secret; public static void Destroy(Object obj, float t) { } public static implicit operator bool(Object exists) => true; ~Object() { } public override string ToString() => """"; }
                    class Gadget { public void Run() { } } delegate void Unseen();
                    public class Light : Behaviour { } public class Behaviour : Component { public bool enabled { get; set; } } public class Component : Object { }
                    public struct Vector3 : IEquatable<Vector3> { public float x; [Obsolete] public static Vector3 Exclude(Vector3 excludeThis, Vector3 fromThat) => fromThat; public bool Equals(Vector3 other) => true; public float this[int index] { get => x; set { } } }");
            Assert.That(planted.Examine(Rule()).Faults, Is.Empty);
        }

        [Test]
        public void A_version_without_a_list_is_named()
        {
            Offer("");
            planted.Catches(Rule("2019.4"), "Unity 2019.4", "no list", "2022.3, 6000.0, 6000.3");
        }
    }
}
