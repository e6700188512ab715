using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using Host.Assets;
using Host.Check.Api;
using Host.Pipelines;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.SceneManagement;

namespace Host.Check
{
    /// <summary>Values that scenes and assets store are read by a field of the class: a renamed field without [FormerlySerializedAs] loses its
    /// values in silence.</summary>
    sealed class ScriptFieldsRule : Rule
    {
        public override string Name => "package: fields stored in scenes and assets exist in their classes";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            List<Assembly> scripts = PackageScripts.Load(package, findings);
            ProjectIndex index = ProjectView.Index(package);
            int files = 0, objects = 0;
            var log = new List<string>();
            void Hear(LogEntry entry) { if (entry.Type != LogType.Log) log.Add(entry.Message); }

            IAssetSource before = Player.Assets;
            Action<LogEntry> writer = LogSink.Writer;
            LogSink.Received += Hear;
            LogSink.Writer = _ => { };
            var project = new ProjectAssets(ProjectView.Mounts(package), scripts, strict: false);
            Player.Assets = project;
            try
            {
                foreach (AssetEntry entry in ProjectView.Documents(index))
                {
                    files++;
                    try
                    {
                        objects += UnityYaml.Load(entry.File, entry.Path).Documents.Count;
                        if (entry.Extension == ".unity")
                            project.ReadScene(entry);
                        else
                            project.LoadAtPath(entry.Path, typeof(UnityEngine.Object));
                    }
                    catch (AssetException e)
                    {
                        findings.Fault(e.Message);
                    }
                }
                foreach (string warning in project.Warnings.Concat(log).Distinct())
                    findings.Fault(warning);
            }
            finally
            {
                SceneManager.UnloadEverything();
                project.ReloadAll();
                Player.Assets = before;
                LogSink.Received -= Hear;
                LogSink.Writer = writer;
            }
            findings.Looked = $"{objects} objects in {files} files";
            return findings;
        }
    }

    /// <summary>The package's assemblies as built here.</summary>
    static class PackageScripts
    {
        const string Samples = "Rill.Samples";

        /// <summary>Those of the definitions, and that of the samples' scripts; one that was not built is a fault.</summary>
        public static List<Assembly> Load(PackageTree package, Findings findings, bool withTests = false)
        {
            var loaded = new List<Assembly>();
            List<AssemblyDefinition> definitions = AssemblyDefinition.All(package, findings).Where(a => withTests || !a.IsTest).ToList();
            IEnumerable<string> names = definitions.Where(a => !a.IsAdapter).Select(a => a.Name);
            if (package.WithExtension(".cs").Any(f => f.StartsWith("Samples~/", StringComparison.Ordinal)))
                names = names.Append(Samples);
            foreach (string name in names)
            {
                if (PackageAssemblies.Find(package.Assemblies, name) is string file)
                    loaded.Add(Assembly.LoadFrom(file));
                else
                    findings.Fault($"{Path.Combine(package.Assemblies, name)}.dll is not there: build it first (Headless~/rill does)");
            }
            foreach (AssemblyDefinition adapter in definitions.Where(a => a.IsAdapter))
                try
                {
                    loaded.Add(PlayedPipeline.Load(PipelineVersion.Find("17"), package.Root)[adapter.Name]);
                }
                catch (InvalidOperationException problem)
                {
                    findings.Fault(problem.Message);
                }
            return loaded;
        }
    }
}
