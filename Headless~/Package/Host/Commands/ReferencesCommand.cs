using System;
using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Linq;
using System.Reflection;
using Host.Assets;
using Host.Baking;
using Host.Check;
using Host.Check.Build;
using UnityEngine.Headless;
using UnityEngine.SceneManagement;
using Object = UnityEngine.Object;

namespace Host.Commands
{
    /// <summary><c>references</c>: what the package's build steps change in its sample scenes, and with --write, the scenes with those
    /// changes.</summary>
    static class ReferencesCommand
    {
        public static Command Create()
        {
            var write = new Option<bool>("--write") { Description = "Store the changes in the scenes." };
            var command = new Command("references", "Compares the references of the sample scenes with those of a build.") { write };
            command.SetAction(parsed => Execute(new PackageTree(Session.Root()), parsed.GetValue(write), Console.Out));
            return command;
        }

        internal static int Execute(PackageTree package, bool write, TextWriter output)
        {
            var findings = new Findings();
            List<Assembly> scripts = PackageScripts.Load(package, findings);
            if (findings.Faults.Count > 0)
                throw new HostException(findings.Faults[0]);
            IAssetSource before = Player.Assets;
            var project = new ProjectAssets(ProjectView.Mounts(package), scripts, strict: true);
            Player.Assets = project;
            int changes = 0;
            try
            {
                foreach (AssetEntry scene in project.Index.Entries.Where(entry => entry.Extension == ".unity").ToList())
                {
                    string text = File.ReadAllText(scene.File), stored = text;
                    foreach (ChangedReferences changed in BuiltScene.Process(project, scene, scripts))
                    {
                        changes++;
                        output.WriteLine($"{scene.Path}: {changed.Component.GetType().Name} '{changed.Component.name}': " +
                            $"{string.Join(", ", changed.After.Select(asset => asset.name))}");
                        text = With(project, scene, text, changed);
                    }
                    if (write && text != stored)
                        File.WriteAllText(scene.File, text);
                }
            }
            finally
            {
                SceneManager.UnloadEverything();
                project.ReloadAll();
                Player.Assets = before;
            }
            output.WriteLine(changes == 0 ? "every scene refers to what a build of it needs"
                : $"{changes} components differ from their build{(write ? "; now stored" : "; --write stores it")}");
            return changes == 0 || write ? 0 : 1;
        }

        static string With(ProjectAssets project, AssetEntry scene, string text, ChangedReferences changed)
        {
            if (changed.Path.Length != 2)
                throw new HostException($"{scene.Path}: {string.Join(".", changed.Path)} of {changed.Component.GetType().Name} is no " +
                    $"list in a field of the component, and only such are written.");
            long id = project.FileIdIn(scene.Path, changed.Component);
            return SceneText.WithReferences(text, id, changed.Path[0], changed.Path[1],
                changed.After.Select(asset => Reference(project, asset)).ToList())
                ?? throw new HostException(
                    $"{scene.Path}: {changed.Component.GetType().Name} '{changed.Component.name}' comes from a prefab: change that.");
        }

        static string Reference(ProjectAssets project, Object asset) => project.TryIdentify(asset, out _, out string guid, out long id)
            ? $"{{fileID: {id}, guid: {guid}, type: 2}}" : throw new HostException($"'{asset.name}' is in no file.");
    }
}
