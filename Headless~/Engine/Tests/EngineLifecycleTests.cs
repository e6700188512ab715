using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.SceneManagement;
using Object = UnityEngine.Object;

namespace Host.Tests
{
    public class EngineLifecycleTests : EngineFixture
    {
        class Teller : MonoBehaviour
        {
            protected void Tell(string what) => Story.Tell($"{name} {what}");
            void Awake() => Tell("Awake");
            void OnEnable() => Tell("OnEnable");
            void Start() => Tell("Start");
            void OnDisable() => Tell("OnDisable");
            void OnDestroy() => Tell("OnDestroy");
        }

        class Updater : Teller
        {
            void FixedUpdate() => Tell("FixedUpdate");
            void Update() => Tell("Update");
            void LateUpdate() => Tell("LateUpdate");
        }

        [DefaultExecutionOrder(-10)] class Early : Updater { }
        [DefaultExecutionOrder(10)] class Late : Updater { }

        class Validated : Teller { void OnValidate() => Tell("OnValidate"); }

        [Test]
        public void Added_to_an_active_object_a_script_wakes_at_once_and_starts_in_the_next_frame()
        {
            Add<Updater>("a");
            Assert.That(Story.Take(), Is.EqualTo(new[] { "a Awake", "a OnEnable" }));
            Frames(1);
            Assert.That(Story.Take(), Is.EqualTo(new[] { "a Start", "a FixedUpdate", "a Update", "a LateUpdate" }));
            Frames(1);
            Assert.That(Story.Take(), Is.EqualTo(new[] { "a FixedUpdate", "a Update", "a LateUpdate" }));
        }

        [Test]
        public void On_an_inactive_object_nothing_happens_until_it_is_activated()
        {
            var go = new GameObject("a");
            go.SetActive(false);
            go.AddComponent<Teller>();
            Frames(2);
            Assert.That(Story.Take(), Is.Empty);
            go.SetActive(true);
            Assert.That(Story.Take(), Is.EqualTo(new[] { "a Awake", "a OnEnable" }));
            go.SetActive(false);
            go.SetActive(true);
            Assert.That(Story.Take(), Is.EqualTo(new[] { "a OnDisable", "a OnEnable" }));
            Frames(2);
            Assert.That(Story.Take(), Is.EqualTo(new[] { "a Start" }));
        }

        [Test]
        public void A_disabled_script_wakes_but_is_not_enabled()
        {
            var go = new GameObject("a");
            go.SetActive(false);
            Teller teller = go.AddComponent<Teller>();
            teller.enabled = false;
            go.SetActive(true);
            Assert.That(Story.Take(), Is.EqualTo(new[] { "a Awake" }));
            teller.enabled = true;
            Assert.That(Story.Take(), Is.EqualTo(new[] { "a OnEnable" }));
        }

        class DisablesItself : Teller
        {
            void OnEnable()
            {
                Tell("OnEnable");
                enabled = false;
            }
            void Update() => Tell("Update");
        }

        [Test]
        public void Disabling_in_OnEnable_holds()
        {
            DisablesItself script = Add<DisablesItself>("a");
            Frames(2);
            Assert.That(Story.Take(), Is.EqualTo(new[] { "a Awake", "a OnEnable", "a OnDisable" }));
            Assert.That(script.enabled, Is.False);
        }

        class DisablesItselfInAwake : Teller
        {
            void Awake()
            {
                Tell("Awake");
                enabled = false;
            }
        }

        [Test]
        public void Disabling_in_Awake_comes_before_OnEnable()
        {
            Add<DisablesItselfInAwake>("a");
            Frames(1);
            Assert.That(Story.Take(), Is.EqualTo(new[] { "a Awake" }));
        }

        [Test]
        public void Execution_order_decides_who_goes_first_in_every_message()
        {
            Add<Late>("late");
            Add<Updater>("normal");
            Add<Early>("early");
            Story.Take();
            Frames(1);
            string[] names = Story.Take().Select(l => l.Split(' ')[0]).ToArray();
            Assert.That(names, Is.EqualTo(Enumerable.Repeat(new[] { "early", "normal", "late" }, 4).SelectMany(x => x)));
        }

        [Test]
        public void The_order_of_a_meta_file_beats_the_attribute()
        {
            ExecutionOrder.FromMeta[typeof(Late)] = -100;
            try
            {
                Add<Early>("early");
                Add<Late>("late");
                Story.Take();
                Frames(1);
                Assert.That(Story.Take().First(), Is.EqualTo("late Start"));
            }
            finally
            {
                ExecutionOrder.FromMeta.Remove(typeof(Late));
            }
        }

        [Test]
        public void A_loaded_scene_is_validated_then_woken_object_by_object_in_execution_order()
        {
            GameObject root = null, child = null;
            SceneManager.SceneLoader = name =>
            {
                Scene scene = SceneManager.CreateForLoading(name, "Assets/" + name + ".unity");
                root = ObjectFactory.CreateGameObject("root", scene);
                child = ObjectFactory.CreateGameObject("child", scene);
                child.transform.SetParent(root.transform, false);
                ObjectFactory.AddComponent(root, typeof(Validated));
                ObjectFactory.AddComponent(child, typeof(Early));
                ObjectFactory.AddComponent(child, typeof(Validated));
                return scene;
            };
            Story.Take();
            SceneManager.sceneLoaded += (scene, mode) => Story.Tell($"{scene.name} loaded");
            SceneManager.LoadScene("level");
            Assert.That(Story.Take(), Is.Empty, "loads with the next frame");
            Frames(1, 0);
            Assert.That(Story.Take(), Is.EqualTo(new[]
            {
                "root OnValidate", "child OnValidate", "child Awake", "child OnEnable", "root Awake", "root OnEnable", "child Awake",
                    "child OnEnable",
                "level loaded", "child Start", "root Start", "child Start", "child Update", "child LateUpdate",
            }));
            Assert.That(SceneManager.GetActiveScene().GetRootGameObjects(), Is.EqualTo(new[] { root }));
        }

        [Test]
        public void Loading_a_scene_destroys_the_old_one_but_not_what_DontDestroyOnLoad_keeps()
        {
            SceneManager.SceneLoader = name => SceneManager.CreateForLoading(name, name);
            Teller old = Add<Teller>("old"), kept = Add<Teller>("kept");
            Object.DontDestroyOnLoad(kept);
            Story.Take();
            SceneManager.LoadScene("level");
            Frames(1);
            Assert.That(Story.Take(), Is.EqualTo(new[] { "old OnDisable", "old OnDestroy", "kept Start" }));
            Assert.That(old == null);
            Assert.That(kept.gameObject.scene.name, Is.EqualTo("DontDestroyOnLoad"));
            Assert.That(Object.FindObjectsByType<Teller>(FindObjectsSortMode.None), Is.EqualTo(new[] { kept }));
        }

        [Test]
        public void A_scene_that_does_not_exist_is_an_error_by_name()
        {
            SceneManager.SceneLoader = name => default;
            SceneManager.LoadScene("nowhere");
            Frames(1);
            Assert.That(Errors().Single(), Does.Contain("'nowhere'"));
        }

        class Thrower : MonoBehaviour
        {
            void Awake() => throw new InvalidOperationException("in Awake");
            void Update() => throw new InvalidOperationException("in Update");
        }

        [Test]
        public void An_exception_is_logged_and_stops_nothing_else()
        {
            Thrower thrower = Add<Thrower>("thrower");
            Add<Updater>("a");
            Story.Take();
            Frames(1);
            Assert.That(Story.Take(), Does.Contain("a Update"));
            Assert.That(Errors(), Is.EqualTo(new[] { "InvalidOperationException: in Awake", "InvalidOperationException: in Update" }));
            Assert.That(thrower.enabled);
        }

        // ---- destruction
        [Test]
        public void Destroy_waits_for_the_end_of_the_updates()
        {
            Updater a = Add<Updater>("a");
            Frames(1);
            Story.Take();
            Object.Destroy(a.gameObject);
            Assert.That(a != null);
            Frames(1);
            Assert.That(Story.Take(), Is.EqualTo(new[] { "a FixedUpdate", "a Update", "a LateUpdate", "a OnDisable", "a OnDestroy" }));
            Assert.That(a == null);
        }

        [Test]
        public void A_destroyed_object_equals_null_and_says_so_when_touched()
        {
            Teller a = Add<Teller>("a");
            GameObject go = a.gameObject;
            Object.DestroyImmediate(go);
            Assert.That(go == null);
            Assert.That(a == null);
            Assert.That((bool)a, Is.False);
            Assert.That((object)a, Is.Not.Null);
            Assert.That(a.Equals(null));
            Assert.That(Assert.Throws<MissingReferenceException>(() => _ = a.name).Message, Does.Contain("'Teller'"));
            Assert.Throws<MissingReferenceException>(() => _ = go.transform);
            Assert.That(a, Is.Not.EqualTo(Add<Teller>("b")));
        }

        [Test]
        public void A_tree_is_disabled_as_a_whole_before_it_is_destroyed()
        {
            Teller parent = Add<Teller>("parent"), child = Add<Teller>("child");
            child.transform.SetParent(parent.transform);
            Story.Take();
            Object.DestroyImmediate(parent.gameObject);
            Assert.That(Story.Take(), Is.EqualTo(new[] { "parent OnDisable", "child OnDisable", "parent OnDestroy", "child OnDestroy" }));
            Assert.That(SceneManager.GetActiveScene().rootCount, Is.EqualTo(0));
        }

        [Test]
        public void A_script_that_never_woke_is_not_told_that_it_dies()
        {
            var go = new GameObject("a");
            go.SetActive(false);
            go.AddComponent<Teller>();
            Object.DestroyImmediate(go);
            Assert.That(Story.Take(), Is.Empty);
        }

        [Test]
        public void A_delayed_Destroy_waits_for_its_time()
        {
            Teller a = Add<Teller>("a");
            Object.Destroy(a, 0.05f);
            Frames(2);
            Assert.That(a != null);
            Frames(1);
            Assert.That(a == null);
        }

        [RequireComponent(typeof(Teller))] class Needs : MonoBehaviour { }
        [DisallowMultipleComponent] class Single : MonoBehaviour { }

        [Test]
        public void A_required_component_comes_along_and_cannot_leave_first()
        {
            Needs needs = Add<Needs>("a");
            Teller teller = needs.GetComponent<Teller>();
            Assert.That(teller != null);
            Object.DestroyImmediate(teller);
            Assert.That(teller != null);
            Assert.That(Errors().Single(), Does.Contain("depends on it"));
            Object.DestroyImmediate(needs);
            Object.DestroyImmediate(teller);
            Assert.That(teller == null);
        }

        [Test]
        public void A_second_component_of_a_single_kind_is_refused()
        {
            Single first = Add<Single>();
            Assert.That(first.gameObject.AddComponent<Single>() == null);
            Assert.That(Errors().Single(), Does.Contain("Single"));
        }

        [Test]
        public void A_transform_cannot_be_destroyed_and_assets_only_on_demand()
        {
            var go = new GameObject("a");
            Object.DestroyImmediate(go.transform);
            GameObject prefab = ObjectFactory.CreateGameObject("prefab", default);
            Object.DestroyImmediate(prefab);
            Assert.That(Errors(), Has.Count.EqualTo(2));
            Assert.That(prefab != null && go.transform != null);
            Object.DestroyImmediate(prefab, true);
            Assert.That(prefab == null);
        }

        [Test]
        public void A_MonoBehaviour_made_with_new_is_null_and_warned_of()
        {
            var wrong = new Teller();
            Assert.That(wrong == null);
            Assert.That(Warnings().Single(), Does.Contain("'new' keyword"));
        }

        // ---- lookups
        [Test]
        public void Components_are_found_in_the_object_its_children_and_its_parents()
        {
            Teller top = Add<Teller>("top"), low = Add<Updater>("low");
            low.transform.SetParent(top.transform);
            Assert.That(top.GetComponent<Updater>(), Is.Null);
            Assert.That(top.GetComponentInChildren<Updater>(), Is.SameAs(low));
            Assert.That(low.GetComponentsInParent<Teller>(), Is.EqualTo(new[] { low, top }));
            Assert.That(top.GetComponentsInChildren<Teller>(), Is.EqualTo(new[] { top, low }));
            Assert.That(low.TryGetComponent(out Teller found) && found == low);
            low.gameObject.SetActive(false);
            Assert.That(top.GetComponentInChildren<Updater>(), Is.Null);
            Assert.That(top.GetComponentInChildren<Updater>(true), Is.SameAs(low));
            Assert.That(GameObject.Find("top"), Is.SameAs(top.gameObject));
            Assert.That(GameObject.Find("top/low"), Is.Null);
            low.gameObject.SetActive(true);
            Assert.That(GameObject.Find("/top/low"), Is.SameAs(low.gameObject));
        }

        // ---- copies
        [Serializable]
        class Inner { public int number; public Transform target; [NonSerialized] public int lost = 7; }

        class Copied : MonoBehaviour
        {
            public int number = 1;
            [SerializeField] string text = "default";
            public List<float> list;
            public Inner inner;
            public Inner[] many = Array.Empty<Inner>();
            public AnimationCurve curve;
            public GameObject self;
            public Transform outside;
            public Transform child;
            [NonSerialized] public int lost = 3;
            int hidden = 4;
            public static int Common = 5;
            public string Text { get => text; set => text = value; }
            public int Hidden { get => hidden; set => hidden = value; }
            void Awake() => Story.Tell($"{name} Awake with {number}");
        }

        [Test]
        public void A_copy_has_the_serialized_fields_and_its_own_tree()
        {
            Transform outside = new GameObject("outside").transform;
            Copied original = Add<Copied>("original");
            Transform child = new GameObject("child").transform;
            child.SetParent(original.transform);
            original.number = 11;
            original.Text = "text";
            original.list = new List<float> { 1, 2 };
            original.inner = new Inner { number = 12, target = child, lost = 99 };
            original.many = new[] { new Inner { number = 13, target = outside } };
            original.curve = AnimationCurve.Linear(0, 0, 1, 1);
            original.self = original.gameObject;
            original.outside = outside;
            original.child = child;
            original.lost = original.Hidden = 99;
            Story.Take();

            Copied copy = Object.Instantiate(original);

            Assert.That(Story.Take(), Is.EqualTo(new[] { "original(Clone) Awake with 11" }));
            Assert.That(copy.name, Is.EqualTo("original(Clone)"));
            Assert.That(copy.Text, Is.EqualTo("text"));
            Assert.That(copy.list, Is.EqualTo(new[] { 1f, 2f }).And.Not.SameAs(original.list));
            Assert.That(copy.inner.number, Is.EqualTo(12));
            Assert.That(copy.inner.lost, Is.EqualTo(7));
            Assert.That(copy.inner.target, Is.SameAs(copy.transform.GetChild(0)));
            Assert.That(copy.many[0].number, Is.EqualTo(13));
            Assert.That(copy.many[0].target, Is.SameAs(outside));
            Assert.That(copy.curve, Is.EqualTo(original.curve).And.Not.SameAs(original.curve));
            Assert.That(copy.self, Is.SameAs(copy.gameObject));
            Assert.That(copy.child, Is.SameAs(copy.transform.GetChild(0)));
            Assert.That(copy.outside, Is.SameAs(outside));
            Assert.That(copy.lost, Is.EqualTo(3));
            Assert.That(copy.Hidden, Is.EqualTo(4));
        }

        [Test]
        public void A_copy_can_be_placed_and_put_under_a_parent()
        {
            Transform parent = new GameObject("parent").transform;
            parent.position = new Vector3(10, 0, 0);
            var original = new GameObject("original");
            original.transform.position = new Vector3(1, 2, 3);
            original.transform.localScale = new Vector3(2, 2, 2);
            GameObject under = Object.Instantiate(original, parent);
            Assert.That(under.transform.localPosition, Is.EqualTo(new Vector3(1, 2, 3)));
            GameObject at = Object.Instantiate(original, new Vector3(4, 5, 6), Quaternion.Euler(0, 90, 0), parent);
            Assert.That(at.transform.position == new Vector3(4, 5, 6));
            Assert.That(at.transform.localScale, Is.EqualTo(new Vector3(2, 2, 2)));
        }

        [Test]
        public void A_prefab_sleeps_and_its_copies_wake()
        {
            GameObject prefab = ObjectFactory.CreateGameObject("prefab", default);
            ObjectFactory.AddComponent(prefab, typeof(Teller));
            ObjectFactory.Wake(new[] { prefab });
            Assert.That(prefab.activeInHierarchy, Is.False);
            Assert.That(Story.Take(), Is.Empty);
            GameObject made = Object.Instantiate(prefab);
            Assert.That(Story.Take(), Is.EqualTo(new[] { "prefab(Clone) Awake", "prefab(Clone) OnEnable" }));
            Assert.That(made.scene == SceneManager.GetActiveScene());
            Assert.That(Object.FindObjectsByType<Teller>(FindObjectsInactive.Include, FindObjectsSortMode.None), Has.Length.EqualTo(1));
        }

        class NotStored : MonoBehaviour
        {
            public Dictionary<int, int> table = new Dictionary<int, int>();
            public HashSet<int> set;
            public Inner[,] grid;
            public List<List<int>> nested;
            public Action action;
            public object anything;
            public readonly int[] fixedArray = { 1 };
            public Plane plane;
            [HideInInspector] public int hiddenButStored;
        }

        [Test]
        public void What_Unity_does_not_store_is_no_serialized_field()
            => Assert.That(SerializedFields.Of(typeof(NotStored)).Where(f => f.DeclaringType == typeof(NotStored)).Select(f => f.Name),
                Is.EqualTo(new[] { "hiddenButStored" }));

        class Node { public int value; public Node next; }

        class WithReferences : MonoBehaviour
        {
            [SerializeReference] public object a;
            [SerializeReference] public object b;
        }

        [Test]
        public void References_to_one_object_stay_references_to_one_object()
        {
            WithReferences original = Add<WithReferences>();
            original.a = original.b = new Node { value = 5 };
            WithReferences copy = Object.Instantiate(original);
            Assert.That(copy.a, Is.SameAs(copy.b).And.Not.SameAs(original.a));
            Assert.That(((Node)copy.a).value, Is.EqualTo(5));
        }

        class Asset : ScriptableObject
        {
            public int number = 1;
            void Awake() => Story.Tell("Awake");
            void OnEnable() => Story.Tell("OnEnable");
            void OnDisable() => Story.Tell("OnDisable");
            void OnDestroy() => Story.Tell("OnDestroy");
        }

        [Test]
        public void A_ScriptableObject_wakes_when_created_and_copied_and_hears_of_its_end()
        {
            Asset asset = ScriptableObject.CreateInstance<Asset>();
            asset.number = 8;
            Asset copy = Object.Instantiate(asset);
            Assert.That(copy.number, Is.EqualTo(8));
            Object.DestroyImmediate(asset);
            Object.DestroyImmediate(copy);
            Assert.That(Story.Take(), Is.EqualTo(new[] { "Awake", "OnEnable", "Awake", "OnEnable", "OnDisable", "OnDestroy", "OnDisable",
                "OnDestroy" }));
        }

        class Receiver : MonoBehaviour
        {
            void Hear(int value) => Story.Tell($"{name} heard {value}");
            void Quiet() => Story.Tell($"{name} quiet");
        }

        [Test]
        public void Messages_reach_scripts_by_name_and_a_missing_receiver_is_an_error()
        {
            Receiver a = Add<Receiver>("a"), b = Add<Receiver>("b");
            b.transform.SetParent(a.transform);
            a.SendMessage("Hear", 3);
            a.BroadcastMessage("Quiet");
            b.SendMessageUpwards("Quiet");
            Assert.That(Story.Take(), Is.EqualTo(new[] { "a heard 3", "a quiet", "b quiet", "b quiet", "a quiet" }));
            a.SendMessage("Nothing", SendMessageOptions.DontRequireReceiver);
            a.SendMessage("Nothing");
            Assert.That(Errors().Single(), Does.Contain("Nothing"));
        }
    }
}
