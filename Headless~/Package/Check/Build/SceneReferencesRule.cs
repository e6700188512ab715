using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Host.Assets;
using UnityEngine.Headless;
using UnityEngine.SceneManagement;
using Object = UnityEngine.Object;

namespace Host.Check.Build
{
    /// <summary>A sample's scene is stored as a build of it would be: its components refer to the stages that they use, to all of them and
    /// to no others.</summary>
    sealed class SceneReferencesRule : Rule
    {
        public override string Name => "build: scenes refer to exactly the assets that a build of them needs";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            List<Assembly> scripts = PackageScripts.Load(package, findings);
            IAssetSource before = Player.Assets;
            Action<LogEntry> writer = LogSink.Writer;
            LogSink.Writer = _ => { };
            var project = new ProjectAssets(ProjectView.Mounts(package), scripts, strict: false);
            Player.Assets = project;
            int scenes = 0;
            try
            {
                foreach (AssetEntry scene in project.Index.Entries.Where(entry => entry.Extension == ".unity").ToList())
                {
                    scenes++;
                    foreach (ChangedReferences changed in BuiltScene.Process(project, scene, scripts))
                        findings.Fault($"{scene.Path}: {changed.Component.GetType().Name} '{changed.Component.name}' refers to " +
                            $"{Names(changed.Before)} in {string.Join(".", changed.Path)}, and a build to {Names(changed.After)}: run " +
                            $"Headless~/rill references --write");
                }
            }
            catch (AssetException e)
            {
                findings.Fault(e.Message);
            }
            finally
            {
                SceneManager.UnloadEverything();
                project.ReloadAll();
                Player.Assets = before;
                LogSink.Writer = writer;
            }
            findings.Looked = $"{scenes} scenes";
            return findings;
        }

        static string Names(Object[] assets) => assets.Length == 0 ? "nothing"
            : string.Join(", ", assets.Select(asset => asset == null ? "what is not there" : asset.name));
    }
}
