using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Runtime.ExceptionServices;
using Host.Assets;
using Host.Vulkan;
using UnityEditor;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.SceneManagement;

namespace Host
{
    /// <summary>A player with a device and a project's assets, from start to the count of what it left.</summary>
    sealed class Session : IDisposable
    {
        readonly VulkanDevice device;
        readonly ProjectAssets assets;
        readonly HashSet<string> said = new();
        readonly IDisposable ofPackage = BuiltInPackage.Current.Begin();
        int warned;
        readonly List<string> dropped = new();
        readonly List<UnityEngine.Object> preloaded = new();      // as in a player: loaded before the first script runs, and kept
        ExceptionDispatchInfo fault;

        /// <param name="root">A Unity project's or package's folder.</param>
        /// <param name="mounts">Null: those of the root.</param>
        /// <param name="scripts">Assemblies with scripts beside the package's.</param>
        /// <param name="player">As a built player rather than the Editor: without Editor scripts, so that only what the scene refers to is
        /// there.</param>
        /// <param name="foreign">Of a project that the host was not built with; its scripts are all there are.</param>
        /// <param name="editor">Of such a project: as the Editor, whose initializers run, rather than as a player.</param>
        public Session(string root, List<MountedFolder> mounts = null, IEnumerable<Assembly> scripts = null, bool validation = false,
            bool strict = true, bool compute = true, bool player = false, IForeignTypes foreign = null, bool editor = false)
        {
            // Messages end as the command's output, each once: a fault in Update comes back every frame.
            LogSink.Received += Hear;
            LogSink.Writer = Print;
            device = new VulkanDevice(validation);
            Player.Device = device;
            Player.Strict = strict;
            Player.PretendNoCompute = !compute;

            // A foreign project may bring the package as source: then its own assemblies count, and the host's would be second ones of the same name.
            IEnumerable<Assembly> package = foreign != null ? Enumerable.Empty<Assembly>()
                : BuiltInPackage.Current.Assemblies.Where(name => File.Exists(Path.Combine(AppContext.BaseDirectory, name + ".dll")))
                .Select(Assembly.Load);
            assets = new ProjectAssets(mounts ?? ProjectFolders.Of(root), package.Concat(scripts ?? Enumerable.Empty<Assembly>()).ToList(),
                strict, foreign);
            Player.Assets = assets;
            SceneManager.SceneLoader = name => SceneAsset.Load(assets, name);
            // Entering play mode: statics and times go back to their start, then the project's settings apply.
            PlayerLoop.Reset();
            ProjectSettings.Apply(root, path => assets.ResolvePath(path) != null);
            foreach (KeyValuePair<Type, int> order in assets.ExecutionOrders())
                ExecutionOrder.FromMeta[order.Key] = order.Value;
            if (player)
                BuiltInPackage.Current.EnterPlayer();
            else if (foreign == null || editor)
                EditorInitializers.Run();
            if (player || foreign != null && !editor)
                preloaded = Preload(root);
            Initializers.Run(RuntimeInitializeLoadType.AfterAssembliesLoaded);
            Initializers.Run(RuntimeInitializeLoadType.BeforeSplashScreen);
            Initializers.Run(RuntimeInitializeLoadType.BeforeSceneLoad);
        }

        List<UnityEngine.Object> Preload(string root)
        {
            var found = new List<UnityEngine.Object>();
            foreach (FileReference reference in ProjectSettings.PreloadedAssets(root))
                if (assets.LoadAsset(reference.Guid, reference.FileId, typeof(UnityEngine.Object)) is UnityEngine.Object asset)
                    found.Add(asset);
                else
                    Debug.LogWarning($"Preloaded Assets of the player settings: {reference.Location}: no asset of the project has the guid " +
                        $"{reference.Guid} and the file id {reference.FileId}. Take the entry out, or bring the asset back.");
            return found;
        }

        /// <summary>For the scene's project; <see cref="LoadScene"/> opens it.</summary>
        public Session(LocatedScene scene, bool strict = true, bool compute = true, bool player = false)
            : this(scene.Root, scene.Mounts, strict: strict, compute: compute, player: player) { }

        public DeviceInfo Info => device.Info;

        /// <summary>Strict: throws the first fault that a script's use of the graphics API raised. The loop has caught and logged it, as it
        /// does with every exception of a script.</summary>
        public void ThrowFault() => fault?.Throw();

        public IReadOnlyList<string> ValidationMessages => device.ValidationMessages;

        /// <summary>Errors, exceptions and assertions that scripts or the engine logged.</summary>
        public int ErrorsLogged { get; private set; }

        /// <summary>The folder that the command line works on: RILL_ROOT, or the project or package around the current folder.</summary>
        public static string Root()
        {
            string here = Directory.GetCurrentDirectory();
            return Environment.GetEnvironmentVariable("RILL_ROOT") ?? ProjectFolders.RootOf(here)
                ?? throw new HostException($"{here} lies in no Unity project and no package, and RILL_ROOT is not set.");
        }

        /// <summary>A scene by what the user typed: a path, or a name that is looked for around the current folder, then in the package.</summary>
        public static LocatedScene Locate(string scene)
        {
            string here = Directory.GetCurrentDirectory();
            bool isPath = File.Exists(scene) || Directory.Exists(scene);
            return SceneLocator.Find(scene, isPath || ProjectFolders.RootOf(here) != null ? here : Root());
        }

        public string DescribeDevice() => $"{Info.Name} ({Info.Driver}, {Info.Api}{(Info.IsSoftware ? ", in software" : "")})";

        public void LoadScene(LocatedScene scene)
        {
            SceneManager.LoadNow(scene.AssetPath, LoadSceneMode.Single);
            Initializers.Run(RuntimeInitializeLoadType.AfterSceneLoad);
            foreach (string problem in assets.Index.Summary())
                Console.Error.WriteLine("warning: " + problem);
            PrintWarnings();
            ThrowFault();
        }

        /// <summary>Prints the warnings since the last call.</summary>
        public void PrintWarnings()
        {
            for (; warned < assets.Warnings.Count; warned++)
                Console.Error.WriteLine("warning: " + assets.Warnings[warned]);
        }

        public ProjectAssets Assets => assets;

        /// <summary>Destroys the scene and names the objects with GPU memory that outlived it, or were dropped without a release.</summary>
        public List<string> End()
        {
            PlayerLoop.Reset();
            assets.ReloadAll();
            List<string> left = dropped.Concat(LiveObjects.Report()).ToList();
            Gpu.Reset();
            device.WaitIdle();
            // Nothing that the engine knows of, and yet the device holds something: a fault of the host itself.
            if (left.Count == 0 && device.LiveResources > 0)
                left.Add($"{device.LiveResources} resources of the device that no object owns");
            return left;
        }

        public void Dispose()
        {
            LogSink.Received -= Hear;
            PlayerLoop.Reset();
            Gpu.Reset();
            ofPackage?.Dispose();
            Player.Device = null;
            Player.Assets = null;
            device.Dispose();
        }

        void Hear(LogEntry entry)
        {
            if (entry.Type is LogType.Error or LogType.Exception or LogType.Assert)
                ErrorsLogged++;
            // The engine's warning about a buffer that its finalizer had to release; the name stands in the last brackets.
            if (Player.Strict && entry.Type == LogType.Warning && entry.Message.StartsWith("GarbageCollector disposing of", StringComparison.Ordinal))
                dropped.Add(entry.Message.Substring(entry.Message.LastIndexOf('(')).Trim('(', ')'));
            if (IsFault(entry))
                fault ??= ExceptionDispatchInfo.Capture(entry.Exception);
        }

        static bool IsFault(LogEntry entry) => Player.Strict
            && entry.Exception is GpuUsageException or ShaderCompileException or OutOfGpuMemoryException;

        void Print(LogEntry entry)
        {
            if (IsFault(entry) || !said.Add(entry.Type + entry.Message))
                return;
            if (entry.Type == LogType.Log)
                Console.Out.WriteLine(entry.Message);
            else
                Console.Error.WriteLine($"{entry.Type.ToString().ToLowerInvariant()}: {entry.Message}");
            if (entry.Exception != null && Environment.GetEnvironmentVariable("RILL_TRACE") == "1")
                Console.Error.WriteLine(entry.StackTrace);
        }
    }
}
