using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace Host.Tests
{
    /// <summary>A reload of scripts in Unity's order, and what is left of their state. The scripts are an assembly of their own.</summary>
    public class EngineReloadTests : EngineFixture
    {
        static Assembly scripts;

        [OneTimeSetUp]
        public void CompileScripts()
        {
            if (scripts != null)
                return;
            using var planted = new PlantedAssemblies();
            foreach (string name in new[] { "UnityEngine", "UnityEditor", "Engine.Tests" })
                planted.Bring(name);
            planted.Compile("ReloadedScripts", File.ReadAllText(Path.Combine(TestFolder.Path, "Projects", "ReloadedScripts.cs")));
            EditorInitializers.Run();
            scripts = Assembly.LoadFrom(Path.Combine(planted.Assemblies, "ReloadedScripts.dll"));
        }

        [TearDown]
        public void DestroyWhatScenesDoNotHold()
        {
            foreach (ScriptableObject made in Resources.FindObjectsOfTypeAll<ScriptableObject>())
                if (made.GetType().Assembly == scripts)
                    Object.DestroyImmediate(made);
        }

        [Test]
        public void In_play_mode_it_runs_in_Unity_s_order()
        {
            Make("Late");
            MonoBehaviour disabled = Make("Early"), early = Make("Early");
            disabled.enabled = false;
            disabled.name = "disabled";
            Make("Early").gameObject.SetActive(false);
            ScriptableObject.CreateInstance(TypeOf("Asset"));
            Frames(1);
            Story.Take();
            EditorReload.Run();
            string[] all = { "Asset", "Early", "Early", "Early", "Late" };
            Assert.That(Story.Take(), Is.EqualTo(
                new[] { "before" }.Concat(new[] { "Asset OnDisable", "Early OnDisable", "Late OnDisable" }.OrderBy(OrderOfType))
                .Concat(Of("OnBeforeSerialize")).Concat(Of("constructed")).Concat(Of("OnAfterDeserialize")).Concat(Of("OnValidate"))
                .Concat(new[] { "[InitializeOnLoad]", "[InitializeOnLoadMethod]" })
                .Concat(new[] { "Asset OnEnable", "Early OnEnable", "Late OnEnable" }.OrderBy(OrderOfType)).Concat(new[] { "after" })));
            Frames(1);
            Assert.That(Story.Take(), Is.EqualTo(new[] { "Early Update", "Late Update" }), "no second Awake or Start");
            Assert.That(early.isActiveAndEnabled);

            IEnumerable<string> Of(string what) => all.OrderBy(OrderOfType).Select(name => $"{name} {what}");
        }

        // Early -10, the asset 0, late 10.
        static int OrderOfType(string line) => line[0] == 'E' ? 0 : line[0] == 'A' ? 1 : 2;

        [Test]
        public void In_edit_mode_scripts_that_do_not_run_there_are_not_told_that_they_are_disabled()
        {
            EditMode.IsOn = true;
            Make("Early");
            MonoBehaviour always = Make("Always"), told = Make("Late");
            told.runInEditMode = true;
            Story.Take();
            EditorReload.Run();
            string[] lines = Story.Take();
            Assert.That(lines.Where(line => line.StartsWith("Early")),
                Is.EqualTo(new[] { "Early OnBeforeSerialize", "Early constructed", "Early OnAfterDeserialize", "Early OnValidate" }));
            Assert.That(lines.Where(line => line.EndsWith("able")),
                Is.EqualTo(new[] { "Always OnDisable", "Late OnDisable", "Always OnEnable", "Late OnEnable" }));
        }

        [Test]
        public void Fields_come_back_as_far_as_Unity_serializes_them()
        {
            var other = new GameObject("other");
            MonoBehaviour script = Make("Values");
            script.gameObject.hideFlags = HideFlags.NotEditable;
            Call(script, "Fill", other);
            Object.DestroyImmediate(other.transform.Find("gone").gameObject);
            for (int time = 0; time < 2; time++)
            {
                EditorReload.Run();
                Assert.That(Told(script), Is.EqualTo(new[]
                {
                    "setting: 5", "text: filled", "noText: ''", "none: 0", "noList: 0", "list: 1 2", "nested: filled 0 [] initial",
                    "noNested: '' 0 [] initial", "structs: 3/0", "reference: other", "destroyed: null", "curve: 0", "property: 7",
                    "skipped: initial", "skippedProperty: 0", "constant: 1", "dictionary: null", "callback: null", "listeners: 0",
                    "unmarked: null", "unmarkedStruct: 0", "table: null", "maybe: null", "any: null", "owner: itself", "missing: filled",
                    "ofBase: 8", "managed: kept"
                }));
            }
            Assert.That(script.gameObject.hideFlags, Is.EqualTo(HideFlags.NotEditable));
            Assert.That(Resources.FindObjectsOfTypeAll(script.GetType()), Is.EqualTo(new[] { script }), "and no second one");
        }

        [Test]
        public void Statics_begin_again_with_what_they_use()
        {
            Type type = TypeOf("Statics");
            type.GetMethod("Change").Invoke(null, null);
            Assert.That(type.GetMethod("Tell").Invoke(null, null), Is.EqualTo("9, 1 2, text, 1 of other list, changed"));
            EditorReload.Run();
            Assert.That(type.GetMethod("Tell").Invoke(null, null), Is.EqualTo("3, 1, , 0 of one list, first"));
        }

        [Test]
        public void Listeners_are_gone_and_those_of_the_host_stay()
        {
            MonoBehaviour script = Make("Listener");
            int heard = 0;
            Action hear = () => heard++;
            Application.quitting += hear;
            Call(script, "Listen");
            EditorReload.Run();
            Story.Take();
            Application.RaiseQuitting();
            EditorTick.Run();
            Camera.onPreCull?.Invoke(null);
            Undo.undoRedoPerformed?.Invoke();
            Assert.That(heard, Is.EqualTo(1));
            EditorReload.Run();
            Assert.That(Story.Take().Where(line => line.StartsWith("heard")), Is.Empty);
            Application.quitting -= hear;
        }

        [Test]
        public void Coroutines_and_timed_calls_do_not_go_on()
        {
            MonoBehaviour script = Make("Listener");
            Call(script, "Begin");
            Frames(3);
            Assert.That(Story.Take(), Has.Some.EqualTo("coroutine").And.Some.EqualTo("invoked"));
            EditorReload.Run();
            Story.Take();
            Frames(3);
            Assert.That(Story.Take(), Is.Empty);
            Assert.That(script.IsInvoking(), Is.False);
        }

        [Test]
        public void Editors_and_windows_keep_what_the_engine_holds_of_them()
        {
            MonoBehaviour script = Make("Values");
            Editor editor = Editor.CreateEditor(script, TypeOf("ValuesEditor"));
            SerializedObject before = editor.serializedObject;
            var window = (EditorWindow)ScriptableObject.CreateInstance(TypeOf("Window"));
            window.titleContent = new GUIContent("Title");
            Story.Take();
            EditorReload.Run();
            Assert.That(Story.Take(), Is.SupersetOf(new[] { "ValuesEditor OnDisable", "Window OnDisable", "ValuesEditor OnEnable of object",
                "Window OnEnable" }));
            Assert.That(editor.target, Is.SameAs(script));
            Assert.That(editor.serializedObject, Is.Not.SameAs(before));
            Assert.That(window.titleContent.text, Is.EqualTo("Title"));
            Object.DestroyImmediate(editor);
        }

        [Test]
        public void What_throws_on_the_way_is_logged_and_ends_nothing()
        {
            MonoBehaviour script = Make("Listener");
            Call(script, "ThrowBefore");
            EditorReload.Run();
            Assert.That(Errors(), Is.EqualTo(new[] { "InvalidOperationException: thrown before", "InvalidOperationException: thrown by OnDisable" }));
            Assert.That(Story.Take(), Has.Some.EqualTo("after"));
        }

        MonoBehaviour Make(string type) => (MonoBehaviour)new GameObject("object").AddComponent(TypeOf(type));

        static Type TypeOf(string name) => scripts.GetType("Reloaded." + name, true);

        static void Call(object on, string method, params object[] arguments) => on.GetType().GetMethod(method).Invoke(on, arguments);

        static string[] Told(object on) => (string[])on.GetType().GetMethod("Tell").Invoke(on, null);
    }

    /// <summary>Effect of a reload on pending read-backs.</summary>
    public class EngineReloadReadbackTests : GraphicsFixture
    {
        [Test]
        public void A_pending_read_back_no_longer_calls_scripts()
        {
            new EngineReloadTests().CompileScripts();
            Type type = AppDomain.CurrentDomain.GetAssemblies().First(a => a.GetName().Name == "ReloadedScripts").GetType("Reloaded.Listener");
            var hear = (Action<AsyncGPUReadbackRequest>)type.GetMethod("OnReadback").CreateDelegate(typeof(Action<AsyncGPUReadbackRequest>));
            int heard = 0;
            using var buffer = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 4, 4);
            buffer.SetData(new int[4]);
            AsyncGPUReadback.Request(buffer, hear);
            AsyncGPUReadback.Request(buffer, _ => heard++);
            Story.Take();
            EditorReload.Run();
            Story.Take();
            AsyncGPUReadback.WaitAllRequests();
            Frame();
            Assert.That(heard, Is.EqualTo(1));
            Assert.That(Story.Take(), Is.Empty);
        }
    }
}
