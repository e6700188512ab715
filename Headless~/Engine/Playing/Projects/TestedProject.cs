using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using Host.Assets;
using Host.Scripts;
using Host.Scripts.Assemblies;
using Host.Scripts.Compiling;

namespace Host
{
    /// <summary>A Unity project whose tests are run: its scripts, compiled from source as the Editor's Test Runner has them.</summary>
    sealed class TestedProject
    {
        const int MaxShownErrors = 20;

        public string Root { get; private init; }
        public List<MountedFolder> Mounts { get; private init; }
        public ProjectScripts Scripts { get; private init; }

        /// <summary>With a test each, at least.</summary>
        public List<Assembly> Tests { get; private init; }

        /// <exception cref="HostException">The folder is not a project, it has no tests, or its scripts do not compile.</exception>
        public static TestedProject Open(string folder, bool strict, TextWriter output)
        {
            string root = Path.GetFullPath(folder);
            if (!ProjectFolders.IsProject(root))
                throw new HostException($"--project {folder}: {root} is no Unity project (a folder with Assets and ProjectSettings).");
            List<MountedFolder> mounts = ProjectFolders.Of(root);
            var index = new ProjectIndex(ignoreCase: !strict);
            foreach (MountedFolder mount in mounts)
                index.Mount(mount);

            var scripts = new ProjectScripts(root, index,
                new TestAssemblies(typeof(UnityEditor.Editor).Assembly, typeof(UnityEngine.TestTools.UnityTestAttribute).Assembly,
                typeof(NUnit.Framework.Assert).Assembly));
            foreach (string note in scripts.Notes)
                Console.Error.WriteLine("warning: " + note);
            foreach ((string name, int files, int leftOut) in scripts.Compiled)
                output.WriteLine($"{name}: {files - leftOut} of {files} scripts compiled");
            RefuseErrors(scripts);
            if (scripts.Packages.Missing.Count > 0)
                Console.Error.WriteLine("warning: " + WhatIsMissing(scripts.Packages.Missing));

            List<Assembly> tests = scripts.Tests.ToList();
            if (tests.Count == 0)
                throw new HostException($"{root} has no test assembly: make one in Unity by Assets > Create > Testing > Tests Assembly " +
                    $"Folder, or name a package with tests in \"testables\" of Packages/manifest.json.");
            return new TestedProject { Root = root, Mounts = mounts, Scripts = scripts, Tests = tests };
        }

        // Members that the host lacks must not remove the whole project, but a test that is left out must not look as if it had passed.
        static void RefuseErrors(ProjectScripts scripts)
        {
            var errors = new List<string>();
            foreach ((ScriptAssembly assembly, LeftOutFile file) in scripts.LeftOutOf)
                if (!assembly.HoldsTests && (assembly.IsEditorOnly || file.IsGap))
                    Console.Error.WriteLine($"warning: left out: {file.Error}");
                else
                    errors.Add(file.Error);
            if (errors.Count == 0)
                return;
            string more = errors.Count > MaxShownErrors ? $"\nand {errors.Count - MaxShownErrors} more" : "",
                missing = scripts.Packages.Missing.Count > 0 ? "\n" + WhatIsMissing(scripts.Packages.Missing) : "";
            throw new HostException($"the project's scripts do not compile:\n{string.Join("\n", errors.Take(MaxShownErrors))}{more}{missing}");
        }

        static string WhatIsMissing(List<string> packages) =>
            $"packages that are not here: {string.Join(", ", packages)}. Where scripts need one, put it into the project's Packages " +
            $"folder, refer to it by \"file:<folder>\" in Packages/manifest.json, or open the project in Unity once, which leaves it " +
            $"in Library/PackageCache.";
    }
}
