using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace Host.UnityApi
{
    /// <summary>Which built-in module or package brings a type of Unity's into a project: data/unity-api/modules.txt.</summary>
    sealed class UnityModules
    {
        const string AlwaysThere = "-";

        readonly Dictionary<string, (string Assembly, string Package)> types = new();

        /// <summary>The list that the host carries.</summary>
        public static UnityModules Load()
        {
            using var text = new StreamReader(typeof(UnityModules).Assembly.GetManifestResourceStream("modules.txt")
                ?? throw new InvalidOperationException("modules.txt is not in the assembly"));
            return Read(text);
        }

        /// <exception cref="InvalidDataException">A line that says nothing, or a type that stands in two assemblies.</exception>
        public static UnityModules Read(TextReader text)
        {
            var modules = new UnityModules();
            (string Assembly, string Package) at = default;
            int number = 0;
            while (text.ReadLine() is { } line)
            {
                number++;
                if (line.Length == 0 || line[0] == '#')
                    continue;
                if (line[0] != '\t')
                {
                    string[] words = line.Split(' ');
                    at = words.Length == 2 ? (words[0], words[1])
                        : throw new InvalidDataException($"modules.txt({number}): \"{line}\" is not of the form \"assembly package\"");
                }
                else if (at.Assembly == null || !modules.types.TryAdd(line.Substring(1), at))
                    throw new InvalidDataException($"modules.txt({number}): {line.Substring(1)} stands below no assembly, or below two");
            }
            return modules;
        }

        /// <summary>The assembly and the package that brings it, null where it is always there. False for a type that the list lacks.</summary>
        public bool TryFind(ApiTypeName type, out string assembly, out string package)
        {
            assembly = package = null;
            // A nested type is where the one around it is.
            for (int parts = type.Path.Count; parts > 0; parts--)
                if (types.TryGetValue(string.Join('.', type.Path.Take(parts)), out (string Assembly, string Package) found))
                {
                    assembly = found.Assembly;
                    package = found.Package == AlwaysThere ? null : found.Package;
                    return true;
                }
            return false;
        }
    }
}
