using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace Host.Pipelines
{
    /// <summary>The pipeline that draws the cameras, with a package's adapters, until it is disposed of.</summary>
    sealed class PlayedPipeline : IDisposable
    {
        // Loaded code stays: one context for each version and folder of adapters.
        static readonly Dictionary<(PipelineVersion, string, bool), PipelineContext> contexts = new();

        readonly PipelineContext context;

        public PipelineVersion Version { get; }

        /// <summary>The stand-in's asset: a new one, with all settings at their defaults.</summary>
        public RenderPipelineAsset Asset { get; }

        PlayedPipeline(PipelineKind kind, PipelineVersion version, PipelineContext context, bool byExecute)
        {
            Version = version;
            this.context = context;
            (Player.PipelineTag, Player.PipelinePackage, Player.PipelineVersion) = (kind.Tag, kind.Package, version.Package);
            context[PipelineKind.Universal.Assembly].GetType("UnityEngine.Rendering.Universal.UniversalRenderPipeline")
                .GetField("IsCompatibilityMode", BindingFlags.Static | BindingFlags.NonPublic).SetValue(null, byExecute);
            Asset = (RenderPipelineAsset)ScriptableObject.CreateInstance(context[kind.Assembly].GetType(kind.Asset, true));
            GraphicsSettings.defaultRenderPipeline = Asset;
            RenderPipelineManager.Prepare();
        }

        /// <param name="root">Of the package whose adapters come along; null: none.</param>
        /// <param name="byExecute">In Compatibility Mode, by the passes' Execute; before 17 there is nothing else.</param>
        /// <param name="editor">With what the adapter has for the editor alone.</param>
        /// <exception cref="InvalidOperationException">The adapter does not compile.</exception>
        public static PlayedPipeline Start(PipelineKind kind, PipelineVersion version, string root, bool byExecute = false,
            bool editor = false) => new(kind, version, Load(version, root, editor), byExecute);

        /// <summary>Stand-ins and adapters, so that initializers of theirs run with those of the project.</summary>
        public static PipelineContext Load(PipelineVersion version, string root, bool editor = false)
        {
            if (contexts.TryGetValue((version, root, editor), out PipelineContext found))
                return found;
            PipelineAssemblies assemblies = PipelineAssemblies.Of(version);
            var made = new PipelineContext(assemblies);
            foreach (PipelineKind kind in PipelineKind.All)
            {
                AdapterDefinition adapter = AdapterDefinition.Find(root, kind);
                if (adapter == null)
                    continue;
                byte[] image = assemblies.CompileAdapter(adapter, editor, out List<string> errors);
                if (errors.Count > 0)
                    throw new InvalidOperationException($"{adapter.Name} does not compile for {version}:\n{string.Join("\n", errors)}");
                made.Add(adapter.Name, image);
            }
            return contexts[(version, root, editor)] = made;
        }

        /// <summary>Scripts over the stand-ins, compiled and loaded.</summary>
        public Assembly AddScripts(string name, string source)
        {
            byte[] image = PipelineAssemblies.Of(Version).CompileScripts(name, source, out List<string> errors);
            return image != null && errors.All(error => !error.Contains(": error ")) ? context.Add(name, image)
                : throw new InvalidOperationException(string.Join("\n", errors));
        }

        public Assembly this[string assembly] => context[assembly];

        public void Dispose()
        {
            (Player.PipelineTag, Player.PipelinePackage, Player.PipelineVersion) = ("", null, null);
            GraphicsSettings.defaultRenderPipeline = null;
            if (Player.Device != null)
                RenderPipelineManager.Prepare();
            if (Asset != null)
                Object.DestroyImmediate(Asset);
        }
    }
}
