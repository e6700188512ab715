using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using Host.Assets;
using Host.Scripts;
using Host.Scripts.Assemblies;
using Host.Scripts.Stubs;
using NUnit.Framework;
using UnityEngine;

namespace Host.Tests
{
    /// <summary>From a project's files to assemblies.</summary>
    public class ProjectScriptTests
    {
        string root;
        int files;

        [SetUp]
        public void StartProject()
        {
            root = Path.Combine(Path.GetTempPath(), "rill-scripts-" + Guid.NewGuid().ToString("N"));
            Directory.CreateDirectory(Path.Combine(root, "Assets"));
            Directory.CreateDirectory(Path.Combine(root, "ProjectSettings"));
            Manifest("");
        }

        [TearDown]
        public void RemoveProject() => Directory.Delete(root, true);

        void Manifest(string dependencies)
        {
            Directory.CreateDirectory(Path.Combine(root, "Packages"));
            File.WriteAllText(Path.Combine(root, "Packages", "manifest.json"), $"{{ \"dependencies\": {{ {dependencies} }} }}");
        }

        void Write(string path, string text, string guid = null)
        {
            string file = Path.Combine(root, path);
            Directory.CreateDirectory(Path.GetDirectoryName(file));
            File.WriteAllText(file, text);
            File.WriteAllText(file + ".meta", $"fileFormatVersion: 2\nguid: {guid ?? (++files).ToString("x32")}\n");
        }

        /// <param name="more">Further keys of the definition.</param>
        void Define(string folder, string name, string more = "", string guid = null)
            => Write($"{folder}/{name}.asmdef", $"{{ \"name\": \"{name}\"{(more.Length > 0 ? ", " + more : "")} }}", guid);

        ProjectIndex Index()
        {
            var index = new ProjectIndex(ignoreCase: true);
            foreach (MountedFolder mount in ProjectFolders.Of(root)) index.Mount(mount);
            return index;
        }

        AssemblyPlan Plan()
        {
            ProjectIndex index = Index();
            return new AssemblyPlan(root, index, new Packages(root, index.Mounts), new[] { "UnityEngine", "Unity.Mathematics", "UnityEngine.UI" });
        }

        ProjectScripts Compile() => new ProjectScripts(root, Index());

        static IEnumerable<string> Names(IEnumerable<AssetEntry> entries) => entries.Select(e => e.Path);

        // ---- which script goes where

        [Test]
        public void Scripts_without_a_definition_make_up_Unitys_predefined_assemblies()
        {
            Write("Assets/Game.cs", "");
            Write("Assets/Parts/Wheel.cs", "");
            Write("Assets/Parts/Editor/WheelEditor.cs", "");
            Write("Assets/Plugins/Old.cs", "");
            Write("Assets/Standard Assets/Older.cs", "");
            AssemblyPlan plan = Plan();
            Assert.That(plan.Assemblies.Select(a => a.Name), Is.EqualTo(new[] { "Assembly-CSharp-firstpass", "Assembly-CSharp" }));
            Assert.That(Names(plan.Assemblies[0].Files), Is.EquivalentTo(new[] { "Assets/Plugins/Old.cs", "Assets/Standard Assets/Older.cs" }));
            Assert.That(Names(plan.Assemblies[1].Files), Is.EquivalentTo(new[] { "Assets/Game.cs", "Assets/Parts/Wheel.cs" }));
            Assert.That(plan.Assemblies[1].References, Does.Contain(plan.Assemblies[0]));
            Assert.That(plan.NotForPlayers["Assets/Parts/Editor/WheelEditor.cs"], Does.Contain("Editor folder"));
        }

        [Test]
        public void A_definition_takes_what_lies_below_it_and_a_reference_adds_to_it()
        {
            const string guid = "aaaabbbbccccddddeeeeffff00001111";
            Define("Assets/Core", "Core", guid: guid);
            Write("Assets/Core/Deep/A.cs", "");
            Write("Assets/Elsewhere/Core.asmref", $"{{ \"reference\": \"GUID:{guid}\" }}");
            Write("Assets/Elsewhere/B.cs", "");
            Define("Assets/Core/Inner", "Inner", $"\"references\": [ \"GUID:{guid}\" ]");
            Write("Assets/Core/Inner/C.cs", "");
            AssemblyPlan plan = Plan();
            Assert.That(plan.Assemblies.Select(a => a.Name), Is.EqualTo(new[] { "Core", "Inner" }));
            Assert.That(Names(plan.Assemblies[0].Files), Is.EquivalentTo(new[] { "Assets/Core/Deep/A.cs", "Assets/Elsewhere/B.cs" }));
            Assert.That(plan.Assemblies[1].References.Single().Name, Is.EqualTo("Core"));
        }

        [Test]
        public void Only_definitions_that_allow_it_are_referenced_by_themselves()
        {
            Define("Assets/A", "Open");
            Write("Assets/A/A.cs", "");
            Define("Assets/B", "Closed", "\"autoReferenced\": false");
            Write("Assets/B/B.cs", "");
            Write("Assets/Game.cs", "");
            Assert.That(Plan().Assemblies.Single(a => a.Name == "Assembly-CSharp").References.Select(r => r.Name), Is.EqualTo(new[] { "Open" }));
        }

        [TestCase("\"includePlatforms\": [ \"Editor\" ]", "is for Editor only")]
        [TestCase("\"excludePlatforms\": [ \"WindowsStandalone64\" ]", "is not for WindowsStandalone64")]
        [TestCase("\"defineConstraints\": [ \"UNITY_INCLUDE_TESTS\" ]", "needs the defines UNITY_INCLUDE_TESTS")]
        [TestCase("\"defineConstraints\": [ \"!UNITY_STANDALONE\" ]", "needs the defines !UNITY_STANDALONE")]
        [TestCase("\"optionalUnityReferences\": [ \"TestAssemblies\" ]", "holds tests")]
        public void An_assembly_that_a_player_has_not_is_left_out_with_the_reason(string more, string reason)
        {
            Define("Assets/Part", "Part", more);
            Write("Assets/Part/A.cs", "");
            AssemblyPlan plan = Plan();
            Assert.That(plan.Assemblies, Is.Empty);
            Assert.That(plan.NotForPlayers["Assets/Part/A.cs"], Does.Contain(reason));
        }

        [TestCase("[ \"UNITY_STANDALONE\", \"!UNITY_EDITOR\" ]")]
        [TestCase("[ \"UNITY_ANDROID || UNITY_STANDALONE\" ]")]
        [TestCase("[ \"UNITY_2021_2_OR_NEWER\" ]")]
        public void Define_constraints_that_hold_keep_an_assembly(string constraints)
        {
            Define("Assets/Part", "Part", "\"defineConstraints\": " + constraints);
            Write("Assets/Part/A.cs", "");
            Assert.That(Plan().Assemblies.Select(a => a.Name), Is.EqualTo(new[] { "Part" }));
        }

        [Test]
        public void A_reference_that_a_version_define_says_may_be_missing_is_no_complaint()
        {
            Define("Assets/Part", "Part", "\"references\": [ \"Studio.Input\" ], \"versionDefines\": [ { \"name\": \"com.studio.input\", " +
                "\"expression\": \"\", \"define\": \"STUDIO_INPUT\" } ]");
            Write("Assets/Part/A.cs", "");
            Assert.That(Plan().Notes, Is.Empty);
        }

        [TestCase("1.2.0", "", true)]
        [TestCase("1.2.0", "1.2.0", true)]
        [TestCase("1.1.9", "1.2.0", false)]
        [TestCase("2022.3.0", "[2021.2,2022.3)", false)]
        [TestCase("2022.3.0", "[2021.2,2022.3]", true)]
        [TestCase("2.0.0", "(2.0.0,)", false)]
        [TestCase("1.0.0-preview.2", "1.0.0", false)]
        [TestCase("3.1.4", "[3.1.4]", true)]
        public void A_version_lies_in_a_range_or_not(string version, string range, bool expected)
            => Assert.That(Host.Shaders.VersionRange.Contains(range, version), Is.EqualTo(expected));

        [Test]
        public void Version_defines_look_at_packages_and_at_Unity()
        {
            Manifest("\"com.unity.mathematics\": \"1.2.6\", \"com.unity.burst\": \"1.8.4\"");
            Define("Assets/Part", "Part", "\"versionDefines\": [ { \"name\": \"com.unity.burst\", \"expression\": \"1.8\", \"define\": " +
                "\"BURST\" }, { \"name\": \"com.unity.timeline\", \"expression\": \"\", \"define\": \"TIMELINE\" }, { \"name\": " +
                "\"Unity\", \"expression\": \"[2022.1,2023.1)\", \"define\": \"YEAR\" } ]");
            Write("Assets/Part/A.cs", "");
            Assert.That(Plan().Assemblies.Single().Defines, Does.Contain("BURST").And.Contain("YEAR").And.Not.Contain("TIMELINE"));
        }

        [Test]
        public void The_projects_own_symbols_count()
        {
            File.WriteAllText(Path.Combine(root, "ProjectSettings", "ProjectSettings.asset"),
                "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!129 &1\nPlayerSettings:\n  scriptingDefineSymbols:\n    Standalone: " +
                "MY_SYMBOL;OTHER\n    Android: PHONE\n  activeInputHandler: 1\n");
            Assert.That(Defines.Of(root), Does.Contain("MY_SYMBOL").And.Contain("OTHER").And.Not.Contain("PHONE").And.Contain(
                "ENABLE_INPUT_SYSTEM").And.Not.Contain("ENABLE_LEGACY_INPUT_MANAGER"));
        }

        [Test]
        public void A_reference_to_an_assembly_that_is_not_there_is_said()
        {
            Define("Assets/Part", "Part",
                "\"references\": [ \"Unity.RenderPipelines.Universal.Runtime\", \"GUID:6055be8ebefd69e48b49212b09b47b2f\" ]");
            Write("Assets/Part/A.cs", "");
            Assert.That(Plan().Notes, Is.EqualTo(new[]
            {
                "Assets/Part/Part.asmdef refers to the assembly 'Unity.RenderPipelines.Universal.Runtime', which is not in the " +
                    "project: the scripts that use it will not compile",
                "Assets/Part/Part.asmdef refers to the assembly 'Unity.TextMeshPro' (GUID:6055be8ebefd69e48b49212b09b47b2f), which is " +
                    "not in the project: the scripts that use it will not compile",
            }));
        }

        [Test]
        public void A_circle_of_definitions_is_refused_by_name()
        {
            foreach (var (name, other) in new[] { ("One", "Two"), ("Two", "Three"), ("Three", "One") })
            {
                Define("Assets/" + name, name, $"\"references\": [ \"{other}\" ]");
                Write($"Assets/{name}/A.cs", "");
            }
            var error = Assert.Throws<ScriptException>(() => Plan());
            Assert.That(error.Message, Does.Contain("in a circle: One -> Two -> Three -> One").And.Contain("Assets/Two/Two.asmdef"));
        }

        [Test]
        public void Two_definitions_of_one_name_are_refused()
        {
            Define("Assets/A", "Part");
            Define("Assets/B", "Part");
            Assert.That(Assert.Throws<ScriptException>(() => Plan()).Message,
                Does.Contain("Assets/B/Part.asmdef and Assets/A/Part.asmdef both define the assembly 'Part'"));
        }

        [Test]
        public void A_definition_that_is_no_json_is_named_with_its_line()
        {
            Write("Assets/Part/Part.asmdef", "{\n  \"name\": oops\n}");
            Assert.That(Assert.Throws<ScriptException>(() => Plan()).Message, Does.StartWith("Assets/Part/Part.asmdef(2): "));
        }

        [Test]
        public void Packages_that_are_not_here_are_listed_and_the_engines_modules_are_not()
        {
            Manifest("\"com.unity.render-pipelines.universal\": \"14.0.8\", \"com.unity.modules.physics\": \"1.0.0\", " +
                "\"com.unity.mathematics\": \"1.2.6\"");
            Assert.That(new Packages(root, ProjectFolders.Of(root)).Missing, Is.EqualTo(new[] { "com.unity.render-pipelines.universal 14.0.8" }));
        }

        // ---- compiling

        [Test]
        public void An_error_of_syntax_stops_everything_as_in_Unity()
        {
            Write("Assets/Good.cs", "public class Good { }");
            Write("Assets/Bad.cs", "public class Bad\n{\n    void M() { int a = ; }\n}");
            var error = Assert.Throws<ScriptException>(() => Compile());
            Assert.That(error.Message, Does.Contain("errors of syntax, which stop Unity too").And.Contain("Assets/Bad.cs(3,24): error CS1525"));
        }

        [Test]
        public void The_language_is_Unitys_CSharp_9()
        {
            Write("Assets/New.cs", "namespace A;\npublic class New { }");
            Assert.That(Assert.Throws<ScriptException>(() => Compile()).Message,
                Does.Contain("Assets/New.cs(1,1): error CS8773").And.Contain("C# 9.0"));
        }

        [Test]
        public void Files_that_need_a_left_out_file_are_left_out_because_of_it()
        {
            Write("Assets/Broken.cs", "public class Broken { public void M() => UnityEngine.Camera.main.NoSuchThing(); }");
            Write("Assets/User.cs", "public class User { Broken broken; }");
            Write("Assets/Fine.cs", "public class Fine : UnityEngine.MonoBehaviour { }");
            ProjectScripts scripts = Compile();
            List<string> said = scripts.LeftOut.Select(f => f.Error).ToList();
            Assert.That(said.Count, Is.EqualTo(2));
            Assert.That(said[0], Does.StartWith("Assets/Broken.cs(1,").And.Contain("CS1061").And.Not.Contain("Unity 2022.3 has it"));
            Assert.That(said[1], Does.StartWith("Assets/User.cs(1,").And.Contain("CS0246").And.EndWith(
                "(it was in Assets/Broken.cs, which is left out)"));
            Assert.That(scripts.Assemblies.Single().GetType("Fine"), Is.Not.Null);
            Assert.That(scripts.WhyMissing("Assets/User.cs"), Does.StartWith("it does not compile against the host: Assets/User.cs(1,"));
        }

        [Test]
        public void A_package_that_no_one_asked_for_is_not_there()
        {
            Write("Assets/Vectors.cs", "public class Vectors { Unity.Mathematics.float3 v; }");
            Assert.That(Compile().LeftOut.Single().Error, Does.Contain("CS0246").Or.Contain("CS0234"));
            Manifest("\"com.unity.mathematics\": \"1.2.6\"");
            Assert.That(Compile().LeftOut, Is.Empty);
        }

        [Test]
        public void Options_of_csc_rsp_are_taken_over()
        {
            Write("Assets/csc.rsp", "-define:FROM_RSP;OTHER\n-unsafe\n# a comment\n-nowarn:0649");
            Write("Assets/A.cs", "#if FROM_RSP && OTHER\npublic unsafe class A { int* pointer; }\n#endif");
            ProjectScripts scripts = Compile();
            Assert.That(scripts.LeftOut, Is.Empty);
            Assert.That(scripts.Assemblies.Single().GetType("A"), Is.Not.Null);
        }

        [Test]
        public void A_component_whose_script_was_left_out_is_missing_and_the_reason_is_said()
        {
            const string guid = "aaaabbbbccccddddeeeeffff00002222";
            Write("Assets/Broken.cs",
                "public class Broken : UnityEngine.MonoBehaviour { void Update() => UnityEngine.Camera.main.NoSuchThing(); }", guid);
            Write("Assets/Main.unity", "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!1 &1\nGameObject:\n  m_Component:\n  - " +
                "component: {fileID: 2}\n  - component: {fileID: 3}\n  m_Name: Thing\n  m_IsActive: 1\n"
                + "--- !u!4 &2\nTransform:\n  m_GameObject: {fileID: 1}\n  m_Father: {fileID: 0}\n"
                + $"--- !u!114 &3\nMonoBehaviour:\n  m_GameObject: {{fileID: 1}}\n  m_Enabled: 1\n  m_Script: {{fileID: 11500000, " +
                $"guid: {guid}, type: 3}}\n");
            ProjectScripts scripts = Compile();
            var assets = new ProjectAssets(ProjectFolders.Of(root), scripts.Assemblies, strict: false, foreign: scripts);
            try
            {
                assets.ReadScene(assets.Index.ByPath("Assets/Main.unity"));
                Assert.That(assets.MissingScripts, Is.EqualTo(1));
                Assert.That(assets.Warnings.Single(),
                    Does.Match(
                    @"^Assets/Main\.unity\(\d+\): the script of a component on 'Thing', Assets/Broken\.cs, cannot be loaded, so the component is missing: it does not compile against the host: Assets/Broken\.cs\(1,\d+\): error CS1061"));
            }
            finally
            {
                UnityEngine.SceneManagement.SceneManager.UnloadEverything();
            }
        }

        // ---- stubs

        [Test]
        public void Stubs_stand_for_most_of_Unity_and_compile_in_one_go()
        {
            var stubs = StubAssembly.Get();
            Assert.That(stubs.Types, Is.GreaterThan(1500));
            Assert.That(stubs.Members, Is.GreaterThan(10000));
            Assert.That(stubs.Dropped, Is.LessThan(150), "members of the lists that are no C# by themselves");
            Assert.That(stubs.Refused, Is.Empty, $"a first use takes longer than it must: copy fixes.txt from " +
                $"{Path.GetDirectoryName(stubs.File)} to Headless~/Engine/Scripts/Stubs/Sources");
        }

        [Test]
        public void A_stub_throws_its_own_name_and_is_counted()
        {
            Write("Assets/Shooter.cs", "using UnityEngine;\npublic static class Shooter { public static bool Shoot() => " +
                "Physics2D.Raycast(Vector2.zero, Vector2.up); }");
            ProjectScripts scripts = Compile();
            Assert.That(scripts.LeftOut, Is.Empty);
            var thrown = Assert.Throws<TargetInvocationException>(() => scripts.Assemblies.Single().GetType("Shooter").GetMethod("Shoot")
                .Invoke(null, null)).InnerException;
            Assert.That(thrown, Is.InstanceOf<NotSupportedException>());
            Assert.That(thrown.Message, Is.EqualTo("UnityEngine.Physics2D.Raycast is not part of the headless host"));
            Assert.That(scripts.StubCalls, Does.Contain(new KeyValuePair<string, int>("UnityEngine.Physics2D.Raycast", 1)));
        }

        [Test]
        public void Bodies_are_the_hosts_own_and_fall_by_the_scripts_gravity()
        {
            Write("Assets/Moon.cs", "using UnityEngine;\npublic static class Moon { public static float Land(Rigidbody body) { " +
                "Physics.gravity = new Vector3(0f, -1.6f, 0f); body.velocity = Vector3.up; return body.mass; } }");
            ProjectScripts scripts = Compile();
            Assert.That(scripts.LeftOut, Is.Empty);
            var owner = new GameObject("lander");
            try
            {
                var body = owner.AddComponent<Rigidbody>();
                Assert.That(scripts.Assemblies.Single().GetType("Moon").GetMethod("Land").Invoke(null, new object[] { body }), Is.EqualTo(1f));
                Assert.That(UnityEngine.Headless.PhysicsWorld.Gravity.y, Is.EqualTo(-1.6f));
            }
            finally
            {
                UnityEngine.Headless.PhysicsWorld.Reset();
                UnityEngine.Object.DestroyImmediate(owner);
            }
        }

        [Test]
        public void No_one_touches_the_keyboard_and_no_one_hears_a_sound()
        {
            Write("Assets/Quiet.cs", "using UnityEngine;\npublic static class Quiet { public static string Ask(AudioSource source) { " +
                "source.volume = 0.25f; source.Play(); return $\"{Input.GetKey(KeyCode.A)} {Input.GetAxis(\"Horizontal\")} " +
                "{Input.mousePosition} {Input.inputString.Length} {Input.touchCount} {Input.GetJoystickNames().Length} " +
                "{source.volume}\"; } }");
            ProjectScripts scripts = Compile();
            Assert.That(scripts.LeftOut, Is.Empty);
            var owner = new GameObject("speaker");
            try
            {
                Component source = owner.AddComponent(scripts.StubComponent("AudioSource"));
                Assert.That(scripts.Assemblies.Single().GetType("Quiet").GetMethod("Ask").Invoke(null, new object[] { source }),
                    Is.EqualTo("False 0 (0.00, 0.00, 0.00) 0 0 0 0.25"));
            }
            finally
            {
                UnityEngine.Object.DestroyImmediate(owner);
            }
        }

        [TestCase("ConfigurableJoint")]
        [TestCase("WheelCollider")]
        [TestCase("ParticleSystem")]
        [TestCase("NavMeshAgent", "AI.")]
        [TestCase("Animator")]
        public void Components_that_the_host_lacks_can_sit_on_an_object(string name, string space = "")
        {
            Write("Assets/Fine.cs", "public class Fine { }");
            Type type = Compile().StubComponent(space + name);
            var owner = new GameObject("owner");
            try
            {
                Assert.That(owner.AddComponent(type).GetType().Name, Is.EqualTo(name));
                Assert.That(owner.GetComponent(type), Is.Not.Null);
            }
            finally
            {
                UnityEngine.Object.DestroyImmediate(owner);
            }
        }
    }
}
