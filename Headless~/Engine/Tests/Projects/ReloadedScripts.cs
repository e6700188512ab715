using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using Host.Tests;
using UnityEditor;
using UnityEngine;
using UnityEngine.Events;
using UnityEngine.Rendering;

// The scripts of EngineReloadTests.
namespace Reloaded
{
    public abstract class Teller : MonoBehaviour, ISerializationCallbackReceiver
    {
        protected Teller() => Tell("constructed");
        void Awake() => Tell("Awake");
        void Start() => Tell("Start");
        void OnEnable() => Tell("OnEnable");
        void OnDisable() => Tell("OnDisable");
        void OnValidate() => Tell("OnValidate");
        void Update() => Tell("Update");
        public void OnBeforeSerialize() => Tell("OnBeforeSerialize");
        public void OnAfterDeserialize() => Tell("OnAfterDeserialize");
        void Tell(string what) => Story.Tell($"{GetType().Name} {what}");
    }

    [DefaultExecutionOrder(-10)] public class Early : Teller { }
    [DefaultExecutionOrder(10)] public class Late : Teller { }
    [ExecuteAlways] public class Always : Teller { }

    public class Asset : ScriptableObject, ISerializationCallbackReceiver
    {
        public Asset() => Story.Tell("Asset constructed");
        void Awake() => Story.Tell("Asset Awake");
        void OnEnable() => Story.Tell("Asset OnEnable");
        void OnDisable() => Story.Tell("Asset OnDisable");
        void OnValidate() => Story.Tell("Asset OnValidate");
        public void OnBeforeSerialize() => Story.Tell("Asset OnBeforeSerialize");
        public void OnAfterDeserialize() => Story.Tell("Asset OnAfterDeserialize");
    }

    static class Watch
    {
        [InitializeOnLoadMethod]
        static void Begin()
        {
            Story.Tell("[InitializeOnLoadMethod]");
            AssemblyReloadEvents.beforeAssemblyReload += () => Story.Tell("before");
            AssemblyReloadEvents.afterAssemblyReload += () => Story.Tell("after");
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.AfterSceneLoad)]
        static void AtPlay() => Story.Tell("[RuntimeInitializeOnLoadMethod]");
    }

    [InitializeOnLoad]
    static class WatchClass
    {
        static WatchClass() => Story.Tell("[InitializeOnLoad]");
    }

    public class ValuesBase : MonoBehaviour
    {
        int ofBase;
        protected void FillBase() => ofBase = 8;
        protected string DescribeBase() => $"ofBase: {ofBase}";
    }

    public class Values : ValuesBase
    {
        [Serializable]
        public class Nested
        {
            string text;
            [NonSerialized] int skipped;
            int[] none;
            [NonSerialized] string initial = "initial";

            public static Nested Filled() => new Nested { text = "filled", skipped = 3, initial = "changed" };
            public override string ToString() => $"{(text == null ? "null" : text.Length == 0 ? "''" : text)} {skipped} " +
                $"[{string.Join(" ", none ?? new[] { -1 })}] {initial}";
        }

        [Serializable]
        struct Element
        {
            public int shown;
            [NonSerialized] public int hidden;
        }

        struct Unmarked { public int value; }
        class UnmarkedClass { }
        class Owner { public Values of; }
        interface IAny { }
        [Serializable] class Any : IAny { public string text; }

        [SerializeField] int setting = 4;
        string text = "initial", noText = "initial";
        int[] none = { 1 };
        List<int> noList = new List<int> { 1 }, list;
        Nested nested, noNested;
        Element[] structs;
        Transform reference;
        GameObject destroyed;
        AnimationCurve curve;
        [NonSerialized] string skipped = "initial";
        readonly List<int> constant = new List<int> { 1 };
        Dictionary<int, int> dictionary;
        Action callback;
        UnityEvent listeners = new UnityEvent();
        UnmarkedClass unmarked;
        Unmarked unmarkedStruct;
        int[,] table;
        int? maybe;
        object any;
        readonly Owner owner;
        string missing;
        [SerializeReference] IAny managed;
        int heard;

        public int Property { get; private set; }
        [field: NonSerialized] public int SkippedProperty { get; private set; }

        public Values() => owner = new Owner { of = this };

        public void Fill(GameObject other)
        {
            FillBase();
            setting = 5;
            text = missing = "filled";
            noText = null;
            none = null;
            noList = null;
            list = new List<int> { 1, 2 };
            nested = Nested.Filled();
            noNested = null;
            structs = new[] { new Element { shown = 3, hidden = 4 } };
            reference = other.transform;
            destroyed = new GameObject("gone");
            destroyed.transform.parent = other.transform;
            curve = null;
            Property = SkippedProperty = 7;
            skipped = "changed";
            constant.Add(2);
            dictionary = new Dictionary<int, int>();
            callback = () => { };
            listeners.AddListener(() => heard++);
            unmarked = new UnmarkedClass();
            unmarkedStruct.value = 3;
            table = new int[2, 2];
            maybe = 3;
            any = this;
            managed = new Any { text = "kept" };
        }

        public string[] Tell()
        {
            heard = 0;
            listeners.Invoke();
            return new[]
            {
                $"setting: {setting}", $"text: {Shown(text)}", $"noText: {Shown(noText)}", $"none: {none?.Length}", $"noList: {noList?.Count}",
                $"list: {string.Join(" ", list)}", $"nested: {nested}", $"noNested: {noNested}",
                $"structs: {string.Join(" ", structs.Select(e => $"{e.shown}/{e.hidden}"))}", $"reference: {Name(reference)}",
                $"destroyed: {Name(destroyed)}", $"curve: {curve?.length}", $"property: {Property}", $"skipped: {skipped}",
                $"skippedProperty: {SkippedProperty}", $"constant: {string.Join(" ", constant)}", $"dictionary: {Shown(dictionary)}",
                $"callback: {Shown(callback)}", $"listeners: {heard}", $"unmarked: {Shown(unmarked)}", $"unmarkedStruct: {unmarkedStruct.value}",
                $"table: {Shown(table)}", $"maybe: {Shown(maybe)}", $"any: {Shown(any)}", $"owner: {(owner.of == this ? "itself" : "another")}",
                $"missing: {Shown(missing)}", DescribeBase(), $"managed: {(managed as Any)?.text}",
            };
        }

        static string Shown(object value) => value == null ? "null" : value is string text && text.Length == 0 ? "''" : value.ToString();
        static string Name(UnityEngine.Object o) => ReferenceEquals(o, null) ? "null" : o == null ? "destroyed" : o.name;
    }

    [CustomEditor(typeof(Values))]
    public class ValuesEditor : Editor
    {
        void OnEnable() => Story.Tell($"ValuesEditor OnEnable of {target.name}");
        void OnDisable() => Story.Tell("ValuesEditor OnDisable");
    }

    public class Window : EditorWindow
    {
        void OnEnable() => Story.Tell("Window OnEnable");
        void OnDisable() => Story.Tell("Window OnDisable");
    }

    public static class Statics
    {
        // Before what it uses, by name and by position.
        static readonly List<int> shared = Used.list;
        static readonly List<int> numbers = new List<int> { 1 };
        static int count = 3;
        static string text;
        static string Property { get; set; } = "first";

        public static void Change()
        {
            count = 9;
            numbers.Add(2);
            text = "text";
            Property = "changed";
            Used.list = new List<int> { 5 };
        }

        public static string Tell() => $"{count}, {string.Join(" ", numbers)}, {text}, {Used.list.Count} of " +
            $"{(shared == Used.list ? "one" : "other")} list, {Property}";

        static class Used
        {
            public static List<int> list = new List<int>();
        }
    }

    public class Listener : MonoBehaviour
    {
        [NonSerialized] bool throws;

        public void Listen()
        {
            Application.quitting += () => Story.Tell("heard quitting");
            EditorApplication.update += Hear;
            EditorApplication.delayCall += Hear;
            EditorApplication.hierarchyChanged += Hear;
            Camera.onPreCull += camera => Hear();
            Undo.undoRedoPerformed += Hear;
            RenderPipelineManager.beginCameraRendering += (context, camera) => Hear();
            AssemblyReloadEvents.beforeAssemblyReload += Hear;
        }

        public void Begin()
        {
            StartCoroutine(Run());
            InvokeRepeating(nameof(Called), 0f, 0.01f);
        }

        public void ThrowBefore()
        {
            AssemblyReloadEvents.beforeAssemblyReload += () => throw new InvalidOperationException("thrown before");
            throws = true;
        }

        public static void OnReadback(AsyncGPUReadbackRequest request) => Story.Tell("heard a read-back");

        void OnDisable()
        {
            if (throws)
                throw new InvalidOperationException("thrown by OnDisable");
        }

        void Hear() => Story.Tell("heard");
        void Called() => Story.Tell("invoked");

        IEnumerator Run()
        {
            while (true)
            {
                Story.Tell("coroutine");
                yield return null;
            }
        }
    }
}
