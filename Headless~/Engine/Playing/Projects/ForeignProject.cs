using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Host.Assets;
using Host.Scripts;

namespace Host
{
    /// <summary>A Unity project that the host was not built with: its scene, and its scripts compiled from source.</summary>
    sealed class ForeignProject
    {
        public readonly LocatedScene Scene;
        public readonly ProjectScripts Scripts;

        ForeignProject(LocatedScene scene, ProjectScripts scripts)
        {
            Scene = scene;
            Scripts = scripts;
        }

        /// <param name="scene">Null: the first of the build settings, or the only one.</param>
        /// <exception cref="HostException">The folder is not a project.</exception>
        public static ForeignProject Open(string folder, string scene, bool strict, TextWriter output)
        {
            string root = Path.GetFullPath(folder);
            if (!ProjectFolders.IsProject(root))
                throw new HostException($"--project {folder}: {root} is no Unity project (a folder with Assets and ProjectSettings).");
            LocatedScene located = ProjectScenes.Find(root, scene);
            var index = new ProjectIndex(ignoreCase: !strict);
            foreach (MountedFolder mount in located.Mounts)
                index.Mount(mount);

            var scripts = new ProjectScripts(root, index);
            foreach (string package in scripts.Packages.Missing)
                Console.Error.WriteLine($"warning: the package {package} is not here");
            foreach (string note in scripts.Notes)
                Console.Error.WriteLine("warning: " + note);
            foreach ((string name, int files, int leftOut) in scripts.Compiled)
                output.WriteLine($"{name}: {files - leftOut} of {files} scripts compiled");
            foreach (var file in scripts.LeftOut)
                Console.Error.WriteLine($"left out: {file.Error}");
            return new ForeignProject(located, scripts);
        }

        /// <summary>Prints what the run has shown of the host's limits.</summary>
        /// <returns>1 when a component of the scene was missing, else 0.</returns>
        public int Summarize(Session session, TextWriter output)
        {
            foreach (string unheard in UnheardMessages.Of(Scripts.Assemblies))
                output.WriteLine("never called here: " + unheard);
            foreach (KeyValuePair<string, int> call in Scripts.StubCalls)
                output.WriteLine($"not part of the host: {call.Key}, called {call.Value} times");
            int leftOut = Scripts.LeftOut.Count();
            output.WriteLine($"{Scripts.Compiled.Count()} assemblies, {Scripts.Files - leftOut} scripts compiled, {leftOut} left out, " +
                $"{session.Assets.MissingScripts} components missing, {Scripts.Packages.Missing.Count} packages missing, " +
                $"{session.Assets.Warnings.Count} warnings");
            return session.Assets.MissingScripts > 0 ? 1 : 0;
        }
    }
}
