using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection.Metadata;
using Host.Check.Api;
using Host.UnityApi;

namespace Host.Check
{
    /// <summary>
    /// Methods that Unity may call on another thread call nothing of Unity's that needs the main one: OnValidate, constructors and field initializers
    /// of its objects, and callbacks of serialization. Followed through the package's calls, with every override that a call may reach and
    /// every method that a delegate field is given.
    /// </summary>
    /// <remarks>
    /// Scripting API, MonoBehaviour.OnValidate (2022.3): it "can be called from threads other than Unity's main thread, such as the loading
    /// thread", and is there to validate data alone. Manual, Script serialization: constructors, field initializers and callbacks are called
    /// where most of Unity's API throws.
    /// </remarks>
    sealed class UnsafeMomentsRule : Rule
    {
        /// <summary>Types whose members are plain arithmetic or data, or that Unity documents or marks as thread safe.</summary>
        static readonly HashSet<string> SafeTypes = new()
        {
            "UnityEngine.Vector2", "UnityEngine.Vector3", "UnityEngine.Vector4", "UnityEngine.Vector2Int", "UnityEngine.Vector3Int",
            "UnityEngine.Quaternion", "UnityEngine.Matrix4x4", "UnityEngine.Mathf", "UnityEngine.Color", "UnityEngine.Color32",
            "UnityEngine.Rect", "UnityEngine.RectInt", "UnityEngine.Bounds", "UnityEngine.BoundsInt", "UnityEngine.Plane", "UnityEngine.Ray",
            "UnityEngine.LayerMask", "UnityEngine.Hash128", "UnityEngine.RangeInt", "UnityEngine.AnimationCurve", "UnityEngine.Keyframe",
            "UnityEngine.Gradient", "UnityEngine.GradientColorKey", "UnityEngine.GradientAlphaKey", "UnityEngine.GUIContent",
            "UnityEngine.Events.UnityEventBase", "UnityEngine.Events.UnityEvent", "UnityEngine.Events.UnityEvent`1", "UnityEngine.RectOffset",
            "Unity.Profiling.ProfilerMarker", "UnityEngine.Rendering.ShaderTagId",
        };
        /// <summary>Single members that are thread safe: marked so in Unity's source, or managed code alone.</summary>
        static readonly HashSet<string> SafeMembers = new()
        {
            "UnityEngine.Debug.Log", "UnityEngine.Debug.LogWarning", "UnityEngine.Debug.LogError", "UnityEngine.Debug.LogException",
            "UnityEngine.Shader.PropertyToID", "UnityEngine.Object.op_Equality", "UnityEngine.Object.op_Inequality",
            "UnityEngine.Object.op_Implicit", "UnityEngine.Object.Equals", "UnityEngine.Object.GetHashCode",
        };

        const int MaxPerRoot = 3;

        readonly IReadOnlyList<string> names;

        public UnsafeMomentsRule(IReadOnlyList<string> assemblies = null) => names = assemblies ?? PackageAssemblies.WithoutTests;

        public override string Name => "code: OnValidate, constructors and serialization callbacks need no main thread";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            using var types = new PackageTypes(package, names, findings);
            var graph = new CallGraph(types);
            int roots = 0;
            var reached = new HashSet<PackageMethod>();
            foreach (PackageMethod root in types.All.SelectMany(type => Roots(types, type)).ToList())
            {
                roots++;
                Walk(graph, root, reached, findings);
            }
            findings.Looked = $"{roots} methods that Unity may call on another thread, {reached.Count} that they reach";
            return findings;
        }

        static IEnumerable<PackageMethod> Roots(PackageTypes types, PackageType type)
        {
            bool isObject = IsObject(types, type);
            bool receives = type.Definition.GetInterfaceImplementations().Any(handle => CompiledTypeNames.Of(type.Assembly.Metadata,
                type.Assembly.Metadata.GetInterfaceImplementation(handle).Interface).Key == "UnityEngine.ISerializationCallbackReceiver");
            foreach (PackageMethod method in type.Methods)
            {
                if (isObject && method.Name is "OnValidate" or ".ctor" or ".cctor"
                    || receives && method.ShortName is "OnBeforeSerialize" or "OnAfterDeserialize")
                    yield return method;
            }
        }

        static bool IsObject(PackageTypes types, PackageType type) => types.ForeignBase(type) is { } parent
            && UnityCatalogs.All.Any(unity => unity.Find(parent.Key) is { } listed
                && unity.Lineage(listed).Any(inherited => inherited.Type.Key == "UnityEngine.Object"));

        // Each method once: what it calls is told of the first that reaches it, with the shortest path. One call leads to many, so a few do.
        static void Walk(CallGraph graph, PackageMethod root, HashSet<PackageMethod> reached, Findings findings)
        {
            var from = new Dictionary<PackageMethod, PackageMethod> { [root] = null };
            var open = new Queue<PackageMethod>();
            int told = 0;
            open.Enqueue(root);
            while (open.Count > 0)
            {
                PackageMethod method = open.Dequeue();
                if (!reached.Add(method))
                    continue;
                foreach (string called in graph.ForeignCalls(method).Where(IsUnsafe).Distinct().TakeWhile(_ => told++ < MaxPerRoot))
                    findings.Fault($"{root.Type.Assembly.Name}.dll: {Path(method, from)} calls {called}, which needs the main thread: let what " +
                        $"Unity calls there check data alone, and do the rest where the change is applied");
                foreach (PackageMethod next in graph.Calls(method))
                    if (from.TryAdd(next, method))
                        open.Enqueue(next);
            }
        }

        static string Path(PackageMethod method, Dictionary<PackageMethod, PackageMethod> from)
        {
            string path = method.ToString();
            for (method = from[method]; method != null; method = from[method])
                path = $"{method} > {path}";
            return path;
        }

        static bool IsUnsafe(string called)
        {
            int dot = called.LastIndexOf('.', called.Length - 1);
            while (dot > 0 && called[dot - 1] == '.')       // "..ctor"
                dot--;
            string type = called.Substring(0, dot), member = called.Substring(dot + 1);
            return (type.StartsWith("UnityEngine.", StringComparison.Ordinal) || type.StartsWith("UnityEditor.", StringComparison.Ordinal)
                    || type.StartsWith("Unity.", StringComparison.Ordinal) && !type.StartsWith("Unity.Mathematics.", StringComparison.Ordinal))
                && !SafeTypes.Contains(type) && !SafeMembers.Contains(called) && !IsBaseConstructor(type, member);
        }

        static bool IsBaseConstructor(string type, string member) => member == ".ctor" && (type.EndsWith("Attribute", StringComparison.Ordinal)
            || UnityCatalogs.All.Any(unity => unity.Find(type) is { } listed && (listed.Kind == ApiKind.Struct
                || type is "UnityEngine.MonoBehaviour" or "UnityEngine.ScriptableObject" || listed.Kind == ApiKind.Class
                && IsScript(unity, listed))));

        // Tells whether only heirs construct it: an Editor, a window, an asset.
        static bool IsScript(ApiCatalog unity, ApiType type) => unity.Lineage(type).Any(inherited =>
            inherited.Type.Key is "UnityEngine.MonoBehaviour" or "UnityEngine.ScriptableObject");
    }
}
