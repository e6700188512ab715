using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Runtime.Loader;
using Host.Assets;
using Host.Scripts.Assemblies;
using Host.Scripts.Compiling;
using Host.Scripts.Stubs;

namespace Host.Scripts
{
    /// <summary>A project's scripts, compiled from source and loaded.</summary>
    internal sealed class ProjectScripts : IForeignTypes
    {
        readonly List<CompiledAssembly> compiled = new List<CompiledAssembly>();
        readonly AssemblyLoadContext context;
        readonly StubAssembly stubs;
        readonly Assembly stubCode;

        /// <summary>The project's own assemblies.</summary>
        public readonly List<Assembly> Assemblies = new List<Assembly>();
        public readonly AssemblyPlan Plan;
        public readonly Packages Packages;
        public readonly List<string> Notes = new List<string>();

        /// <param name="index">The project's files, packages included.</param>
        /// <param name="tests">What tests are compiled against; null: what is compiled is a player.</param>
        /// <exception cref="ScriptException">The assembly definitions contradict each other, or a script has errors of syntax.</exception>
        public ProjectScripts(string project, ProjectIndex index, TestAssemblies tests = null)
        {
            var hosted = StubAssembly.Host.ToDictionary(a => a.GetName().Name);
            Packages = new Packages(project, index.Mounts, tests != null);
            stubs = StubAssembly.Get();
            foreach (var assembly in tests?.All ?? Array.Empty<Assembly>()) hosted.Add(assembly.GetName().Name, assembly);
            Plan = new AssemblyPlan(project, index, Packages, hosted.Keys.Append(StubAssembly.UserInterface), tests != null);
            var compiler = new ScriptCompiler(index, stubs, hosted);
            foreach (var assembly in Plan.Assemblies) compiled.Add(compiler.Compile(assembly));

            // A context of its own: the project may bring an assembly of the same name as one that the host was built with, and means its own.
            context = new ProjectContext(compiled.ToDictionary(c => c.Name, c => c.File), stubs, Plan.Plugins);
            stubCode = context.LoadFromAssemblyName(new AssemblyName(StubAssembly.Name));
            foreach (var assembly in compiled) Assemblies.Add(context.LoadFromAssemblyName(new AssemblyName(assembly.Name)));
            Notes.AddRange(Packages.Notes.Concat(Plan.Notes).Concat(compiler.Notes));
        }

        /// <summary>Those with the project's tests.</summary>
        public IEnumerable<Assembly> Tests => Assemblies.Where((assembly, i) => Plan.Assemblies[i].HoldsTests);

        /// <summary>Files that were left out, each with the assembly that it belongs to.</summary>
        public IEnumerable<(ScriptAssembly Assembly, LeftOutFile File)> LeftOutOf
            => compiled.SelectMany((assembly, i) => assembly.LeftOut.Select(file => (Plan.Assemblies[i], file)));

        public int Files => compiled.Sum(c => c.Scripts);
        public IEnumerable<LeftOutFile> LeftOut => compiled.SelectMany(c => c.LeftOut);
        public IEnumerable<(string name, int files, int leftOut)> Compiled => compiled.Select(c => (c.Name, c.Scripts, c.LeftOut.Count));

        /// <summary>Why a script has no class here; null when it should have one.</summary>
        public string WhyMissing(string assetPath) =>
            LeftOut.FirstOrDefault(f => f.Path == assetPath)?.Error is string error ? "it does not compile against the host: " + error
            : Plan.NotForPlayers.TryGetValue(assetPath, out var reason) ? reason : null;

        /// <summary>A component that exists by name only; null when there is none.</summary>
        public Type StubComponent(string name) => stubCode.GetType("UnityEngine." + name) is Type type
            && typeof(UnityEngine.Component).IsAssignableFrom(type) && !type.IsAbstract ? type : null;

        /// <summary>Scripts of com.unity.ugui, when the project has that package.</summary>
        public Type PackageScript(string guid) =>
            UserInterfaceScripts.NameOf(guid) is string name && Packages.VersionOf("com.unity.ugui") != null
            ? context.LoadFromAssemblyName(new AssemblyName(StubAssembly.UserInterface)).GetType(name) : null;

        public bool IsStub(Type type) => type.Assembly == stubCode || type.Assembly.GetName().Name == StubAssembly.UserInterface;

        /// <summary>Missing members that scripts called, and how often.</summary>
        public IReadOnlyList<KeyValuePair<string, int>> StubCalls =>
            ((IEnumerable<KeyValuePair<string, int>>)stubCode.GetType("UnityEngine.Headless.StubCalls")
            .GetField("Called", BindingFlags.Static | BindingFlags.NonPublic).GetValue(null)).ToList();

        sealed class ProjectContext : AssemblyLoadContext
        {
            readonly Dictionary<string, string> files;

            public ProjectContext(Dictionary<string, string> compiled, StubAssembly stubs, IEnumerable<AssetEntry> plugins) : base("project")
            {
                files = new Dictionary<string,
                    string>(compiled) { [StubAssembly.Name] = stubs.File, [StubAssembly.UserInterface] = stubs.UserInterfaceFile };
                foreach (var plugin in plugins) files.TryAdd(plugin.Name, plugin.File);
            }

            protected override Assembly Load(AssemblyName name) => files.TryGetValue(name.Name, out var file)
                ? LoadFromAssemblyPath(Path.GetFullPath(file)) : null;
        }
    }
}
