using System;
using System.IO;
using System.Security.Cryptography;
using System.Text;
using System.Text.Json;

namespace Host.Shaders
{
    /// <summary>
    /// Compiled programs on disk, a file each, named by the hash of all that went into it. Any number of threads and
    /// processes may use one folder.
    /// </summary>
    internal sealed class ShaderCache
    {
        static readonly JsonSerializerOptions Format = new JsonSerializerOptions { IncludeFields = true };

        readonly string folder;

        /// <param name="folder">Null: the environment's RILL_CACHE, else .cache/shaders in the Headless~ folder that holds this program.</param>
        public ShaderCache(string folder = null)
        {
            this.folder = folder ?? DefaultFolder();
            Directory.CreateDirectory(this.folder);
        }

        public static string DefaultFolder()
        {
            string named = Environment.GetEnvironmentVariable("RILL_CACHE");
            if (!string.IsNullOrEmpty(named))
                return named;
            for (DirectoryInfo up = new DirectoryInfo(AppContext.BaseDirectory); up != null; up = up.Parent)
                if (up.Name == "Headless~")
                    return Path.Combine(up.FullName, ".cache", "shaders");
            return Path.Combine(Path.GetTempPath(), "rill-shaders");    // built elsewhere
        }

        public static string Key(params string[] parts)
        {
            var all = new StringBuilder();
            foreach (string part in parts)
                all.Append(part.Length).Append(':').Append(part);
            return Convert.ToHexString(SHA256.HashData(Encoding.UTF8.GetBytes(all.ToString())));
        }

        /// <summary>Null when it is not there.</summary>
        public CompiledProgram Find(string key)
        {
            string path = PathOf(key);
            try
            {
                return File.Exists(path) ? JsonSerializer.Deserialize<CompiledProgram>(File.ReadAllBytes(path), Format) : null;
            }
            catch (JsonException)
            {
                return null;    // a file that a full disk cut short: compiled and written again
            }
        }

        public void Store(string key, CompiledProgram program)
        {
            // Whoever looks meanwhile sees the whole file or none.
            string partial = PathOf(key) + "." + Guid.NewGuid().ToString("N");
            File.WriteAllBytes(partial, JsonSerializer.SerializeToUtf8Bytes(program, Format));
            File.Move(partial, PathOf(key), overwrite: true);
        }

        string PathOf(string key) => Path.Combine(folder, key + ".json");
    }
}
