using System;
using System.Linq;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace Host.Tests
{
    /// <summary>Which scripts hear what while nothing plays.</summary>
    public class EngineEditModeTests : EngineFixture
    {
        abstract class Teller : MonoBehaviour
        {
            void Awake() => Tell("Awake");
            void OnEnable() => Tell("OnEnable");
            void Start() => Tell("Start");
            void FixedUpdate() => Tell("FixedUpdate");
            void Update() => Tell("Update");
            void LateUpdate() => Tell("LateUpdate");
            void OnDisable() => Tell("OnDisable");
            void OnDestroy() => Tell("OnDestroy");
            void OnValidate() => Tell("OnValidate");
            void OnTransformParentChanged() => Tell("OnTransformParentChanged");
            void Tell(string what) => Story.Tell(what);
        }

        class Plain : Teller { }

        [ExecuteAlways]
        class Always : Teller { }

        class Heir : Always { }

        [SetUp]
        public void EnterEditMode() => EditMode.IsOn = true;

        [Test]
        public void Nothing_plays_in_edit_mode()
        {
            Assert.That(Application.isPlaying || EditorApplication.isPlaying || Application.IsPlaying(new GameObject()), Is.False);
            Assert.That(Application.isEditor);
            PlayerLoop.Reset();
            Assert.That(Application.isPlaying);
        }

        [Test]
        public void A_plain_script_hears_validation_alone()
        {
            var script = Add<Plain>();
            Update();
            script.enabled = false;
            script.enabled = true;
            script.gameObject.SetActive(false);
            script.gameObject.SetActive(true);
            script.transform.SetParent(new GameObject().transform);
            var serialized = new SerializedObject(script);
            serialized.ApplyModifiedProperties();
            Object.DestroyImmediate(script.gameObject);
            Assert.That(Story.Take().Distinct(), Is.SubsetOf(new[] { "OnValidate" }));
        }

        [TestCase(typeof(Always))]
        [TestCase(typeof(Heir))]
        public void A_script_that_always_executes_hears_all_but_FixedUpdate(Type type)
        {
            var script = (MonoBehaviour)new GameObject().AddComponent(type);
            Update();
            Object.DestroyImmediate(script.gameObject);
            Assert.That(Story.Take(), Is.EqualTo(new[] { "Awake", "OnEnable", "Start", "Update", "LateUpdate", "OnDisable", "OnDestroy" }));
        }

        [Test]
        public void A_script_that_is_told_to_run_hears_OnDisable_and_then_what_it_would_have_heard()
        {
            var script = Add<Plain>();
            script.runInEditMode = true;
            Assert.That(Story.Take(), Is.EqualTo(new[] { "OnDisable", "Awake", "OnEnable" }));
            Update();
            Assert.That(Story.Take(), Is.EqualTo(new[] { "Start", "Update", "LateUpdate" }));
            script.enabled = false;
            script.runInEditMode = false;
            script.enabled = true;
            Update();
            Assert.That(Story.Take(), Is.EqualTo(new[] { "OnDisable" }), "it stops as it was disabled");
        }

        [Test]
        public void A_disabled_script_that_is_told_to_run_begins_when_it_is_enabled()
        {
            var script = Add<Plain>();
            script.enabled = false;
            script.runInEditMode = true;
            Assert.That(Story.Take(), Is.EqualTo(new[] { "Awake" }));
            script.enabled = true;
            Assert.That(Story.Take(), Is.EqualTo(new[] { "OnEnable" }));
        }

        [Test]
        public void A_script_that_no_longer_runs_is_not_told_of_its_end()
        {
            var script = Add<Plain>();
            script.runInEditMode = true;
            Story.Take();
            script.runInEditMode = false;
            Update();
            Object.DestroyImmediate(script.gameObject);
            Assert.That(Story.Take(), Is.Empty);
        }

        [Test]
        public void The_loop_runs_only_where_it_was_queued()
        {
            Add<Always>();
            Story.Take();
            int frame = Time.frameCount;
            EditorTick.Run();
            Assert.That(Time.frameCount, Is.EqualTo(frame));
            EditorApplication.QueuePlayerLoopUpdate();
            EditorTick.Run();
            EditorTick.Run();
            Assert.That(Time.frameCount, Is.EqualTo(frame + 1), "once");
        }

        [Test]
        public void Destroy_is_refused_in_edit_mode()
        {
            var thing = new GameObject();
            Object.Destroy(thing);
            Assert.That(Errors().Single(), Does.StartWith("Destroy may not be called from edit mode! Use DestroyImmediate instead."));
            Assert.That(thing != null);
        }

        static void Update()
        {
            EditorApplication.QueuePlayerLoopUpdate();
            EditorTick.Run();
        }
    }
}
