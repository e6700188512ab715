using System;
using System.IO;
using System.Security.Cryptography;
using System.Text;

namespace Host.Scripts
{
    /// <summary>Compiled scripts and stubs on disk, below the same folder as compiled shaders: a folder each, named by the hash of all that
    /// went into it.</summary>
    internal static class ScriptCache
    {
        static string root;

        static string Root
        {
            get
            {
                if (root != null) return root;
                var named = Environment.GetEnvironmentVariable("RILL_CACHE");
                if (string.IsNullOrEmpty(named)) named = Path.Combine(Path.GetTempPath(), "rill-cache");
                return root = Path.Combine(named, "scripts");
            }
        }

        public static string Key(params string[] parts)
        {
            var all = new StringBuilder();
            foreach (var part in parts) all.Append(part.Length).Append(':').Append(part);
            return Convert.ToHexString(SHA256.HashData(Encoding.UTF8.GetBytes(all.ToString())), 0, 16).ToLowerInvariant();
        }

        /// <summary>The folder of what was made before; made now when there is none. Any number of processes may ask at once.</summary>
        /// <param name="make">Writes the files into the folder that it is given.</param>
        public static string Folder(string name, string key, Action<string> make)
        {
            var folder = Path.Combine(Root, name + "-" + key);
            if (Directory.Exists(folder)) return folder;
            // Whoever looks meanwhile sees the whole folder or none.
            var partial = folder + "." + Guid.NewGuid().ToString("N");
            Directory.CreateDirectory(partial);
            try
            {
                make(partial);
                Directory.Move(partial, folder);
            }
            catch (IOException) when (Directory.Exists(folder))
            {
                // Another process was faster with the same.
            }
            finally
            {
                if (Directory.Exists(partial)) Directory.Delete(partial, true);
            }
            return folder;
        }
    }
}
