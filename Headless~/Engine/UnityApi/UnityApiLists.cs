using System;
using System.Collections.Generic;
using System.IO;
using System.IO.Compression;
using System.Linq;

namespace Host.UnityApi
{
    /// <summary>
    /// The public API of the Unity versions that the package supports and of the packages it uses, line by line.
    /// <code>
    /// var lists = UnityApiLists.Load();
    /// foreach (ApiLine line in lists.In("2022.3")) ...        // line.Type, line.Signature, line.Obsolete
    /// </code>
    /// </summary>
    sealed class UnityApiLists
    {
        const string Head = "unity-api 1", Editor = "unity-", Obsolete = " [Obsolete]";

        // Unity's published reference of 2022.3 holds no UIElements; those of 6000.0 stand in.
        const string LentNamespace = "UnityEngine.UIElements.", LentTo = "2022.3", LentFrom = "6000.0";

        /// <summary>Versions of the editor, ascending: "2022.3", "6000.0", "6000.3".</summary>
        public IReadOnlyList<string> Versions { get; }
        /// <summary>Lists that count for every version: "test-framework-1.4", "unity-mathematics".</summary>
        public IReadOnlyList<string> Packages { get; }
        /// <summary>All lines, those of one type together.</summary>
        public IReadOnlyList<ApiLine> Lines { get; }

        UnityApiLists(IReadOnlyList<string> versions, IReadOnlyList<string> packages, IReadOnlyList<ApiLine> lines)
        {
            Versions = versions;
            Packages = packages;
            Lines = lines;
        }

        /// <summary>The bit of a version in <see cref="ApiLine.Versions"/>.</summary>
        public uint Bit(string version)
        {
            int index = Versions.ToList().IndexOf(version);
            if (index < 0)
                throw new ArgumentException($"There is no API list of Unity {version}; there are {string.Join(", ", Versions)}.");
            return 1u << index;
        }

        public IEnumerable<ApiLine> In(string version)
        {
            uint bit = Bit(version);
            return Lines.Where(line => (line.Versions & bit) != 0);
        }

        /// <summary>"2022.3 and 6000.0" for two bits.</summary>
        public string Name(uint versions) => string.Join(", ", Versions.Where((_, i) => (versions >> i & 1) != 0));

        /// <summary>The lists that the host carries.</summary>
        public static UnityApiLists Load()
        {
            using var packed = new StreamReader(new GZipStream(Resource("unity-api.gz"), CompressionMode.Decompress));
            using var supplement = new StreamReader(Resource("supplement.txt"));
            return Read(packed, supplement);
        }

        /// <summary>Lists of packages that not every project has: the render pipelines, where the README beside the file says which version an
        /// editor version ships, and Timeline.</summary>
        public static UnityApiLists LoadOptional()
        {
            using var packed = new StreamReader(new GZipStream(Resource("render-pipelines.gz"), CompressionMode.Decompress));
            using var timeline = new StreamReader(Resource("timeline.txt"));
            return Read(packed, timeline);
        }

        /// <summary>The oldest Unity.Mathematics that a list speaks of.</summary>
        public const string OldestMathematics = "1.2.6";

        /// <summary>These lists with the oldest Unity.Mathematics instead of the newest.</summary>
        public UnityApiLists WithOldestMathematics()
        {
            using var later = new StreamReader(Resource($"mathematics-after-{OldestMathematics}.txt"));
            HashSet<string> added = later.ReadToEnd().Split('\n').ToHashSet();
            return new UnityApiLists(Versions, Packages, Lines.Where(line => !added.Contains($"{line.Type} | {line.Signature}")).ToList());
        }

        static Stream Resource(string name) => typeof(UnityApiLists).Assembly.GetManifestResourceStream(name);

        /// <summary>Reads the output of tools/pack-unity-api: the lists' names, then types, below each its members with the bits of the lists that
        /// hold them.</summary>
        /// <param name="supplement">A list as it is before packing, "type | signature", that counts for every version; or null. Lines that
        /// begin with # say where it is from.</param>
        public static UnityApiLists Read(TextReader text, TextReader supplement = null)
        {
            string head = text.ReadLine() ?? "";
            if (!head.StartsWith(Head + " ", StringComparison.Ordinal))
                throw new InvalidDataException($"The API lists do not start with \"{Head}\" but with \"{head}\": pack them again with " +
                    $"Headless~/Engine/tools/pack-unity-api.");
            string[] lists = head.Substring(Head.Length + 1).Split(' ');
            List<string> versions = lists.Where(IsEditor).Select(list => list.Substring(Editor.Length)).ToList();
            uint every = (1u << versions.Count) - 1;
            uint[] means = lists.Select(list => IsEditor(list) ? 1u << versions.IndexOf(list.Substring(Editor.Length)) : every).ToArray();
            int lentTo = versions.IndexOf(LentTo), lentFrom = versions.IndexOf(LentFrom);

            var lines = new List<ApiLine>(60000);
            string type = null;
            int number = 1;
            for (string line; (line = text.ReadLine()) != null;)
            {
                number++;
                if (line.Length > 0 && line[0] != '\t')
                {
                    type = line;
                    continue;
                }
                string[] parts = line.Split('\t');
                if (parts.Length != 3 || type == null || !uint.TryParse(parts[1], out uint bits) || bits == 0 || bits >> lists.Length != 0)
                    throw new InvalidDataException($"Line {number} of the API lists is neither a type nor bits and a signature: \"{line}\"");
                uint mask = 0;
                for (int i = 0; i < lists.Length; i++)
                    if ((bits >> i & 1) != 0)
                        mask |= means[i];
                if (lentTo >= 0 && lentFrom >= 0 && type.StartsWith(LentNamespace, StringComparison.Ordinal) && (mask >> lentFrom & 1) != 0)
                    mask |= 1u << lentTo;
                lines.Add(Line(type, parts[2], mask));
            }
            for (string line; (line = supplement?.ReadLine()) != null;)
            {
                if (line.StartsWith('#'))
                    continue;
                int bar = line.IndexOf(" | ", StringComparison.Ordinal);
                if (bar < 0)
                    throw new InvalidDataException($"A line of the supplement to the API lists is not \"type | signature\": \"{line}\"");
                lines.Add(Line(line.Substring(0, bar), line.Substring(bar + 3), every));
            }
            return new UnityApiLists(versions, lists.Where(list => !IsEditor(list)).ToList(), lines);
        }

        static ApiLine Line(string type, string signature, uint versions)
        {
            bool obsolete = signature.EndsWith(Obsolete, StringComparison.Ordinal);
            return new ApiLine(type, obsolete ? signature.Substring(0, signature.Length - Obsolete.Length) : signature, obsolete, versions);
        }

        static bool IsEditor(string list) => list.StartsWith(Editor, StringComparison.Ordinal) && list.Length > Editor.Length
            && char.IsDigit(list[Editor.Length]);
    }
}
