using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace Host.Scripts.Compiling
{
    /// <summary>A script that does not compile against the host, with the first thing that the compiler says of it.</summary>
    internal sealed record LeftOutFile(string Path, string Error)
    {
        /// <summary>For want of something in the host that Unity has, or because of such a file.</summary>
        public bool IsGap => Error.EndsWith(Hints.HostLacksIt, System.StringComparison.Ordinal)
            || Error.EndsWith(BecauseOfAnother, System.StringComparison.Ordinal);

        public const string BecauseOfAnother = ", which is left out)";

        public override string ToString() => Error;
    }

    /// <summary>An assembly of the project on disk, and which of its scripts are not in it.</summary>
    internal sealed class CompiledAssembly
    {
        const string List = "left-out.txt";

        public readonly string Name, File, Key;
        public readonly int Scripts;
        public readonly IReadOnlyList<LeftOutFile> LeftOut;

        CompiledAssembly(string name, string folder, string key, int scripts)
        {
            Name = name;
            Key = key;
            Scripts = scripts;
            File = Path.Combine(folder, name + ".dll");
            LeftOut = System.IO.File.ReadAllLines(Path.Combine(folder, List)).Select(line => line.Split('\t'))
                .Select(parts => new LeftOutFile(parts[0], parts[1])).ToList();
        }

        public static CompiledAssembly In(string folder, string name, string key, int scripts) => new CompiledAssembly(name, folder, key, scripts);

        public static void WriteLeftOut(string folder, IEnumerable<LeftOutFile> files) =>
            System.IO.File.WriteAllLines(Path.Combine(folder, List),
            files.Select(f => f.Path + "\t" + f.Error.Replace('\t', ' ').Replace('\n', ' ')));
    }
}
