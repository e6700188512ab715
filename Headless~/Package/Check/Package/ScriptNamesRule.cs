using System;
using System.IO;
using System.Linq;
using System.Reflection;
using UnityEngine;

namespace Host.Check
{
    /// <summary>Unity finds a component or asset class by the name of its file.</summary>
    sealed class ScriptNamesRule : Rule
    {
        public override string Name => "package: component classes are named as their files";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            int classes = 0;
            foreach (Type type in PackageScripts.Load(package, findings).SelectMany(assembly => assembly.GetTypes())
                .Where(t => !t.IsNested && (typeof(MonoBehaviour).IsAssignableFrom(t) || typeof(ScriptableObject).IsAssignableFrom(t))))
            {
                classes++;
                string assembly = type.Assembly.GetName().Name;
                if (type.IsGenericType || !package.Visible.Concat(package.Files.Where(f => f.StartsWith("Samples~/",
                    StringComparison.Ordinal))).Any(f => Path.GetFileName(f) == type.Name + ".cs"))
                    findings.Fault($"{type.FullName} of {assembly} lies in no file {type.Name}.cs: Unity would not find it, and scenes " +
                        $"that use it would lose it");
            }
            findings.Looked = $"{classes} classes";
            return findings;
        }
    }
}
